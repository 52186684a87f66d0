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

/// Gap of the two shapes along each unit axis, negative if their projections overlap. Minus
/// infinity for an axis that does not exist (parallel edges).
///
/// The largest is a lower bound of the distance and, if negative, minus the penetration depth.
/// Error: a few ulps of the lengths, at every angle of the edges.
/// Source: Gottschalk, Lin, Manocha, "OBBTree" (1996), section 5. Departure: the edge axes have
/// unit length. Their products with B's axes come from nine shared 2 x 2 minors of the rotation,
/// not from its entries. The two are equal only up to an ulp, which division by a small sine would
/// blow up.
struct Separations {
  std::array<double, kAxisCount> along;
  double largest;
};

Separations separationsOfBoxes(const BoxPair& pair) noexcept;

/// The same if B is a segment along its z axis (half_b.x = half_b.y = 0), which has six axes.
Separations separationsOfBoxAndSegment(const BoxPair& pair) noexcept;

/// Unit direction of an axis, in A's frame, from A to B.
Eigen::Vector3d axisDirection(const BoxPair& pair, std::size_t axis) noexcept;

}  // namespace collision_monitor
