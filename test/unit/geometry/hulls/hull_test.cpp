// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/geometry/hull.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

namespace collision_monitor::test {
namespace {

using Points = std::vector<Eigen::Vector3d>;

Points cube() {
  Points points;
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      for (const double z : {-1.0, 1.0}) {
        points.emplace_back(x, y, z);
      }
    }
  }
  return points;
}

// Enough corners that the hull climbs: a sphere cut by rings.
Points globe(int rings, int sides) {
  Points points{{0.0, 0.0, 1.0}, {0.0, 0.0, -1.0}};
  for (int i = 1; i < rings; ++i) {
    for (int j = 0; j < sides; ++j) {
      const double polar = M_PI * i / rings;
      const double turn = 2.0 * M_PI * j / sides;
      points.emplace_back(std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn),
                          std::cos(polar));
    }
  }
  return points;
}

TEST(ConvexHull, cube_hasSixFacesTwelveEdges) {
  const ConvexHull hull(cube());
  EXPECT_EQ(hull.vertices().size(), 8U);
  EXPECT_EQ(hull.faces().size(), 6U);
  EXPECT_EQ(hull.edges().size(), 12U);
  EXPECT_TRUE(hull.hasVolume());
  EXPECT_DOUBLE_EQ(hull.boundingRadius(), std::sqrt(3.0));
  for (const ConvexHull::Face& face : hull.faces()) {
    EXPECT_NEAR(face.offset, 1.0, 1e-15);
    EXPECT_NEAR(face.normal.cwiseAbs().maxCoeff(), 1.0, 1e-15);
  }
}

TEST(ConvexHull, edgeOfCube_standsBetweenPerpendicularFaces) {
  const ConvexHull hull(cube());
  for (const ConvexHull::Edge& edge : hull.edges()) {
    const Eigen::Vector3d& left = hull.faces()[edge.left].normal;
    const Eigen::Vector3d& right = hull.faces()[edge.right].normal;
    EXPECT_NEAR(left.dot(right), 0.0, 1e-15);
    const Eigen::Vector3d along = hull.vertices()[edge.to] - hull.vertices()[edge.from];
    EXPECT_NEAR(along.norm(), 2.0, 1e-15);
    EXPECT_NEAR(along.dot(left), 0.0, 1e-15);
    EXPECT_NEAR(along.dot(right), 0.0, 1e-15);
  }
}

void expectRingsTurnLeft(const ConvexHull& hull, std::size_t corner_count) {
  for (std::uint32_t face = 0; face < hull.faces().size(); ++face) {
    const ConvexHull::Indices ring = hull.ringOf(face);
    ASSERT_EQ(ring.size(), corner_count);
    for (std::size_t i = 0; i < corner_count; ++i) {
      const Eigen::Vector3d& from = hull.vertices()[ring.first[i]];
      const Eigen::Vector3d& at = hull.vertices()[ring.first[(i + 1) % corner_count]];
      const Eigen::Vector3d& to = hull.vertices()[ring.first[(i + 2) % corner_count]];
      EXPECT_GT((at - from).cross(to - at).dot(hull.faces()[face].normal), 0.0);
    }
  }
}

TEST(ConvexHull, ringsOfFaces_turnLeftSeenFromOutside) {
  expectRingsTurnLeft(ConvexHull(cube()), 4);
  expectRingsTurnLeft(ConvexHull({{0, 0, 2}, {1, 0, 2}, {1, 1, 2}, {0, 1, 2}}), 4);
  expectRingsTurnLeft(ConvexHull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}), 3);
}

TEST(ConvexHull, facesAtACorner_areThoseWithItInTheirRings) {
  const ConvexHull hull(cube());
  for (std::uint32_t corner = 0; corner < hull.vertices().size(); ++corner) {
    const ConvexHull::Indices faces = hull.facesAt(corner);
    EXPECT_EQ(faces.size(), 3U);
    for (const std::uint32_t face : faces) {
      const ConvexHull::Indices ring = hull.ringOf(face);
      EXPECT_EQ(std::count(ring.begin(), ring.end(), corner), 1);
    }
  }
  EXPECT_EQ(ConvexHull({{1, 2, 3}}).facesAt(0).size(), 0U);
}

TEST(ConvexHull, fansOfACorner_holdTheOtherEndsOfItsEdges) {
  const ConvexHull hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  for (std::uint32_t i = 0; i < 4; ++i) {
    const ConvexHull::Fans fans = hull.fansOf(i);
    ASSERT_EQ(fans.end() - fans.begin(), 1);
    std::set<std::uint32_t> others(fans.first->vertex.begin(), fans.first->vertex.end());
    others.insert(i);
    EXPECT_EQ(others.size(), 4U);
  }
}

TEST(ConvexHull, reachBesideACorner_isOfItsFarthestNeighbour) {
  const ConvexHull hull({{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}});
  const Eigen::Vector3d up(0.5, 0.25, 1.0);
  for (std::uint32_t i = 0; i < 4; ++i) {
    EXPECT_EQ(hull.reachBeside(up, i), hull.vertices()[i].z() == 3.0 ? 0.5 : 3.0);
  }
  const ConvexHull line({{0, 0, 0}, {1, 0, 0}});
  EXPECT_FALSE(line.canClimb());
  EXPECT_EQ(line.reachBeside(up, 0), -std::numeric_limits<double>::infinity());
}

TEST(ConvexHull, extremeVertex_isFoundFromEachVertexWithWhatIsBesideIt) {
  const Eigen::Vector3d up(0.5, 0.25, 1.0);
  const ConvexHull hull({{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}});
  const ConvexHull line({{0, 0, 0}, {1, 0, 0}});
  for (std::uint32_t start = 0; start < 4; ++start) {
    const ConvexHull::Extreme top = hull.extreme(up, start);
    EXPECT_EQ(hull.vertices()[top.vertex].z(), 3.0);
    EXPECT_EQ(top.reach, 3.0);
    EXPECT_EQ(top.beside, 0.5);
    const ConvexHull::Extreme end = line.extreme(up, start % 2);
    EXPECT_EQ(line.vertices()[end.vertex].x(), 1.0);
    EXPECT_EQ(end.reach, 0.5);
    EXPECT_EQ(end.beside, -std::numeric_limits<double>::infinity());
  }
}

TEST(ConvexHull, square_hasTwoFacesAndNoVolume) {
  const ConvexHull hull({{0, 0, 2}, {1, 0, 2}, {1, 1, 2}, {0, 1, 2}});
  EXPECT_EQ(hull.faces().size(), 2U);
  EXPECT_EQ(hull.edges().size(), 4U);
  EXPECT_FALSE(hull.hasVolume());
}

TEST(ConvexHull, collinearAndCoincidentPoints_haveNoFaces) {
  const ConvexHull line({{0, 0, 0}, {1, 0, 0}, {3, 0, 0}});
  EXPECT_EQ(line.vertices().size(), 2U);
  EXPECT_TRUE(line.faces().empty());
  const ConvexHull point({{1, 2, 3}, {1, 2, 3}});
  EXPECT_EQ(point.vertices().size(), 1U);
  EXPECT_EQ(point.supportVertex(Eigen::Vector3d::UnitX(), 0), 0U);
}

void expectFarthestFromEveryStart(const ConvexHull& hull) {
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3d direction(std::cos(1.0 * i), std::sin(1.7 * i), std::cos(2.3 * i));
    double farthest = -std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3d& vertex : hull.vertices()) {
      farthest = std::max(farthest, direction.dot(vertex));
    }
    for (std::uint32_t start = 0; start < hull.vertices().size(); start += 7) {
      const std::uint32_t found = hull.supportVertex(direction, start);
      EXPECT_NEAR(direction.dot(hull.vertices()[found]), farthest, 1e-14);
    }
  }
}

TEST(ConvexHull, support_isFarthestWhereverTheClimbStarts) {
  const ConvexHull hull(globe(8, 12));
  ASSERT_GT(hull.vertices().size(), 60U);
  expectFarthestFromEveryStart(hull);
}

TEST(ConvexHull, supportOfManyVertices_isFarthestWhereverTheClimbStarts) {
  const ConvexHull hull(globe(20, 24));
  ASSERT_GT(hull.vertices().size(), 400U);
  expectFarthestFromEveryStart(hull);
}

TEST(ConvexHull, supportAlongAxesAndAlongNothing_isAVertex) {
  const ConvexHull hull(globe(20, 24));
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {1.0, -1.0}) {
      const Eigen::Vector3d direction = sign * Eigen::Vector3d::Unit(axis);
      double farthest = -std::numeric_limits<double>::infinity();
      for (const Eigen::Vector3d& vertex : hull.vertices()) {
        farthest = std::max(farthest, direction.dot(vertex));
      }
      EXPECT_NEAR(direction.dot(hull.vertices()[hull.supportVertex(direction, 100)]), farthest,
                  1e-14);
    }
  }
  EXPECT_LT(hull.supportVertex(Eigen::Vector3d::Zero(), 100), hull.vertices().size());
}

// A needle-short edge would stop a climb that looks at slopes: seen as one corner, the ends do not.
TEST(ConvexHull, cornersAHairApart_doNotStopTheSearch) {
  Points points = globe(8, 12);
  const Points before = points;
  for (const Eigen::Vector3d& point : before) {
    points.push_back(point * (1.0 + 1e-15) + Eigen::Vector3d(3e-12, -2e-12, 1e-12));
  }
  const ConvexHull hull(points);
  for (int i = 0; i < 50; ++i) {
    const Eigen::Vector3d direction(std::cos(1.0 * i), std::sin(1.7 * i), std::cos(2.3 * i));
    double farthest = -std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3d& vertex : hull.vertices()) {
      farthest = std::max(farthest, direction.dot(vertex));
    }
    EXPECT_EQ(direction.dot(hull.vertices()[hull.supportVertex(direction, 0)]), farthest);
  }
}

TEST(ConvexHull, noPointsOrNotFinite_isRefused) {
  EXPECT_THROW(ConvexHull(Points{}), std::invalid_argument);
  EXPECT_THROW(ConvexHull({{0, 0, std::nan("")}}), std::invalid_argument);
}

}  // namespace
}  // namespace collision_monitor::test
