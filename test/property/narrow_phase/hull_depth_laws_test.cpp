// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "collision_monitor/narrow_phase/convex_distance.h"
#include "narrow_phase/epa/epa.h"
#include "narrow_phase/gjk/convex_core.h"
#include "narrow_phase/gjk/gjk.h"
#include "narrow_phase/sat/hull_depth.h"
#include "support/fixed_seed.h"
#include "support/random_poses.h"

// Depths by separating axes against every axis there is, in 64-bit mantissas and without a look at
// the Gauss map, and against EPA. Errors are relative to the size of a pair.
namespace collision_monitor::test {
namespace {

using Eigen::Vector3d;
using Extended = Eigen::Matrix<long double, 3, 1>;

// Boxes, prisms and hulls of a few points: thick, flat and needle-like, about their origin or off
// it.
ConvexHull randomHull(Random& random, int kind) {
  const double size = std::pow(10.0, uniform(random, -2.0, 0.5));
  const double least = kind % 2 == 0 ? -1.0 : -4.0;
  const Vector3d scale(size, size * std::pow(10.0, uniform(random, least, 0.0)),
                       size * std::pow(10.0, uniform(random, least, 0.0)));
  const Vector3d offset = kind % 3 == 0 ? randomPoint(random, size) : Vector3d::Zero();
  std::vector<Vector3d> points;
  const int sides = 3 + kind / 4 % 3;
  for (int i = 0; i < 2 * sides; ++i) {
    const int side = i / 2;
    const double turn = 2.0 * M_PI * side / sides;
    const Vector3d corner = kind % 4 == 0
                                ? Vector3d(std::cos(turn), std::sin(turn), i % 2 == 0 ? -1.0 : 1.0)
                                : randomPoint(random, 1.0);
    points.push_back(offset + corner.cwiseProduct(scale));
  }
  return ConvexHull(points);
}

// Any rotation, quarter turns, and angles down to where edges pass for parallel.
Eigen::Matrix3d randomTurn(Random& random, int kind) {
  const Vector3d axis =
      kind % 2 == 0 ? Vector3d::Unit(kind / 2 % 3) : randomPoint(random, 1.0).normalized();
  const double angle = kind % 3 == 0   ? 0.5 * M_PI * (kind % 4)
                       : kind % 3 == 1 ? std::pow(10.0, uniform(random, -14.0, 0.0))
                                       : uniform(random, -M_PI, M_PI);
  return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
}

long double gapAlong(const Extended& direction, const ConvexPair& pair) {
  long double reach_of_a = -std::numeric_limits<long double>::infinity();
  long double reach_of_b = -reach_of_a;
  for (const Vector3d& vertex : pair.a.hull->vertices()) {
    reach_of_a = std::max(reach_of_a, direction.dot(vertex.cast<long double>()));
  }
  for (const Vector3d& vertex : pair.b.hull->vertices()) {
    const Extended in_a = pair.a_from_b.rotation.cast<long double>() * vertex.cast<long double>() +
                          pair.a_from_b.translation.cast<long double>();
    reach_of_b = std::min(reach_of_b, direction.dot(in_a));
  }
  return reach_of_b - reach_of_a;
}

// Of all faces and all pairs of edges, crossing on the Gauss map or not.
long double mostSeparated(const ConvexPair& pair) {
  const Eigen::Matrix<long double, 3, 3> turn = pair.a_from_b.rotation.cast<long double>();
  const auto edgeOf = [](const ConvexHull& hull, const ConvexHull::Edge& edge) -> Extended {
    return (hull.vertices()[edge.to] - hull.vertices()[edge.from]).cast<long double>();
  };
  long double most = -std::numeric_limits<long double>::infinity();
  const auto look = [&](const Extended& direction) {
    most = std::max(most, gapAlong(direction / direction.norm(), pair));
  };
  for (const ConvexHull::Face& face : pair.a.hull->faces()) {
    look(face.normal.cast<long double>());
  }
  for (const ConvexHull::Face& face : pair.b.hull->faces()) {
    look(-(turn * face.normal.cast<long double>()));
  }
  for (const ConvexHull::Edge& of_a : pair.a.hull->edges()) {
    for (const ConvexHull::Edge& of_b : pair.b.hull->edges()) {
      const Extended along_a = edgeOf(*pair.a.hull, of_a);
      const Extended along_b = turn * edgeOf(*pair.b.hull, of_b);
      const Extended across = along_a.cross(along_b);
      if (across.norm() > 1e-15L * along_a.norm() * along_b.norm()) {
        look(across);
        look(-across);
      }
    }
  }
  return most;
}

double outside(const ConvexHull& hull, const Vector3d& point) {
  double most = -std::numeric_limits<double>::infinity();
  for (const ConvexHull::Face& face : hull.faces()) {
    most = std::max(most, face.normal.dot(point) - face.offset);
  }
  return most;
}

struct Tally {
  int overlaps{0};
  int refused{0};
};

// Against the axes, EPA and the surfaces on which the points are to lie.
void check(const ConvexPair& placed, const GjkResult& overlap, Tally& tally) {
  static ConvexWorkspace workspace;
  ++tally.overlaps;
  ConvexPair pair = placed;
  SignedDistance found;
  if (!depthOfHulls(pair, found)) {
    ++tally.refused;
    return;
  }
  const double rounding = 1e-14 * pair.size;
  ASSERT_NEAR(found.distance, static_cast<double>(mostSeparated(pair)), rounding);
  const Extended normal = found.normal_a_to_b.cast<long double>();
  ASSERT_NEAR(found.distance, static_cast<double>(gapAlong(normal, pair)), rounding);
  ASSERT_NEAR(found.distance, -runEpa(pair, overlap.simplex, roundingOf(pair), workspace).depth,
              rounding);
  const double level = 1e-11 * pair.size;  // see centerOnPatch
  ASSERT_NEAR(outside(*pair.a.hull, found.point_on_a), 0.0, level);
  ASSERT_NEAR(outside(*pair.b.hull, inverse(pair.a_from_b) * found.point_on_b), 0.0, level);
}

TEST(HullDepthLaws, depthIsThatOfAllAxesAndOfEpa_andPointsLieOnBoth) {
  Random random(kSeed);
  constexpr int kHulls = 120;
  std::vector<ConvexHull> hulls;
  hulls.reserve(kHulls);
  for (int kind = 0; kind < kHulls; ++kind) {
    hulls.push_back(randomHull(random, kind));
  }
  Tally tally;
  for (int i = 0; i < 20000; ++i) {
    SCOPED_TRACE(testing::Message() << "seed " << kSeed << ", pair " << i);
    const ConvexHull& a = hulls[random() % hulls.size()];
    const ConvexHull& b = hulls[random() % hulls.size()];
    const double reach = a.boundingRadius() + b.boundingRadius();
    const Pose a_from_b{randomTurn(random, i), randomPoint(random, uniform(random, 0.0, reach))};
    ConvexPair pair =
        makeConvexPair(inflatedCoreOf(a).core, Pose{}, inflatedCoreOf(b).core, a_from_b);
    ASSERT_TRUE(haveFewFaces(pair));
    ConvexPair searched = pair;
    const GjkResult found = runGjk(searched, ConvexWarmStart(), {1.0 + 2.0 * reach});
    if (found.state == GjkResult::State::overlapping) {
      check(pair, found, tally);
    } else {
      SignedDistance none;
      ASSERT_FALSE(depthOfHulls(pair, none));
    }
    if (HasFatalFailure()) {
      return;
    }
  }
  EXPECT_GT(tally.overlaps, 3000);
  EXPECT_LT(tally.refused, tally.overlaps / 500);
}

}  // namespace
}  // namespace collision_monitor::test
