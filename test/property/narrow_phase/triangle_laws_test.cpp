// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>
#include <vector>

#include "narrow_phase/triangle/triangle_edges.h"
#include "narrow_phase/triangle/triangle_triangle.h"
#include "support/fixed_seed.h"
#include "support/instruction_sets.h"
#include "support/random_poses.h"
#include "support/reference/reference_features.h"

namespace collision_monitor::test::triangle_laws {
namespace {

constexpr int kPairs = 20000;
constexpr double kExact = 1e-13;   // [m], for coordinates up to 10 m, needles included
constexpr double kDecided = 1e-9;  // overlap is compared where it is not a matter of rounding

using Eigen::Vector3d;

// Sizes from 1 mm to 10 m; every kind of triangle that breaks programs.
Triangle randomTriangle(Random& random, const Vector3d& center) {
  const double size = std::pow(10.0, uniform(random, -3.0, 1.0));
  Triangle triangle;
  for (Vector3d& corner : triangle) {
    corner = center + randomPoint(random, size);
  }
  const double share = uniform(random, -0.2, 1.2);
  switch (random() % 8) {
    case 0:  // a segment
      triangle[2] = triangle[0] + share * (triangle[1] - triangle[0]);
      break;
    case 1:  // a needle
      triangle[2] = triangle[0] + share * (triangle[1] - triangle[0]) +
                    randomPoint(random, size * std::pow(10.0, uniform(random, -14.0, -2.0)));
      break;
    case 2:  // a point
      triangle[1] = triangle[2] = triangle[0];
      break;
    case 3:  // two equal corners
      triangle[2] = triangle[1];
      break;
    default:
      break;
  }
  return triangle;
}

struct TrianglePairCase {
  Triangle a;
  Triangle b;
};

TrianglePairCase randomCase(Random& random) {
  TrianglePairCase pair;
  pair.a = randomTriangle(random, Vector3d::Zero());
  pair.b = randomTriangle(random, randomPoint(random, 2.0));
  switch (random() % 8) {
    case 0:  // in one plane
      for (int i = 0; i < 3; ++i) {
        pair.a[static_cast<std::size_t>(i)].z() = 0.25;
        pair.b[static_cast<std::size_t>(i)].z() = 0.25;
      }
      break;
    case 1:  // parallel planes
      for (std::size_t i = 0; i < 3; ++i) {
        pair.a[i].z() = 0.25;
        pair.b[i].z() = 0.5;
      }
      break;
    case 2:  // a shared corner
      pair.b[0] = pair.a[1];
      break;
    case 3:  // a shared edge
      pair.b[0] = pair.a[1];
      pair.b[1] = pair.a[0];
      break;
    case 4:  // a corner inside the other
      pair.b[0] = 0.25 * pair.a[0] + 0.25 * pair.a[1] + 0.5 * pair.a[2];
      break;
    case 5:  // a parallel edge
      pair.b[1] = pair.b[0] + 0.5 * (pair.a[1] - pair.a[0]);
      break;
    default:
      break;
  }
  return pair;
}

std::string describe(const TrianglePairCase& pair) {
  std::ostringstream text;
  text.precision(17);
  for (const Triangle& triangle : {pair.a, pair.b}) {
    for (const Vector3d& corner : triangle) {
      text << "{" << corner.x() << ", " << corner.y() << ", " << corner.z() << "}, ";
    }
    text << "\n";
  }
  return text.str();
}

template <class Check>
void forManyPairs(const Check& check) {
  Random random(kSeed);
  for (int i = 0; i < kPairs && !testing::Test::HasFailure(); ++i) {
    const TrianglePairCase pair = randomCase(random);
    SCOPED_TRACE(describe(pair));
    check(pair);
  }
}

TEST(TriangleLaws, distance_isThatOfTheReference) {
  double worst = 0.0;
  forManyPairs([&](const TrianglePairCase& pair) {
    const PointPair found = nearestPoints(pair.a, pair.b);
    const auto truth =
        static_cast<double>(referenceDistance(polytopeOf(pair.a), polytopeOf(pair.b)));
    const double error = std::abs(std::sqrt(found.squared_distance) - truth);
    ASSERT_LE(error, kExact) << "reference " << truth;
    worst = std::max(worst, error);
  });
  std::printf("triangle-triangle: worst error %.1e m of %d pairs\n", worst, kPairs);
}

double leastOfEdges(const PreparedTriangle& a, const PreparedTriangle& b) {
  PointPair best;
  for (const Edge& edge_of_a : a.edges) {
    for (const Edge& edge_of_b : b.edges) {
      improveByEdges(edge_of_a, edge_of_b, best);
    }
  }
  return best.squared_distance;
}

TEST(TriangleLaws, nearestEdges_areThoseOfAllPairsOnEveryInstructionSet) {
  std::vector<EdgePair> first;
  for (const std::int64_t instruction_set : instructionSets()) {
    const OnlyInstructionSet only(instruction_set);
    std::size_t count = 0;
    forManyPairs([&](const TrianglePairCase& pair) {
      const PreparedTriangle a = prepare(pair.a);
      const PreparedTriangle b = prepare(pair.b);
      const EdgePair found = nearestEdges(a, b);
      ASSERT_NEAR(std::sqrt(found.squared_distance), std::sqrt(leastOfEdges(a, b)), kExact);
      PointPair between;
      improveByEdges(a.edges[found.a], b.edges[found.b], between);
      ASSERT_NEAR(std::sqrt(found.squared_distance), std::sqrt(between.squared_distance), kExact);
      if (count == first.size()) {
        first.push_back(found);
      }
      ASSERT_EQ(found.a, first[count].a);
      ASSERT_EQ(found.b, first[count].b);
      ASSERT_EQ(found.squared_distance, first[count].squared_distance);
      ++count;
    });
  }
}

TEST(TriangleLaws, overlap_isADistanceOfZero) {
  forManyPairs([](const TrianglePairCase& pair) {
    const auto truth =
        static_cast<double>(referenceDistance(polytopeOf(pair.a), polytopeOf(pair.b)));
    if (truth > kDecided) {
      ASSERT_FALSE(overlap(pair.a, pair.b)) << truth;
    } else if (truth == 0.0) {
      ASSERT_LE(std::sqrt(nearestPoints(pair.a, pair.b).squared_distance), kDecided);
    }
  });
}

// Triangles that reach into each other by a clear amount.
TEST(TriangleLaws, trianglesThroughACommonPoint_overlap) {
  Random random(kSeed);
  for (int i = 0; i < kPairs; ++i) {
    Triangle pair[2];
    for (Triangle& triangle : pair) {
      const Vector3d u = randomPoint(random, 1.0);
      const Vector3d v = randomPoint(random, 1.0);
      const double size = std::pow(10.0, uniform(random, -3.0, 1.0));
      triangle = {size * u, size * v, -size * (u + v)};  // the origin is the centroid
    }
    ASSERT_TRUE(overlap(pair[0], pair[1])) << i;
    ASSERT_LE(std::sqrt(nearestPoints(pair[0], pair[1]).squared_distance), 1e-12) << i;
  }
}

TEST(TriangleLaws, swapped_givesTheSame) {
  forManyPairs([](const TrianglePairCase& pair) {
    const double ab = std::sqrt(nearestPoints(pair.a, pair.b).squared_distance);
    const double ba = std::sqrt(nearestPoints(pair.b, pair.a).squared_distance);
    ASSERT_NEAR(ab, ba, kExact);
    if (std::max(ab, ba) > kDecided) {
      ASSERT_EQ(overlap(pair.a, pair.b), overlap(pair.b, pair.a));
    }
  });
}

TEST(TriangleLaws, points_lieOnTheirTrianglesAndAreApartByTheDistance) {
  forManyPairs([](const TrianglePairCase& pair) {
    const PointPair found = nearestPoints(pair.a, pair.b);
    ASSERT_TRUE(found.on_a.allFinite() && found.on_b.allFinite());
    const auto offTriangle = [](const Vector3d& point, const Triangle& triangle) {
      return static_cast<double>(
          referenceDistance(polytopeOf(triangle), polytopeOf(Triangle{point, point, point})));
    };
    ASSERT_LE(offTriangle(found.on_a, pair.a), kExact);
    ASSERT_LE(offTriangle(found.on_b, pair.b), kExact);
    ASSERT_NEAR((found.on_b - found.on_a).norm(), std::sqrt(found.squared_distance), 1e-12);
  });
}

TEST(TriangleLaws, goodStart_isKeptAndPoorOneReplaced) {
  forManyPairs([](const TrianglePairCase& pair) {
    const PointPair found = nearestPoints(pair.a, pair.b);
    PointPair start;
    start.squared_distance = 0.5 * found.squared_distance;
    if (found.squared_distance > 1e-20) {
      ASSERT_EQ(nearestPoints(pair.a, pair.b, start).squared_distance, start.squared_distance);
    }
    start.squared_distance = 4.0 * found.squared_distance + 1e-6;
    ASSERT_NEAR(std::sqrt(nearestPoints(pair.a, pair.b, start).squared_distance),
                std::sqrt(found.squared_distance), kExact);
  });
}

}  // namespace
}  // namespace collision_monitor::test::triangle_laws
