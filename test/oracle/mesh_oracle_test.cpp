// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

#include "narrow_phase/mesh/mesh_distance.h"
#include "support/fixed_seed.h"
#include "support/mesh_overlap.h"
#include "support/query_meshes.h"
#include "support/sample_meshes.h"
#include "support_fcl/fcl_mesh.h"

// FCL measures triangle soups as this package does, by branch and bound over all triangles, so
// large meshes can be compared with it where brute force would take too long.
namespace collision_monitor::test {
namespace {

constexpr double kAgreement = 1e-9;

struct Kind {
  const char* name;
  TriangleMesh mesh_a;
  TriangleMesh mesh_b;
};

void compareKind(const Kind& kind, int poses) {
  const MeshTree tree_a(kind.mesh_a);
  const MeshTree tree_b(kind.mesh_b);
  const auto fcl_a = toFcl(kind.mesh_a);
  const auto fcl_b = toFcl(kind.mesh_b);
  const auto memory = std::make_unique<MeshQueryMemory>();
  Random random(kSeed);
  double worst = 0.0;
  int overlaps = 0;
  for (int i = 0; i < poses; ++i) {
    const Pose a = randomPose(random, 1.0);
    Pose b = randomPose(random, 1.0);
    b.translation = a.translation + uniform(random, 0.2, 1.5) * randomPoint(random, 1.0);
    const auto object_a = fclObject(fcl_a, a);
    const auto object_b = fclObject(fcl_b, b);
    const MeshDistance found = distanceBetween({tree_a, a}, {tree_b, b}, *memory);
    const double truth = std::max(0.0, fclMeshDistance(object_a, object_b));
    ASSERT_NEAR(found.measured.distance, truth, kAgreement) << kind.name << " " << i;
    const bool meets = meshesOverlap({tree_a, a}, {tree_b, b}, *memory);
    ASSERT_EQ(meets, fclMeshOverlap(object_a, object_b)) << kind.name << " " << i;
    worst = std::max(worst, std::abs(found.measured.distance - truth));
    overlaps += meets ? 1 : 0;
  }
  std::printf("%s: %zu against %zu triangles, %d poses, %d overlap, worst difference %.1e m\n",
              kind.name, tree_a.triangles().size(), tree_b.triangles().size(), poses, overlaps,
              worst);
  EXPECT_GT(overlaps, poses / 20);
  EXPECT_LT(overlaps, poses);
}

TEST(MeshOracle, distanceAndOverlap_agreeWithFcl) {
  Random random(kSeed);
  compareKind({"bumpy bodies", bumpyMesh(1.0, 100), bumpyMesh(0.6, 60)}, 150);
  compareKind({"body and box", bumpyMesh(1.0, 80), boxMesh({0.2, 0.3, 0.1})}, 150);
  compareKind({"prisms", prismMesh(0.2, 0.5, 200), prismMesh(0.1, 0.8, 30)}, 150);
  compareKind({"soups", triangleSoup(0.8, 300, random), triangleSoup(0.5, 200, random)}, 150);
}

}  // namespace
}  // namespace collision_monitor::test
