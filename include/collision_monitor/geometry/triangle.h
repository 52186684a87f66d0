// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>

namespace collision_monitor {

/// Three corners, [m]. Triangles without area (segments, points) are legal everywhere.
using Triangle = std::array<Eigen::Vector3d, 3>;

}  // namespace collision_monitor
