// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace collision_monitor {

/// Indexed triangles. They are counter-clockwise seen from outside where the mesh is closed. Code
/// that relies on this says so.
///
/// Shape: `vertices` n x 3 [m], `triangles` m x 3 indices into `vertices`.
struct TriangleMesh {
  std::vector<Eigen::Vector3d> vertices;                ///< n points [m]
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< m times three vertices
};

}  // namespace collision_monitor
