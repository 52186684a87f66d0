// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "support/convex_cases.h"

/// What the parts of the slow reference share; see convex_reference.h.
namespace collision_monitor::test {

using Real = long double;
using Vector = Eigen::Matrix<Real, 3, 1>;

/// The core of a geometry, placed, with every feature it has.
struct Polyhedron {
  std::vector<Vector> points;
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  Real radius{0};
};

/// @pre the geometry is neither a cylinder nor a half space.
Polyhedron polyhedronOf(const ConvexGeometry& geometry, const Pose& pose);

/// Outward, twice the area long.
Vector normalOf(const Polyhedron& p, const std::array<std::uint32_t, 3>& t);

/// A pair with a cylinder.
Real cylinderReference(const PosedConvexPair& pair);

}  // namespace collision_monitor::test
