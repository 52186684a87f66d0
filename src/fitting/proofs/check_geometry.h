// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/geometry/geometry.h"

namespace collision_monitor {

/// @throws std::invalid_argument with a sentence that names the dimension or vertex: a length that
/// is negative or not finite, a length or coordinate beyond 1e100 (whose cube would not be finite),
/// no vertices, a triangle with a missing vertex.
void checkGeometry(const Geometry& geometry);

}  // namespace collision_monitor
