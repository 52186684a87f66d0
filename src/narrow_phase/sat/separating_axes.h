// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "narrow_phase/sat/box_pair.h"

/// The separating axis test of two boxes, and what the axes say about the closest features.
namespace collision_monitor {

constexpr std::size_t kAxisCount = 15;
constexpr std::size_t kFirstFaceOfB = 3;
constexpr std::size_t kFirstEdgePair = 6;  ///< axis i of A crossed with axis j of B: 6 + 3 i + j

/// Gap of the two shapes along each unit axis, negative where their projections overlap; minus
/// infinity for an axis that does not exist (parallel edges).
///
/// The largest is a lower bound of the distance and, if negative, minus the penetration depth.
/// Error: some ulps of the lengths involved, at every angle of the edges.
/// Source: Gottschalk, Lin, Manocha, "OBBTree" (1996), section 5. Departs from it in the
/// edge axes: they are of unit length, and their products with B's axes come from nine shared
/// 2 x 2 minors of the rotation instead of from its entries, since the identity between the two
/// holds only up to an ulp, which division by a small sine would blow up.
struct Separations {
  std::array<double, kAxisCount> along;
  double largest;
};

Separations separationsOfBoxes(const BoxPair& pair) noexcept;

/// As above when B is a segment along its z axis (half_b.x = half_b.y = 0): six axes do.
Separations separationsOfBoxAndSegment(const BoxPair& pair) noexcept;

/// Unit direction of an axis, in A's frame, from A to B.
Eigen::Vector3d axisDirection(const BoxPair& pair, std::size_t axis) noexcept;

}  // namespace collision_monitor
