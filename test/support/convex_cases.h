// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "collision_monitor/narrow_phase/convex_distance.h"
#include "support/expect_distance.h"
#include "support/random_pairs.h"

/// Random pairs of convex geometries, and proofs of answers about them. The same seed gives the
/// same pairs.
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

/// Geometries of one kind, made once because hulls are slow to build. Sizes are log-uniform between
/// the bounds [m]. `with_degenerate` adds flat, needle-thin and zero-size ones.
struct ConvexPoolRecipe {
  double least_length{1e-3};
  double greatest_length{5.0};
  bool with_degenerate{false};
};
std::vector<ConvexGeometry> makeConvexPool(ConvexKind kind, std::size_t count,
                                           const ConvexPoolRecipe& recipe, Random& random);

/// Two such geometries, placed.
struct PosedConvexPair {
  const ConvexGeometry* a{nullptr};
  Pose world_from_a;
  const ConvexGeometry* b{nullptr};
  Pose world_from_b;
};

/// A's pose is random. B's pose brings the pair as near as asked for. The tested routine itself
/// moves it there: the tests check the result later, by other means.
PosedConvexPair placeConvexPair(const ConvexGeometry& a, const ConvexGeometry& b, Nearness nearness,
                                Alignment alignment, Random& random);

/// Text that pastes into a test.
std::string describe(const PosedConvexPair& pair);

/// Bounds of an answer that need no other algorithm: from the geometries alone, with 64-bit
/// mantissas.
struct ConvexCertificate {
  /// Gap of the projections of both geometries on the normal. No two points are nearer than this,
  /// and a translation by its negative separates: a lower bound in both cases.
  double gap_along_normal{0.0};
  /// How far the witness points are outside their geometries, <= 0 inside.
  double a_outside{0.0};
  double b_outside{0.0};
};
ConvexCertificate certify(const PosedConvexPair& pair, const SignedDistance& found);

/// The greatest projection of a placed geometry on a direction; infinite for a half space that is
/// not perpendicular to it.
long double extendedReach(const ConvexGeometry& geometry, const Pose& world_from_body,
                          const Eigen::Matrix<long double, 3, 1>& direction);

/// A bounding radius of the geometry, in doubles, over all vertices.
double extentOf(const ConvexGeometry& geometry);

}  // namespace collision_monitor::test
