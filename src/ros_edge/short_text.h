// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace collision_monitor {

/// A number as short as it can be said: "-1e+17".
std::string shortText(double number);

}  // namespace collision_monitor
