// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/pipeline/element.h"
#include "collision_monitor/solid.h"

namespace collision_monitor {

/// What the copies of a Solid share.
struct SolidParts {
  Element element;  ///< of no link
};

}  // namespace collision_monitor
