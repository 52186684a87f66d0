// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/solid.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "support/robots/geometry_setup.h"

namespace collision_monitor::test::solids {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Pose at(double x, double y, double z) {
  Pose pose;
  pose.translation = Eigen::Vector3d(x, y, z);
  return pose;
}

TEST(Solid, primitivesApart_distanceIsThatByHand) {
  SolidQuery query;
  const auto distance = [&](const Solid& a, const Solid& b, const Pose& world_from_b) {
    const SolidDistance found = query.distance(a, Pose(), b, world_from_b);
    EXPECT_EQ(found.quality, Quality::exact);
    return found.measured.distance;
  };
  const Solid ball = Solid::sphere(0.1);
  EXPECT_NEAR(distance(ball, Solid::box({0.2, 0.4, 0.6}), at(1.0, 0.0, 0.0)), 0.8, 1e-9);
  EXPECT_NEAR(distance(ball, Solid::capsule(0.1, 0.6), at(0.0, 0.0, 1.0)), 0.5, 1e-9);
  EXPECT_NEAR(distance(ball, Solid::cylinder(0.2, 0.6), at(0.0, 0.0, 1.0)), 0.6, 1e-9);
  EXPECT_NEAR(
      distance(Solid::box({0.2, 0.2, 0.2}), Solid::box({0.2, 0.2, 0.2}), at(0.17, 0.0, 0.0)), -0.03,
      1e-9);
}

TEST(Solid, cone_isHeldByItsHull) {
  SolidQuery query;
  const Solid cone = Solid::cone(0.5, 1.0);
  const Solid ball = Solid::sphere(0.1);
  const SolidDistance tip = query.distance(cone, Pose(), ball, at(0.0, 0.0, 1.0));
  EXPECT_EQ(tip.quality, Quality::lower_bound);
  EXPECT_NEAR(tip.measured.distance, 0.4, 1e-9);
  const SolidDistance side = query.distance(cone, Pose(), ball, at(1.0, 0.1, -0.6));
  const double of_cone = std::hypot(std::hypot(1.0, 0.1) - 0.5, 0.1) - 0.1;
  EXPECT_LE(side.measured.distance, of_cone);
  EXPECT_GE(side.measured.distance, of_cone - 0.002 * 0.5);
}

TEST(Solid, hullOfPoints_isTheirConvexHull) {
  SolidQuery query;
  const Solid hull = Solid::hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  const SolidDistance found = query.distance(hull, Pose(), Solid::sphere(0.1), at(1.0, 1.0, 1.0));
  EXPECT_NEAR(found.measured.distance, 2.0 / std::sqrt(3.0) - 0.1, 1e-9);
  EXPECT_TRUE(query.collide(hull, Pose(), hull, Pose()));
}

TEST(Solid, hookedMeshes_areMeasuredByTheirTriangles) {
  SolidQuery query;
  const Solid angle = Solid::mesh(angleMesh());
  const SolidDistance found = query.distance(angle, Pose(), angle, hookedPose());
  EXPECT_EQ(found.quality, Quality::exact);
  EXPECT_NEAR(found.measured.distance, 0.02, 1e-9);
  EXPECT_FALSE(query.collide(angle, Pose(), angle, hookedPose()));
  const SolidDistance overlap = query.distance(angle, Pose(), angle, at(0.05, 0.05, 0.0));
  EXPECT_EQ(overlap.quality, Quality::estimate);
  EXPECT_LT(overlap.measured.distance, 0.0);
  EXPECT_TRUE(query.collide(angle, Pose(), angle, at(0.05, 0.05, 0.0)));
}

TriangleMesh twoTetrahedra() {
  TriangleMesh mesh;
  for (const double x : {0.0, 3.0}) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const Eigen::Vector3d& corner :
         {Eigen::Vector3d(0, 0, 0), {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) {
      mesh.vertices.emplace_back(corner + Eigen::Vector3d(x, 0, 0));
    }
    for (const std::array<std::uint32_t, 3>& t :
         {std::array<std::uint32_t, 3>{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}) {
      mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    }
  }
  return mesh;
}

TEST(Solid, verticesThatNoTriangleUses_areNoSurface) {
  SolidQuery query;
  TriangleMesh mesh = twoTetrahedra();
  mesh.vertices.insert(mesh.vertices.begin(), Eigen::Vector3d(2, 0, 5));
  for (auto& triangle : mesh.triangles) {
    for (std::uint32_t& corner : triangle) {
      ++corner;
    }
  }
  const Solid ball = Solid::sphere(0.1);
  const SolidDistance without =
      query.distance(Solid::mesh(twoTetrahedra()), Pose(), ball, at(2, 0, 5));
  const SolidDistance with = query.distance(Solid::mesh(mesh), Pose(), ball, at(2, 0, 5));
  EXPECT_EQ(with.measured.distance, without.measured.distance);
  EXPECT_EQ(with.quality, Quality::exact);
  EXPECT_GT(with.measured.distance, 3.9);
  mesh.triangles.clear();  // nothing but points
  EXPECT_NEAR(query.distance(Solid::mesh(mesh), Pose(), ball, at(2, 0, 5)).measured.distance, -0.1,
              1e-9);
}

TEST(Solid, ballInsideAMesh_collides) {
  SolidQuery query;
  const Solid angle = Solid::mesh(angleMesh());
  EXPECT_TRUE(query.collide(angle, Pose(), Solid::sphere(0.01), at(0.05, 0.05, 0.0)));
  EXPECT_TRUE(query.collide(Solid::sphere(0.01), at(0.05, 0.05, 0.0), angle, Pose()));
  EXPECT_FALSE(query.collide(angle, Pose(), Solid::sphere(0.01), at(0.2, 0.2, 0.0)));
}

TEST(Solid, ballOverAMesh_isAtLeastSomewhatDeep) {
  SolidQuery query;
  const Solid angle = Solid::mesh(angleMesh());
  const Solid ball = Solid::sphere(0.02);
  for (const double x : {0.05, -0.01}) {
    const SolidDistance one = query.distance(angle, Pose(), ball, at(x, 0.05, 0.0));
    EXPECT_EQ(one.quality, Quality::estimate);
    EXPECT_LT(one.measured.distance, -0.009);
    const SolidDistance other = query.distance(ball, at(x, 0.05, 0.0), angle, Pose());
    EXPECT_NEAR(other.measured.distance, one.measured.distance, 1e-9);
  }
}

/// Four layers of a trough with edges along y at (0, 0) and (+-1, 1), open above, at their ends and
/// across a slit 0.1 m wide at y = 0.
TriangleMesh slitTrough() {
  TriangleMesh mesh;
  for (const double z : {0.0, 0.01, 0.02, 0.03}) {
    for (const auto& [from, to] : {std::pair(-1.0, -0.05), std::pair(0.05, 1.0)}) {
      const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
      for (const double y : {from, to}) {
        mesh.vertices.insert(mesh.vertices.end(),
                             {{-1.0, y, 1.0 + z}, {0.0, y, z}, {1.0, y, 1.0 + z}});
      }
      for (const std::uint32_t side : {first, first + 1}) {
        mesh.triangles.push_back({side, side + 1, side + 4});
        mesh.triangles.push_back({side, side + 4, side + 3});
      }
    }
  }
  return mesh;
}

TEST(Solid, pointBeyondTheHullOfAnOpenMesh_isNotInsideHoweverMuchTheMeshCovers) {
  // Seen from below one side of the trough, the layers cover 0.83 of all directions.
  SolidQuery query;
  const Solid trough = Solid::mesh(slitTrough());
  TriangleMesh tetrahedron;
  tetrahedron.vertices = {{0, 0, 0}, {0.01, 0, 0}, {0, 0.01, 0}, {0, 0, -0.01}};
  tetrahedron.triangles = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
  const Solid probe = Solid::mesh(tetrahedron);
  const Pose below = at(0.5, 0.0, 0.3);
  EXPECT_FALSE(query.collide(trough, Pose(), probe, below));
  const SolidDistance found = query.distance(trough, Pose(), probe, below);
  EXPECT_EQ(found.quality, Quality::exact);
  EXPECT_NEAR(found.measured.distance, std::hypot(0.2 / std::sqrt(2.0), 0.04), 1e-9);
}

TEST(Solid, searchThatMayStop_givesABound) {
  SolidQuery query;
  const Solid angle = Solid::mesh(angleMesh());
  const SolidDistance found = query.distance(angle, Pose(), angle, at(3.0, 0.0, 0.0), 0.5);
  EXPECT_GE(found.measured.distance, 0.5);
  EXPECT_LE(found.measured.distance, 2.7 + 1e-9);
}

TEST(Solid, meshFile_isRead) {
  SolidQuery query;
  const std::filesystem::path file =
      std::filesystem::path(COLLISION_MONITOR_SOURCE_DIR) / "test/data/angle.stl";
  MeshReading reading;
  reading.is_in_process = true;
  const Solid one = Solid::mesh(file, Eigen::Vector3d::Ones(), reading);
  EXPECT_TRUE(query.collide(one, Pose(), one, Pose()));
  EXPECT_FALSE(query.collide(one, Pose(), one, at(50.0, 0.0, 0.0)));
}

TEST(Solid, badGeometry_isRefusedWithAllFaults) {
  try {
    Solid::cylinder(-1.0, kNaN);
    FAIL() << "accepted";
  } catch (const ArgumentError& fault) {
    EXPECT_EQ(fault.faults().size(), 2U);
  }
  EXPECT_THROW(Solid::sphere(std::numeric_limits<double>::infinity()), ArgumentError);
  EXPECT_THROW(Solid::box({1.0, kNaN, 1.0}), ArgumentError);
  EXPECT_THROW(Solid::cone(kNaN, 1.0), ArgumentError);
  EXPECT_THROW(Solid::hull({}), ArgumentError);
  EXPECT_THROW(Solid::hull({{kNaN, 0, 0}}), ArgumentError);
  EXPECT_THROW(Solid::mesh(TriangleMesh()), ArgumentError);
  EXPECT_THROW(Solid::mesh(TriangleMesh{{{0, 0, 0}}, {{0, 1, 2}}}), ArgumentError);
  EXPECT_THROW(Solid::mesh(std::filesystem::path("no such file.stl")), ArgumentError);
}

TEST(Solid, leastShapeOfEachKind_holdsItsPoints) {
  const std::vector<Eigen::Vector3d> points{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {1, 2, 3}};
  for (const ShapeKind kind :
       {ShapeKind::sphere, ShapeKind::capsule, ShapeKind::box, ShapeKind::rounded_box}) {
    const PosedShape fit = leastShape(kind, points);
    EXPECT_EQ(fit.shape.index(), static_cast<std::size_t>(kind));
    EXPECT_LE(excessOver(fit, points), 1e-9);
    EXPECT_THROW(leastShape(kind, {}), ArgumentError);
    EXPECT_THROW(leastShape(kind, {{0, 0, kNaN}}), ArgumentError);
  }
}

TEST(Solid, poseThatIsNone_isUnknown) {
  SolidQuery query;
  const Solid ball = Solid::sphere(0.1);
  const Solid angle = Solid::mesh(angleMesh());
  Pose skewed;
  skewed.rotation(0, 1) = 0.5;
  for (const Pose& pose : {at(kNaN, 0.0, 0.0), at(1e300, 0.0, 0.0), skewed}) {
    const SolidDistance found = query.distance(angle, Pose(), ball, pose);
    EXPECT_EQ(found.quality, Quality::unknown);
    EXPECT_TRUE(std::isnan(found.measured.distance));
    EXPECT_THROW(query.collide(angle, pose, ball, Pose()), ArgumentError);
  }
  EXPECT_THROW(query.distance(ball, Pose(), ball, Pose(), 0.0), ArgumentError);
  EXPECT_THROW(query.distance(ball, Pose(), ball, Pose(), kNaN), ArgumentError);
}

}  // namespace
}  // namespace collision_monitor::test::solids
