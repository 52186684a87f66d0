// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <memory>
#include <vector>

#include "narrow_phase/mesh/mesh_hulls.h"
#include "support/allocation_guard.h"
#include "support/expect_distance.h"
#include "support/fixed_seed.h"
#include "support/query_meshes.h"
#include "support/random_poses.h"
#include "support/sample_meshes.h"

// What hulls tell of meshes that move at random, against a search over the triangles.
namespace collision_monitor::test {
namespace {

constexpr double kHullExact = 1e-12;  // [m], for coordinates of a metre or two

struct Hulled {
  Hulled(const TriangleMesh& mesh, bool is_closed)
      : around(ConvexHull(mesh.vertices)), tree(mesh, is_closed) {}

  ConvexGeometry around;
  MeshTree tree;
};

/// As decimation makes them: some corners of a ball are pushed in, by up to 1 % of its radius.
TriangleMesh dentedBall(double radius, Random& random) {
  TriangleMesh mesh = sphereMesh(radius, 16);
  for (Eigen::Vector3d& vertex : mesh.vertices) {
    vertex *= random() % 3 == 0 ? uniform(random, 0.99, 1.0) : 1.0;
  }
  return mesh;
}

class MeshHullsLaws : public testing::Test {
 protected:
  MeshHullsLaws() {
    meshes_.emplace_back(dentedBall(0.4, random_), true);
    meshes_.emplace_back(bumpyMesh(1.0, 12), true);
    meshes_.emplace_back(boxMesh({0.3, 0.1, 0.2}), true);
    meshes_.emplace_back(triangleSoup(0.4, 60, random_), false);
    meshes_.emplace_back(TriangleMesh{{{0, 0, 0}, {0.5, 0, 0}, {0, 0.3, 0}}, {{0, 1, 2}}}, false);
  }

  const Hulled& anyMesh() { return meshes_[random_() % meshes_.size()]; }

  // [m]
  double distanceTo(const Hulled& mesh, const Pose& pose, const Eigen::Vector3d& point) {
    return distanceBetween({mesh.tree, pose}, PlacedShape{Sphere{0.0}, at(point)}, *memory_)
        .measured.distance;
  }

  static Pose at(const Eigen::Vector3d& point) { return {Eigen::Matrix3d::Identity(), point}; }

  Random random_{kSeed};
  std::vector<Hulled> meshes_;
  std::unique_ptr<MeshQueryMemory> memory_ = std::make_unique<MeshQueryMemory>();
};

TEST_F(MeshHullsLaws, whatHullsTell_isTrueOfTheTriangles) {
  int exact = 0;
  int bounds = 0;
  for (int walk = 0; walk < 200; ++walk) {
    const Hulled& a = anyMesh();
    const Hulled& b = anyMesh();
    const Pose world_from_a = randomPose(random_, 0.5);
    Pose world_from_b = randomPose(random_, 1.0);
    ConvexWarmStart warm;
    TrianglePair nearest;
    for (int step = 0; step < 20; ++step) {
      SCOPED_TRACE(testing::Message() << "walk " << walk << ", step " << step);
      world_from_b.translation += randomPoint(random_, 0.05);
      const MeshDistance truth =
          distanceBetween({a.tree, world_from_a}, {b.tree, world_from_b}, *memory_);
      const double stop_beyond = random_() % 4 == 0 ? 0.2 : 10.0;
      const bool asks_nearest = random_() % 4 != 0;
      const MeshDistance found =
          distanceByHulls({a.around, &a.tree, world_from_a}, {b.around, &b.tree, world_from_b},
                          {stop_beyond, 0.0, asks_nearest}, *memory_, {warm, nearest});
      if (found.state == MeshState::exact) {
        ++exact;
        ASSERT_EQ(truth.state, MeshState::exact);
        ASSERT_NEAR(found.measured.distance, truth.measured.distance, kHullExact);
        expectConsistent(found.measured);
        ASSERT_LE(distanceTo(a, world_from_a, found.measured.point_on_a), kHullExact);
        ASSERT_LE(distanceTo(b, world_from_b, found.measured.point_on_b), kHullExact);
      } else if (found.state == MeshState::lower_bound) {
        ++bounds;
        ASSERT_LE(found.measured.distance, truth.measured.distance + kHullExact);
        ASSERT_EQ(truth.state, MeshState::exact);
      }
    }
  }
  EXPECT_GT(exact, 1000);
  EXPECT_GT(bounds, 500);
}

TEST_F(MeshHullsLaws, queries_allocateNothing) {
  const Hulled& a = meshes_[0];
  const Hulled& b = meshes_[1];
  const Pose origin;
  ConvexWarmStart warm;
  TrianglePair nearest;
  const AllocationGuard guard;
  for (int i = 0; i < 100; ++i) {
    const Pose pose = randomPose(random_, 1.0);
    distanceByHulls({a.around, &a.tree, origin}, {b.around, &b.tree, pose}, {10.0}, *memory_,
                    {warm, nearest});
  }
  EXPECT_EQ(guard.count(), 0U);
}

}  // namespace
}  // namespace collision_monitor::test
