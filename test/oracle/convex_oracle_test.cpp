// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <vector>

#include "geometry/hulls/convex_hull.h"
#include "narrow_phase/geometry_distance.h"
#include "support/fixed_seed.h"
#include "support/query_meshes.h"
#include "support/reference/convex_measure.h"
#include "support/reference/convex_reference.h"
#include "support/sample_meshes.h"
#include "support_fcl/fcl_adapter.h"
#include "support_fcl/fcl_mesh.h"

// Prints the tables of docs/accuracy.md in which FCL stands beside this package for cylinders,
// hulls and meshes.
namespace collision_monitor::test {
namespace {

enum class Class : std::size_t { separated, near, touching, shallow, deep };
constexpr std::size_t kClasses = 5;
constexpr const char* kClassNames[] = {"separated", "near", "touching", "overlapping, shallow",
                                       "overlapping, deep"};
// Overlaps up to this [m] are shallow.
constexpr double kShallow = 1e-3;
// FCL's booleans are compared where the answer is not a matter of rounding.
constexpr double kDecided = 1e-6;

Class classOf(Nearness nearness, double truth) {
  if (nearness == Nearness::touching) {
    return Class::touching;
  }
  if (truth < 0.0) {
    return truth < -kShallow ? Class::deep : Class::shallow;
  }
  return truth > kShallow ? Class::separated : Class::near;
}

struct Worst {
  int count{0};
  double ours{0.0};
  double fcl{0.0};
  int fcl_wrong_overlaps{0};
  int fcl_silent{0};
};
using Row = std::array<Worst, kClasses>;

void compare(double ours, std::optional<double> fcl, std::optional<bool> fcl_overlap, double truth,
             Worst& worst) {
  ++worst.count;
  // Written so that NaN counts as the worst.
  worst.ours = std::abs(ours - truth) <= worst.ours ? worst.ours : std::abs(ours - truth);
  if (!fcl || !fcl_overlap) {
    ++worst.fcl_silent;
    return;
  }
  worst.fcl = std::max(worst.fcl, std::abs(*fcl - truth));
  worst.fcl_wrong_overlaps += std::abs(truth) > kDecided && *fcl_overlap != (truth < 0.0) ? 1 : 0;
}

void print(const char* a, const char* b, const Row& row) {
  for (std::size_t c = 0; c < kClasses; ++c) {
    const Worst& worst = row[c];
    if (worst.count > 0) {
      std::printf("| %s-%s | %s | %d | %.1e | %.1e | %d | %d |\n", a, b, kClassNames[c],
                  worst.count, worst.ours, worst.fcl, worst.fcl_wrong_overlaps, worst.fcl_silent);
    }
  }
}

constexpr const char* kHead =
    "| pair | pairs are | pairs | our worst error [m] | FCL's worst error [m] | FCL's wrong "
    "overlaps | FCL silent |\n|---|---|---|---|---|---|---|\n";

FclObject objectOf(const ConvexGeometry& geometry, const Pose& pose) {
  return {toFclGeometry(geometry), pose.rotation, pose.translation};
}

Row measureConvex(ConvexKind a, ConvexKind b, int count) {
  constexpr ConvexPoolRecipe kRecipe{0.01, 0.5, false};
  Random random(kSeed);
  const auto pool_a = makeConvexPool(a, 12, kRecipe, random);
  const auto pool_b = makeConvexPool(b, 12, kRecipe, random);
  Row row;
  for (int i = 0; i < count; ++i) {
    const Nearness nearness = kNearnesses[i % 4];
    const PosedConvexPair pair = placeConvexPair(pool_a[random() % 12], pool_b[random() % 12],
                                                 nearness, Alignment::random, random);
    long double reference = 0;
    if (!convexReference(pair, reference)) {
      continue;
    }
    const auto truth = static_cast<double>(reference);
    const FclObject object_a = objectOf(*pair.a, pair.world_from_a);
    const FclObject object_b = objectOf(*pair.b, pair.world_from_b);
    std::optional<double> fcl = fclDistance(object_a, object_b);
    if (truth < 0.0) {
      fcl = fclDepth(object_a, object_b);
      fcl = fcl ? std::optional<double>(-*fcl) : std::nullopt;
    } else if (fcl) {
      fcl = std::max(*fcl, 0.0);
    }
    const double ours =
        measureCold(*pair.a, pair.world_from_a, *pair.b, pair.world_from_b).measured.distance;
    compare(ours, fcl, fclOverlap(object_a, object_b), truth,
            row[static_cast<std::size_t>(classOf(nearness, truth))]);
  }
  return row;
}

// FCL has no rounded box, and two cylinders are searched for a long time.
TEST(ConvexOracle, cylindersAndHulls_table) {
  std::printf("%s", kHead);
  for (const ConvexKind b : {ConvexKind::cylinder, ConvexKind::hull}) {
    for (const ConvexKind a : {ConvexKind::sphere, ConvexKind::capsule, ConvexKind::box,
                               ConvexKind::cylinder, ConvexKind::hull}) {
      if (a > b) {
        continue;
      }
      const bool are_cylinders = a == ConvexKind::cylinder && b == ConvexKind::cylinder;
      const Row row = measureConvex(a, b, are_cylinders ? 20 : 200);
      print(nameOf(a), nameOf(b), row);
      for (const Worst& worst : row) {
        // The reference of two cylinders itself is that good only.
        EXPECT_LE(worst.ours, are_cylinders ? 1e-6 : 1e-7) << nameOf(a) << "-" << nameOf(b);
      }
    }
  }
}

// The least over all triangles by the slow reference, 0 where one overlaps.
double meshReference(const TriangleMesh& mesh, const Pose& pose, const ConvexGeometry& other,
                     const Pose& other_pose) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& t : mesh.triangles) {
    const ConvexGeometry triangle =
        ConvexHull({mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]});
    long double distance = 0;
    convexReference({&triangle, pose, &other, other_pose}, distance);
    least = std::min(least, std::max(0.0, static_cast<double>(distance)));
  }
  return least;
}

double meshReference(const TriangleMesh& a, const Pose& pose_a, const TriangleMesh& b,
                     const Pose& pose_b) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& t : b.triangles) {
    const ConvexGeometry triangle =
        ConvexHull({b.vertices[t[0]], b.vertices[t[1]], b.vertices[t[2]]});
    least = std::min(least, meshReference(a, pose_a, triangle, pose_b));
  }
  return least;
}

template <class Other, class MakeObject>
Row measureMesh(const TriangleMesh& mesh, const Other& other, const GeometryRef& other_ref,
                const MakeObject& makeObject, int count) {
  const MeshTree tree(mesh);
  const auto fcl_mesh = toFcl(mesh);
  const auto workspace = std::make_unique<ConvexWorkspace>();
  const auto memory = std::make_unique<MeshQueryMemory>();
  Random random(kSeed);
  const auto measure = [&](const Pose& pose_a, const Pose& pose_b) {
    ConvexWarmStart warm;
    ConvexSearch convex{*workspace, warm};
    GeometrySearch search{convex, *memory};
    return signedDistanceBetween(&tree, pose_a, other_ref, pose_b, search).measured;
  };
  Row row;
  for (int i = 0; i < count; ++i) {
    const Nearness nearness = kNearnesses[i % 4];
    const Pose pose_a = randomPose(random, 1.0);
    Pose pose_b = randomPose(random, 1.0);
    if (nearness != Nearness::overlapping) {
      const SignedDistance now = measure(pose_a, pose_b);
      const double gap = nearness == Nearness::separated ? uniform(random, 0.01, 3.0)
                         : nearness == Nearness::near    ? uniform(random, 1e-6, 1e-3)
                                                         : 0.0;
      pose_b.translation += (gap - now.distance) * now.normal_a_to_b;
    }
    const double truth = meshReference(mesh, pose_a, other, pose_b);
    const auto object_a = fclObject(fcl_mesh, pose_a);
    const auto object_b = makeObject(pose_b);
    const double fcl = std::max(0.0, fclMeshDistance(object_a, object_b));
    const bool fcl_overlap = fclMeshOverlap(object_a, object_b);
    const bool is_overlap = truth == 0.0;
    Worst& worst = row[static_cast<std::size_t>(nearness == Nearness::touching ? Class::touching
                                                : is_overlap                   ? Class::deep
                                                             : classOf(nearness, truth))];
    compare(std::max(0.0, measure(pose_a, pose_b).distance), fcl, fcl_overlap,
            is_overlap ? -0.0 : truth, worst);
    worst.fcl_wrong_overlaps += is_overlap && nearness != Nearness::touching && !fcl_overlap;
  }
  return row;
}

void expectMeshRow(const char* a, const char* b, const Row& row) {
  print(a, b, row);
  for (const Worst& worst : row) {
    EXPECT_LE(worst.ours, 1e-9) << a << "-" << b;
  }
}

TEST(ConvexOracle, meshes_table) {
  Random random(kSeed);
  const TriangleMesh soup = triangleSoup(0.5, 12, random);
  const TriangleMesh box = boxMesh({0.2, 0.1, 0.3});
  std::printf("%s", kHead);
  const auto meshObject = [](const TriangleMesh& mesh) {
    return [fcl = toFcl(mesh)](const Pose& pose) { return fclObject(fcl, pose); };
  };
  const MeshTree box_tree(box);
  expectMeshRow("mesh", "mesh", measureMesh(soup, box, &box_tree, meshObject(box), 200));
  const ConvexGeometry others[] = {Sphere{0.2}, Capsule{0.3, 0.1}, Box{{0.2, 0.1, 0.3}},
                                   Cylinder{0.3, 0.15}};
  for (const ConvexGeometry& other : others) {
    const auto object = [&](const Pose& pose) { return objectOf(other, pose); };
    expectMeshRow("mesh", nameOf(static_cast<ConvexKind>(other.index())),
                  measureMesh(soup, other, &other, object, 100));
  }
}

}  // namespace
}  // namespace collision_monitor::test
