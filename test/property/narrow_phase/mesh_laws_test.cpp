// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>

#include "narrow_phase/mesh/mesh_distance.h"
#include "support/allocation_guard.h"
#include "support/expect_distance.h"
#include "support/fixed_seed.h"
#include "support/mesh_overlap.h"
#include "support/query_meshes.h"
#include "support/random_pairs.h"
#include "support/reference/convex_reference.h"
#include "support/reference/reference_features.h"
#include "support/sample_meshes.h"

namespace collision_monitor::test {
namespace {

constexpr double kMeshExact = 1e-13;  // [m], for coordinates of a few metres

struct MeshScene {
  TriangleMesh mesh_a;
  TriangleMesh mesh_b;
  Pose world_from_a;
  Pose world_from_b;
};

MeshScene randomScene(Random& random) {
  MeshScene scene;
  const int count = 1 + static_cast<int>(random() % 40);
  scene.mesh_a = random() % 3 == 0 ? bumpyMesh(1.0, 6) : triangleSoup(0.5, count, random);
  scene.mesh_b = random() % 3 == 0 ? boxMesh({0.2, 0.1, 0.3}) : triangleSoup(0.3, 30, random);
  scene.world_from_a = randomPose(random, 1.0);
  scene.world_from_b = randomPose(random, uniform(random, 0.0, 3.0));
  return scene;
}

class MeshLaws : public testing::Test {
 protected:
  MeshDistance measure(const MeshScene& scene, const TrianglePair& start = TrianglePair{},
                       const MeshQueryLimits& limits = MeshQueryLimits{}) {
    const MeshTree a(scene.mesh_a);
    const MeshTree b(scene.mesh_b);
    return distanceBetween({a, scene.world_from_a}, {b, scene.world_from_b}, *memory_, start,
                           limits);
  }

  std::unique_ptr<MeshQueryMemory> memory_ = std::make_unique<MeshQueryMemory>();
  Random random_{kSeed};
};

TEST_F(MeshLaws, distanceAndOverlap_areThoseOfAllPairsOfTriangles) {
  double worst = 0.0;
  for (int i = 0; i < 150; ++i) {
    const MeshScene scene = randomScene(random_);
    const MeshTree a(scene.mesh_a);
    const MeshTree b(scene.mesh_b);
    const auto truth = static_cast<double>(
        referenceDistance(scene.mesh_a, scene.world_from_a, scene.mesh_b, scene.world_from_b));
    const MeshDistance found =
        distanceBetween({a, scene.world_from_a}, {b, scene.world_from_b}, *memory_);
    ASSERT_EQ(found.state, truth > kMeshExact ? MeshState::exact : MeshState::overlapping) << i;
    ASSERT_NEAR(found.measured.distance, truth, kMeshExact) << i;
    expectConsistent(found.measured);
    ASSERT_EQ(meshesOverlap({a, scene.world_from_a}, {b, scene.world_from_b}, *memory_),
              truth <= kMeshExact)
        << i << ": " << truth;
    worst = std::max(worst, std::abs(found.measured.distance - truth));
  }
  std::printf("mesh-mesh: worst error %.1e m\n", worst);
}

TEST_F(MeshLaws, distanceOfShape_isThatOfAllTriangles) {
  double worst = 0.0;
  for (int i = 0; i < 1200; ++i) {
    const MeshScene scene = randomScene(random_);
    const MeshTree tree(scene.mesh_a);
    const PairRecipe recipe{
        kShapeKinds[i % 4], ShapeKind::sphere, Nearness::near, Alignment::random, 0.01, 0.5, true};
    const Shape shape = randomPair(recipe, random_).a;
    const auto core = static_cast<double>(
        referenceCoreDistance(scene.mesh_a, scene.world_from_a, shape, scene.world_from_b));
    const MeshDistance found =
        distanceBetween({tree, scene.world_from_a}, {shape, scene.world_from_b}, *memory_);
    ASSERT_NEAR(found.measured.distance, core - radiusOf(shape), kMeshExact)
        << i << " " << kindName(shape);
    ASSERT_EQ(found.state,
              found.measured.distance > 0.0 ? MeshState::exact : MeshState::overlapping);
    expectConsistent(found.measured);
    worst = std::max(worst, std::abs(found.measured.distance - (core - radiusOf(shape))));
  }
  std::printf("mesh-shape: worst error %.1e m\n", worst);
}

// Slow, so few scenes: the reference searches for every triangle.
TEST_F(MeshLaws, distanceOfConvex_isThatOfAllTriangles) {
  double worst = 0.0;
  for (int i = 0; i < 40; ++i) {
    const TriangleMesh mesh = triangleSoup(0.5, 1 + i % 12, random_);
    const MeshTree tree(mesh);
    const Pose world_from_a = randomPose(random_, 1.0);
    const Pose world_from_b = randomPose(random_, uniform(random_, 0.0, 3.0));
    const auto pool = makeConvexPool(i % 2 == 0 ? ConvexKind::cylinder : ConvexKind::hull, 1,
                                     {0.01, 0.5, true}, random_);
    double truth = std::numeric_limits<double>::infinity();
    for (const auto& t : mesh.triangles) {
      const ConvexGeometry triangle =
          ConvexHull({mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]});
      long double distance = 0;
      ASSERT_TRUE(convexReference({&triangle, world_from_a, &pool[0], world_from_b}, distance));
      truth = std::min(truth, std::max(0.0, static_cast<double>(distance)));
    }
    const MeshDistance found =
        distanceBetween({tree, world_from_a}, PlacedConvex{pool[0], world_from_b}, *memory_);
    ASSERT_NEAR(found.measured.distance, truth, 1e-9) << i;
    expectConsistent(found.measured);
    worst = std::max(worst, std::abs(found.measured.distance - truth));
  }
  std::printf("mesh-convex: worst error %.1e m\n", worst);
}

// The rounded points tell the direction of a gap of their own rounding, not its length.
TEST_F(MeshLaws, convexThatNearlyTouches_hasAUnitNormal) {
  int tiny = 0;
  for (int i = 0; i < 200; ++i) {
    const MeshTree tree(triangleSoup(0.5, 8, random_));
    const Pose world_from_a = randomPose(random_, 1.0);
    const auto pool = makeConvexPool(i % 2 == 0 ? ConvexKind::cylinder : ConvexKind::hull, 1,
                                     {0.01, 0.5, true}, random_);
    Pose world_from_b = randomPose(random_, 3.0);
    const double gap = std::pow(10.0, uniform(random_, -13.0, -6.0));
    for (int step = 0; step < 3; ++step) {
      const MeshDistance found =
          distanceBetween({tree, world_from_a}, PlacedConvex{pool[0], world_from_b}, *memory_);
      ASSERT_NEAR(found.measured.normal_a_to_b.norm(), 1.0, 1e-12) << found.measured.distance;
      tiny += found.measured.distance > 0.0 && found.measured.distance < 1e-6 ? 1 : 0;
      world_from_b.translation += (gap - found.measured.distance) * found.measured.normal_a_to_b;
    }
  }
  EXPECT_GT(tiny, 50);
}

TEST_F(MeshLaws, warmStart_changesNoDistance) {
  for (int i = 0; i < 300; ++i) {
    MeshScene scene = randomScene(random_);
    const MeshDistance cold = measure(scene);
    const TrianglePair start{static_cast<std::uint32_t>(random_() % 50),
                             static_cast<std::uint32_t>(random_() % 50)};
    ASSERT_EQ(measure(scene, start).measured.distance, cold.measured.distance);
    ASSERT_EQ(measure(scene, cold.nearest).measured.distance, cold.measured.distance);
  }
}

TEST_F(MeshLaws, budgetAndLimit_giveLowerBounds) {
  int bounded = 0;
  for (int i = 0; i < 300; ++i) {
    const MeshScene scene = randomScene(random_);
    const double truth = measure(scene).measured.distance;
    for (const std::uint32_t budget : {0U, 1U, 3U, 10U, 30U}) {
      MeshQueryLimits limits;
      limits.visit_budget = budget;
      const MeshDistance found = measure(scene, {}, limits);
      ASSERT_LE(found.visits, budget + 2) << "two triangles are measured to the end";
      ASSERT_LE(found.measured.distance, truth + 1e-15) << budget;
      ASSERT_TRUE(found.state == MeshState::lower_bound || found.measured.distance == truth);
      bounded += found.state == MeshState::lower_bound && found.measured.distance > 0.0 ? 1 : 0;
    }
    MeshQueryLimits limits;
    limits.stop_beyond = uniform(random_, 0.0, 1.0);
    const MeshDistance found = measure(scene, {}, limits);
    if (truth > limits.stop_beyond) {
      ASSERT_EQ(found.state, MeshState::lower_bound);
      ASSERT_EQ(found.measured.distance, limits.stop_beyond);
    } else {
      ASSERT_EQ(found.measured.distance, truth);
    }
  }
  EXPECT_GT(bounded, 100);  // the bounds are worth something
}

TEST_F(MeshLaws, swappedAndMovedTogether_keepTheirDistance) {
  for (int i = 0; i < 300; ++i) {
    MeshScene scene = randomScene(random_);
    const double before = measure(scene).measured.distance;
    const Pose motion = randomPose(random_, 5.0);
    const MeshScene moved{scene.mesh_b, scene.mesh_a, motion * scene.world_from_b,
                          motion * scene.world_from_a};
    ASSERT_NEAR(measure(moved).measured.distance, before, 1e-12);
  }
}

TEST_F(MeshLaws, offOriginVertices_loseNothing) {
  for (int i = 0; i < 100; ++i) {
    MeshScene scene = randomScene(random_);
    const double before = measure(scene).measured.distance;
    const Eigen::Vector3d offset = randomPoint(random_, 1000.0);
    for (Eigen::Vector3d& vertex : scene.mesh_a.vertices) {
      vertex += offset;
    }
    scene.world_from_a.translation -= scene.world_from_a.rotation * offset;
    ASSERT_NEAR(measure(scene).measured.distance, before, 1e-11);
  }
}

TEST_F(MeshLaws, queries_allocateNothing) {
  const MeshTree tree(bumpyMesh(1.0, 40), true);
  const Shape box = RoundedBox{{0.1, 0.2, 0.3}, 0.05};
  const AllocationGuard guard;
  for (int i = 0; i < 50; ++i) {
    const Pose a = randomPose(random_, 1.0);
    const Pose b = randomPose(random_, 1.0);
    distanceBetween({tree, a}, {tree, b}, *memory_);
    distanceBetween({tree, a}, {box, b}, *memory_);
    meshesOverlap({tree, a}, {tree, b}, *memory_);
  }
  EXPECT_EQ(guard.count(), 0U);
}

/// Moved by a hair or by a centimetre and turned, from the last nearest pair on.
TEST_F(MeshLaws, distance_changesNoFasterThanMeshesMove) {
  for (int i = 0; i < 40; ++i) {
    MeshScene scene = randomScene(random_);
    const MeshTree a(scene.mesh_a);
    const MeshTree b(scene.mesh_b);
    double radius = 0.0;
    for (const auto& vertex : scene.mesh_b.vertices) {
      radius = std::max(radius, vertex.norm());
    }
    const auto ask = [&](const TrianglePair& start) {
      return distanceBetween({a, scene.world_from_a}, {b, scene.world_from_b}, *memory_, start);
    };
    MeshDistance last = ask({});
    for (int step = 0; step < 100; ++step) {
      const double size = std::pow(10.0, uniform(random_, -9.0, -2.0));
      const Pose turn = randomPose(random_, size);
      const Eigen::AngleAxisd whole(turn.rotation);
      const Pose before = scene.world_from_b;
      scene.world_from_b.rotation =
          Eigen::AngleAxisd(size * whole.angle(), whole.axis()) * before.rotation;
      scene.world_from_b.translation += turn.translation;
      const MeshDistance next = ask(last.nearest);
      // A rotation by t has a Frobenius norm of sqrt(8) sin(t / 2) less the identity.
      const double moved =
          turn.translation.norm() +
          radius * (scene.world_from_b.rotation - before.rotation).norm() / std::sqrt(2.0);
      ASSERT_LE(std::abs(next.measured.distance - last.measured.distance), moved + kMeshExact)
          << i << ", step " << step;
      last = next;
    }
  }
}

}  // namespace
}  // namespace collision_monitor::test
