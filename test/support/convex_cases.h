// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "collision_monitor/narrow_phase/convex_distance.h"
#include "support/expect_distance.h"
#include "support/random_pairs.h"

/// Random pairs of convex geometries, and what proves an answer about them. The same seed gives
/// the same pairs.
namespace collision_monitor::test {

enum class ConvexKind : unsigned char {
  sphere,
  capsule,
  box,
  rounded_box,
  cylinder,
  hull,
  half_space
};

constexpr ConvexKind kConvexKinds[] = {
    ConvexKind::sphere,   ConvexKind::capsule, ConvexKind::box,       ConvexKind::rounded_box,
    ConvexKind::cylinder, ConvexKind::hull,    ConvexKind::half_space};

const char* nameOf(ConvexKind kind) noexcept;

/// Geometries of one kind, made once since hulls are slow to make. Sizes are even in their
/// logarithm between the bounds [m]. `with_degenerate` mixes in flat, needle-thin and zero-size
/// ones.
struct ConvexPoolRecipe {
  double least_length{1e-3};
  double greatest_length{5.0};
  bool with_degenerate{false};
};
std::vector<ConvexGeometry> makeConvexPool(ConvexKind kind, std::size_t count,
                                           const ConvexPoolRecipe& recipe, Random& random);

/// Two of such geometries, placed.
struct PosedConvexPair {
  const ConvexGeometry* a{nullptr};
  Pose world_from_a;
  const ConvexGeometry* b{nullptr};
  Pose world_from_b;
};

/// A's pose is random; B's is such that the pair is as near as asked for. The routine under test
/// itself moves them there: what is checked is checked afterwards, by other means.
PosedConvexPair placeConvexPair(const ConvexGeometry& a, const ConvexGeometry& b, Nearness nearness,
                                Alignment alignment, Random& random);

/// In words that paste into a test.
std::string describe(const PosedConvexPair& pair);

/// What an answer can be held to without another algorithm, in 64-bit mantissas, from the
/// geometries alone.
struct ConvexCertificate {
  /// Gap of both geometries' projections on the normal. No two points are nearer than this, and
  /// minus this is a translation that separates: a proof from below in either case.
  double gap_along_normal{0.0};
  /// How far the witness points are outside of their geometries, <= 0 inside.
  double a_outside{0.0};
  double b_outside{0.0};
};
ConvexCertificate certify(const PosedConvexPair& pair, const SignedDistance& found);

/// The farthest reach of a placed geometry along a direction; infinite for a half space that is
/// not perpendicular to it.
long double extendedReach(const ConvexGeometry& geometry, const Pose& world_from_body,
                          const Eigen::Matrix<long double, 3, 1>& direction);

/// The same by plain double arithmetic, over all vertices: radius that holds a geometry.
double extentOf(const ConvexGeometry& geometry);

}  // namespace collision_monitor::test
