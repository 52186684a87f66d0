// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/mesh_inside/mesh_winding.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>

#include "narrow_phase/mesh_depth/mesh_depth.h"
#include "narrow_phase/mesh_inside/mesh_inside.h"
#include "narrow_phase/mesh_inside/mesh_openness.h"
#include "support/mesh_overlap.h"
#include "support/query_meshes.h"
#include "support/sample_meshes.h"

namespace collision_monitor::test::mesh_winding {
namespace {

using Eigen::Vector3d;

/// The triangles whose corners are below a height on average.
TriangleMesh below(double height, const TriangleMesh& mesh) {
  TriangleMesh part{mesh.vertices, {}};
  for (const auto& t : mesh.triangles) {
    const Vector3d sum = mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]];
    if (sum.z() < 3.0 * height) {
      part.triangles.push_back(t);
    }
  }
  return part;
}

TriangleMesh openBox() { return below(0.9, boxMesh({1, 1, 1})); }
TriangleMesh bowl() { return below(0.0, sphereMesh(1.0, 40)); }
TriangleMesh sheet() { return below(-0.9, boxMesh({1, 1, 1})); }

class MeshWinding : public testing::Test {
 protected:
  bool holds(const MeshTree& tree, const Vector3d& point) {
    return lookInside(tree, point, *memory_).is_inside;
  }
  bool holds(const TriangleMesh& mesh, const Vector3d& point) {
    return holds(test::openTree(mesh), point);
  }
  MeshDistance distance(const MeshTree& a, const MeshTree& b, const Vector3d& to_b) {
    const Pose here;
    const Pose there{Eigen::Matrix3d::Identity(), to_b};
    const MeshDistance found = distanceBetween({a, here}, {b, there}, *memory_);
    EXPECT_EQ(meshesOverlap({a, here}, {b, there}, *memory_),
              found.state == MeshState::overlapping);
    return found;
  }
  MeshDistance distance(const MeshTree& a, const ConvexGeometry& b, const Vector3d& to_b) {
    const Pose here;
    const Pose there{Eigen::Matrix3d::Identity(), to_b};
    return distanceBetween({a, here}, PlacedConvex{b, there}, *memory_);
  }

  std::unique_ptr<MeshQueryMemory> memory_ = std::make_unique<MeshQueryMemory>();
};

TEST_F(MeshWinding, cubeWithoutOneSide_fiveSixthsInTheMiddle) {
  const MeshTree tree = test::openTree(openBox());
  const WindingNumber number = windingNumber(tree, Vector3d::Zero(), 1e-9, *memory_);
  EXPECT_NEAR(number.value, 5.0 / 6.0, 2e-9);
  EXPECT_LE(number.error, 1e-9);
  EXPECT_TRUE(holds(tree, Vector3d::Zero()));
}

TEST_F(MeshWinding, pointOnTheRim_isOutside) {
  const MeshTree tree = test::openTree(openBox());
  for (const Vector3d& point : {Vector3d(1, 1, 1), Vector3d(0.25, 1, 1)}) {
    EXPECT_FALSE(holds(tree, point));
    EXPECT_EQ(lookInside(tree, point, *memory_).hold, 0.0);
  }
}

/// Three lines of sight from this point pass through the round rim, far from it.
TEST_F(MeshWinding, pointInTheWallsOfThreeDirections_isInside) {
  for (const int sides : {200, 1000}) {
    TriangleMesh tube = below(0.29, prismMesh(0.05, 0.3, sides));
    const MeshTree tree = test::openTree(tube);
    const Vector3d point = Vector3d(0.000240958242, 0.0130134009, 0.3 - 0.138554978);
    const WindingNumber number = windingNumber(tree, point, 1e-9, *memory_);
    EXPECT_LE(number.error, 1e-9);
    EXPECT_NEAR(number.value, 0.9706, 1e-2);
    EXPECT_TRUE(holds(tree, point));
  }
}

TEST_F(MeshWinding, openBox_endsAtItsHole) {
  const MeshTree tree = test::openTree(openBox());
  for (const double x : {0.0, 0.7}) {
    EXPECT_TRUE(holds(tree, {x, 0, 0.9}));
    EXPECT_FALSE(holds(tree, {x, 0, 1.001}));
    EXPECT_FALSE(holds(tree, {x, 0, 1.5}));
    EXPECT_FALSE(holds(tree, {x, 0, -1.001}));
  }
  EXPECT_FALSE(holds(tree, {1.001, 0, 0}));
}

/// The box is tilted, so its hole is inside its bounds. A point above the hole stays outside for a
/// part of the way there, and no longer.
TEST_F(MeshWinding, aPointBeforeAHole_staysOutsideUntilItEnters) {
  const Vector3d tilt(0.6, 0.3, 0.0);
  const MeshTree tree = test::openTree(moved(openBox(), tilt, Vector3d::Zero()));
  const Vector3d up = Eigen::AngleAxisd(tilt.norm(), tilt.normalized()) * Vector3d::UnitZ();
  std::uint32_t visits = 0;
  for (const double away : {0.02, 0.1, 0.3}) {
    const auto stays = [&](double travel) {
      return staysOutside(tree, (1.0 + away) * up, travel, *memory_, visits);
    };
    EXPECT_TRUE(stays(0.3 * away)) << away;
    EXPECT_FALSE(stays(1.01 * away)) << away;
    EXPECT_FALSE(staysOutside(tree, (1.0 - away) * up, 0.0, *memory_, visits)) << away;
  }
  EXPECT_GT(visits, 0U);
  const MeshTree closed(boxMesh({1, 1, 1}), true);
  EXPECT_TRUE(staysOutside(closed, {0, 0, 1.1}, 9.0, *memory_, visits)) << "none but by crossing";
  EXPECT_FALSE(staysOutside(closed, {0, 0, 0.9}, 0.0, *memory_, visits));
}

TEST_F(MeshWinding, bowlAndSheet_holdNothingOutside) {
  const TriangleMesh round = bowl();
  const TriangleMesh flat = sheet();
  for (double away = 1e-9; away < 3.0; away *= 3.0) {
    for (const double x : {-0.8, 0.0, 0.5}) {
      EXPECT_FALSE(holds(flat, {x, 0.3, -1.0 + away}));
      EXPECT_FALSE(holds(flat, {x, 0.3, -1.0 - away}));
      EXPECT_FALSE(holds(round, {x, 0.0, 0.05 + away}));
      EXPECT_FALSE(holds(round, (1.0 + away) * Vector3d(x, 0, -std::sqrt(1.0 - x * x))));
    }
  }
  EXPECT_TRUE(holds(round, {0, 0, -0.5})) << "more than half of all directions";
}

TEST_F(MeshWinding, insideOutTurnedAndTwoSidedMeshes_haveTheirInside) {
  TriangleMesh inside_out = openBox();
  TriangleMesh turned = openBox();
  TriangleMesh two_sided = openBox();
  for (std::size_t i = 0; i < inside_out.triangles.size(); ++i) {
    auto& triangle = inside_out.triangles[i];
    std::swap(triangle[1], triangle[2]);
    two_sided.triangles.push_back(triangle);
    turned.triangles[i] = i % 3 == 0 ? triangle : turned.triangles[i];
  }
  TriangleMesh mirrored = openBox();
  for (Vector3d& vertex : mirrored.vertices) {
    vertex.y() = -vertex.y();
  }
  for (const TriangleMesh& mesh : {inside_out, turned, two_sided, mirrored}) {
    EXPECT_TRUE(holds(mesh, Vector3d::Zero()));
    EXPECT_FALSE(holds(mesh, {0, 0, 1.5}));
    EXPECT_FALSE(holds(mesh, {1.01, 0, 0}));
  }
}

TEST_F(MeshWinding, wallCopiedOverAWall_isNoInsideBeforeIt) {
  TriangleMesh doubled = openBox();
  doubled.triangles.push_back(doubled.triangles[0]);
  doubled.triangles.push_back(doubled.triangles[1]);
  for (const Vector3d& side : {Vector3d(1.01, 0, 0), Vector3d(-1.01, 0, 0), Vector3d(0, 1.01, 0),
                               Vector3d(0, -1.01, 0), Vector3d(0, 0, -1.01)}) {
    EXPECT_FALSE(holds(doubled, side));
  }
}

TEST_F(MeshWinding, nestedShells_innerOneTurnedIsACavity) {
  TriangleMesh outer = boxMesh({1, 1, 1});
  outer.triangles.pop_back();
  TriangleMesh inner = boxMesh({0.5, 0.5, 0.5});
  EXPECT_TRUE(holds(joined(outer, inner), Vector3d::Zero())) << "twice";
  for (auto& triangle : inner.triangles) {
    std::swap(triangle[1], triangle[2]);
  }
  EXPECT_FALSE(holds(joined(outer, inner), Vector3d::Zero()));
  EXPECT_TRUE(holds(joined(outer, inner), {0, -0.75, 0}));
}

TEST_F(MeshWinding, trianglesWithoutArea_changeNothing) {
  TriangleMesh mesh = openBox();
  mesh.triangles.push_back({0, 0, 0});
  mesh.triangles.push_back({0, 1, 1});
  EXPECT_TRUE(holds(mesh, Vector3d::Zero()));
  EXPECT_FALSE(holds(mesh, {0, 0, 1.5}));
  EXPECT_FALSE(holds(TriangleMesh{mesh.vertices, {}}, Vector3d::Zero())) << "points alone";
}

TEST_F(MeshWinding, meshInsideAnOpenOne_overlaps) {
  const MeshTree box = test::openTree(openBox());
  const MeshTree small(boxMesh({0.1, 0.1, 0.1}), true);
  EXPECT_EQ(distance(box, small, {0.3, 0, 0}).state, MeshState::overlapping);
  EXPECT_EQ(distance(small, box, {0.3, 0, 0}).state, MeshState::overlapping);
  const MeshDistance above = distance(box, small, {0, 0, 1.3});
  EXPECT_EQ(above.state, MeshState::exact);
  EXPECT_NEAR(above.measured.distance, std::hypot(0.9, 0.2), 1e-9);
}

TEST_F(MeshWinding, barThatReachesInThroughTheHole_overlaps) {
  const MeshTree box = test::openTree(openBox());
  const MeshTree bar(boxMesh({0.1, 0.1, 1.0}), true);
  EXPECT_EQ(distance(box, bar, {0, 0, 1.9}).state, MeshState::overlapping);
  EXPECT_EQ(distance(box, bar, {0, 0, 2.1}).state, MeshState::exact);
  EXPECT_EQ(distance(box, Capsule{0.9, 0.1}, {0, 0, 1.7}).state, MeshState::overlapping);
  EXPECT_EQ(distance(box, Capsule{0.9, 0.1}, {0, 0, 2.1}).state, MeshState::exact);
}

TEST_F(MeshWinding, shapesInsideAnOpenMesh_overlapAndAreAsDeepAsIsProven) {
  const MeshTree box = test::openTree(openBox());
  const ConvexHull hull(boxMesh({0.1, 0.1, 0.1}).vertices);
  for (const ConvexGeometry& geometry :
       {ConvexGeometry(Sphere{0.1}), ConvexGeometry(Capsule{0.1, 0.1}),
        ConvexGeometry(Box{{0.1, 0.1, 0.1}}), ConvexGeometry(Cylinder{0.1, 0.1}),
        ConvexGeometry(hull)}) {
    EXPECT_EQ(distance(box, geometry, {0, 0, -0.2}).state, MeshState::overlapping);
    EXPECT_EQ(distance(box, geometry, {0, 0, 1.4}).state, MeshState::exact);
  }
  // Out through the hole it is 0.8 m and the radius; at the surface 0.9 m.
  const MeshDistance ball = distance(box, Sphere{0.1}, {0.1, 0, 0.2});
  EXPECT_EQ(ball.state, MeshState::overlapping);
  EXPECT_LT(ball.measured.distance, -0.2);
  EXPECT_GT(ball.measured.distance, -0.9);
  EXPECT_TRUE((ball.measured.point_on_b - ball.measured.point_on_a)
                  .isApprox(ball.measured.distance * ball.measured.normal_a_to_b, 1e-9));
}

TEST_F(MeshWinding, depthOfMeshes_isNotBeyondTheHole) {
  const MeshTree box = test::openTree(openBox());
  const MeshTree small(boxMesh({0.1, 0.1, 0.1}), true);
  const Pose here;
  for (const double height : {-0.5, 0.0, 0.5, 0.85}) {
    const auto nothing = std::make_unique<KeptDepth>();
    const Pose there{Eigen::Matrix3d::Identity(), {0, 0, height}};
    const MeshDepth found = depthOf({box, here}, {small, there}, *memory_, *nothing, 10000);
    EXPECT_TRUE(found.is_complete);
    EXPECT_LT(found.deepest.distance, -0.01) << height;
    EXPECT_GE(found.deepest.distance, -(1.0 - height + 0.1)) << "the way of its lowest corners out";
    EXPECT_TRUE((found.deepest.point_on_b - found.deepest.point_on_a)
                    .isApprox(found.deepest.distance * found.deepest.normal_a_to_b, 1e-9));
  }
}

TEST_F(MeshWinding, openness) {
  EXPECT_EQ(opennessOf(MeshTree(boxMesh({1, 1, 1}), true)), 0.0);
  EXPECT_NEAR(opennessOf(test::openTree(sheet())), 0.5, 0.006);
  EXPECT_GT(opennessOf(test::openTree(bowl())), 2.0 * kTooOpen);
  EXPECT_GT(opennessOf(test::openTree(openBox())), kTooOpen);
  TriangleMesh torso = sphereMesh(1.0, 24);
  for (const std::size_t hole : {500, 400, 300, 100}) {
    torso.triangles.erase(torso.triangles.begin() + static_cast<std::ptrdiff_t>(hole));
  }
  EXPECT_LT(opennessOf(test::openTree(torso)), 0.5 * kTooOpen) << "twelve edges are open";
}

TriangleMesh loose(const Vector3d& corner, double size) {
  return {{corner, corner + Vector3d(size, 0, 0), corner + Vector3d(0, size, 0)}, {{0, 1, 2}}};
}

TEST_F(MeshWinding, rimThatVanishesSeenFromAPoint_countsNoTurns) {
  // The point lies in line with the speck: seen from there both ends of its sides are equal.
  TriangleMesh box = boxMesh({0.5, 0.5, 0.5});
  for (auto& triangle : box.triangles) {
    std::swap(triangle[0], triangle[1]);
  }
  const MeshTree tree =
      test::openTree(joined(joined(box, loose({0, 0, 0.2}, 1e-18)), loose({0.3, -0.3, 0.4}, 0.01)));
  const Vector3d point(-0.070083060711922954, -0.036461352505778852, -0.057821345527035273);
  EXPECT_NEAR(windingNumber(tree, point, 1e-9, *memory_).value, -1.0, 1e-4);
  EXPECT_TRUE(holds(tree, point));
}

TEST_F(MeshWinding, pointThatIsNotFinite_hasNoNumberAndProvesNothing) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const MeshTree& tree : {test::openTree(openBox()), MeshTree(boxMesh({1, 1, 1}), true)}) {
    for (const Vector3d& point : {Vector3d(nan, 0, 0), Vector3d(0, 0, nan)}) {
      std::uint32_t visits = 0;
      EXPECT_FALSE(staysOutside(tree, point, 0.1, *memory_, visits));
      EXPECT_FALSE(holds(tree, point));
      if (!tree.isClosed()) {
        EXPECT_TRUE(std::isinf(windingNumber(tree, point, 1e-9, *memory_).error));
        EXPECT_EQ(lookInside(tree, point, *memory_).hold, 0.0);
      }
    }
  }
}

TEST_F(MeshWinding, pointSoFarThatProductsOverflow_hasNoNumber) {
  const MeshTree tree = test::openTree(openBox());
  for (const double far : {1e150, 2.7e234, 1e308}) {
    EXPECT_TRUE(std::isinf(windingNumber(tree, {far, far, far}, 1e-9, *memory_).error)) << far;
  }
}

}  // namespace
}  // namespace collision_monitor::test::mesh_winding
