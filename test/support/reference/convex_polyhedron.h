// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "support/convex_cases.h"

/// Shared by the parts of the slow reference; see convex_reference.h.
namespace collision_monitor::test {

using Real = long double;
using Vector = Eigen::Matrix<Real, 3, 1>;

/// The placed core of a geometry, with all its features.
struct Polyhedron {
  std::vector<Vector> points;
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  Real radius{0};
};

/// @pre the geometry is neither a cylinder nor a half space.
Polyhedron polyhedronOf(const ConvexGeometry& geometry, const Pose& pose);

/// Outward; its length is twice the area.
Vector normalOf(const Polyhedron& p, const std::array<std::uint32_t, 3>& t);

/// For a pair with a cylinder.
Real cylinderReference(const PosedConvexPair& pair);

}  // namespace collision_monitor::test
