// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "collision_monitor/geometry/triangle_mesh.h"

namespace collision_monitor {

/// Whether a triangle is a line within the precision of its numbers, or a point. Its normal is
/// noise.
bool hasNoArea(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
               const Eigen::Vector3d& c) noexcept;

/// Adds triangles without area to a mesh: as {a, b, b} for a segment, {a, a, a} for a point. These
/// have no sides, so a closed surface stays closed. Those that edges of other triangles hold are
/// left out.
/// @param flat corners, for which hasNoArea
/// @pre equal vertices are merged
void addFlatTriangles(std::vector<std::array<std::uint32_t, 3>> flat, TriangleMesh& mesh);

/// Whether all triangles are segments or points from addFlatTriangles.
bool areAllFlat(const TriangleMesh& mesh) noexcept;

}  // namespace collision_monitor
