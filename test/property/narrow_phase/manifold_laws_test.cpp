// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "narrow_phase/contact/manifold.h"
#include "narrow_phase/distance.h"
#include "support/fixed_seed.h"
#include "support/random_pairs.h"

namespace collision_monitor::test {
namespace {

constexpr double kRounding = 1e-12;

struct Touching {
  ShapePair pair;
  SignedDistance measured;
  ContactManifold manifold;
};

Touching touch(const ShapePair& pair) {
  const SignedDistance measured =
      distanceBetween(pair.a, pair.world_from_a, pair.b, pair.world_from_b);
  return {pair, measured,
          manifoldBetween(pair.a, pair.world_from_a, pair.b, pair.world_from_b, measured)};
}

template <class Check>
void forManyPairs(const Check& check) {
  Random random(kSeed);
  for (const ShapeKind a : kShapeKinds) {
    for (const ShapeKind b : kShapeKinds) {
      for (const Nearness nearness : kNearnesses) {
        for (const Alignment alignment : kAlignments) {
          for (int i = 0; i < 60 && !testing::Test::HasFailure(); ++i) {
            const Touching found =
                touch(randomPair({a, b, nearness, alignment, 0.01, 0.5, true}, random));
            SCOPED_TRACE(describe(found.pair));
            check(found);
          }
        }
      }
    }
  }
}

TEST(ManifoldLaws, onePointToFour_noneNearerThanMeasuredAndOneAsNear) {
  forManyPairs([](const Touching& found) {
    ASSERT_GE(found.manifold.size, 1U);
    ASSERT_LE(found.manifold.size, ContactManifold::kMaxPoints);
    double nearest = found.manifold.points[0].distance;
    for (std::size_t i = 0; i < found.manifold.size; ++i) {
      const ManifoldPoint& point = found.manifold.points[i];
      ASSERT_TRUE(point.point_on_a.allFinite() && point.point_on_b.allFinite());
      ASSERT_GE(point.distance, found.measured.distance - kRounding);
      ASSERT_LE(point.distance, found.measured.distance + kPatchDepth);
      nearest = std::min(nearest, point.distance);
    }
    ASSERT_LE(found.manifold.center.distance, found.measured.distance + kPatchDepth + kRounding);
    ASSERT_GE(found.manifold.center.distance, nearest - kRounding);
  });
}

TEST(ManifoldLaws, points_lieInTheirShapesAndWithinTheDepthOfTheOther) {
  forManyPairs([](const Touching& found) {
    for (std::size_t i = 0; i < found.manifold.size; ++i) {
      const ManifoldPoint& point = found.manifold.points[i];
      const Eigen::Vector3d in_a = inverse(found.pair.world_from_a) * point.point_on_a;
      const Eigen::Vector3d in_b = inverse(found.pair.world_from_b) * point.point_on_b;
      ASSERT_LE(signedDistanceTo(found.pair.a, in_a), kRounding);
      ASSERT_LE(signedDistanceTo(found.pair.b, in_b), kRounding);
      // Edges that are nearly parallel may miss each other sideways by what their slant makes.
      const Eigen::Vector3d between = point.point_on_b - point.point_on_a;
      const Eigen::Vector3d sideways = between - point.distance * found.manifold.normal_a_to_b;
      ASSERT_LE(sideways.norm(), 1e-4);
    }
  });
}

TEST(ManifoldLaws, swapped_isTheSameContact) {
  forManyPairs([](const Touching& found) {
    SignedDistance measured = found.measured;
    std::swap(measured.point_on_a, measured.point_on_b);
    measured.normal_a_to_b = -measured.normal_a_to_b;
    const ShapePair& pair = found.pair;
    const ContactManifold other =
        manifoldBetween(pair.b, pair.world_from_b, pair.a, pair.world_from_a, measured);
    ASSERT_EQ(other.normal_a_to_b, -found.manifold.normal_a_to_b);
    ASSERT_EQ(other.feature, found.manifold.feature);
    ASSERT_EQ(other.size, found.manifold.size);
  });
}

}  // namespace
}  // namespace collision_monitor::test
