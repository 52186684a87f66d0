// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "stress_solids.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>

#include "geometry/hulls/convex_hull.h"
#include "narrow_phase/geometry_distance.h"
#include "support/reference/convex_measure.h"

namespace collision_monitor::test {
namespace {

constexpr std::size_t kPool = 24;

/// A convex geometry and, of a hull with faces, its surface.
struct Solid {
  ConvexGeometry convex;
  std::optional<MeshTree> mesh;

  GeometryRef ref() const { return mesh ? GeometryRef(&*mesh) : GeometryRef(&convex); }
};

std::vector<Solid> makeSolids(ConvexKind kind, const ConvexPoolRecipe& recipe, Random& random) {
  std::vector<Solid> solids;
  for (ConvexGeometry& convex : makeConvexPool(kind, kPool, recipe, random)) {
    Solid solid{std::move(convex), std::nullopt};
    const auto* hull = std::get_if<ConvexHull>(&solid.convex);
    if (hull != nullptr && !hull->faces().empty()) {
      solid.mesh.emplace(convexHullOf(hull->vertices()), hull->hasVolume());
    }
    solids.push_back(std::move(solid));
  }
  return solids;
}

ConvexDistance measure(const GeometryRef& a, const Pose& pose_a, const GeometryRef& b,
                       const Pose& pose_b) {
  static ConvexWorkspace workspace;
  static const auto memory = std::make_unique<MeshQueryMemory>();
  ConvexWarmStart warm;
  ConvexSearch convex{workspace, warm};
  GeometrySearch search{convex, *memory};
  return signedDistanceBetween(a, pose_a, b, pose_b, search);
}

/// What the other road says: the distance, or no more than a bound of it.
struct Truth {
  double distance{std::numeric_limits<double>::infinity()};
  bool is_exact{true};
};

void judge(const PosedConvexPair& pair, const SignedDistance& found, const Truth& truth,
           SolidTally& tally) {
  const double allowed = 2.0 * allowedError(sizeOf(pair));  // each road has its own error
  ++tally.count;
  const double joined =
      (found.point_on_b - found.point_on_a - found.distance * found.normal_a_to_b).norm();
  if (!std::isfinite(found.distance) || !std::isfinite(joined)) {
    ++tally.not_finite;
    return;
  }
  const double beyond = std::max(found.distance, 0.0) - std::max(truth.distance, 0.0);
  const double error = truth.is_exact ? std::abs(beyond) : std::max(-beyond, 0.0);
  tally.error = std::max(tally.error, error);
  if (error > allowed || (found.distance > 0.0 && joined > allowed)) {
    ++tally.wrong;
    std::printf("solids: distance %.17g, by the other road %.17g, joined %.3g\n%s", found.distance,
                truth.distance, joined, describe(pair).c_str());
  }
}

PosedConvexPair place(const ConvexGeometry& a, const ConvexGeometry& b, long i, Random& random) {
  const auto pick = static_cast<std::size_t>(i);
  return placeConvexPair(a, b, kNearnesses[pick % 4], kAlignments[(pick / 4) % 3], random);
}

SphereUnion anyUnion(const ConvexPoolRecipe& recipe, Random& random) {
  SphereTree tree;
  tree.nodes.resize(4);
  tree.nodes[0].first_child = 1;
  tree.nodes[0].child_count = 3;
  for (std::size_t i = 1; i < 4; ++i) {
    const ConvexGeometry sphere = makeConvexPool(ConvexKind::sphere, 1, recipe, random)[0];
    tree.nodes[i].radius = std::get<Sphere>(sphere).radius;
    tree.nodes[i].center = randomPoint(random, 2.0 * tree.nodes[i].radius);
    tree.nodes[i].level = 1;
  }
  return makeSphereUnion(tree);
}

}  // namespace

double sizeOf(const PosedConvexPair& pair) {
  return extentOf(*pair.a) + extentOf(*pair.b) +
         (pair.world_from_b.translation - pair.world_from_a.translation).norm() + 10.0;
}

SolidTally stressMeshes(ConvexKind other, long count, const ConvexPoolRecipe& recipe,
                        Random& random) {
  const std::vector<Solid> pool_a = makeSolids(ConvexKind::hull, recipe, random);
  const std::vector<Solid> pool_b = makeSolids(other, recipe, random);
  SolidTally tally;
  for (long i = 0; i < count; ++i) {
    const Solid& a = pool_a[random() % kPool];
    const Solid& b = pool_b[random() % kPool];
    const PosedConvexPair pair = place(a.convex, b.convex, i, random);
    const ConvexDistance truth =
        measureCold(a.convex, pair.world_from_a, b.convex, pair.world_from_b);
    const ConvexDistance found = measure(a.ref(), pair.world_from_a, b.ref(), pair.world_from_b);
    judge(pair, found.measured, {truth.measured.distance, truth.quality == Quality::exact}, tally);
  }
  return tally;
}

SolidTally stressUnions(ConvexKind other, long count, const ConvexPoolRecipe& recipe,
                        Random& random) {
  const std::vector<Solid> pool_b = makeSolids(other, recipe, random);
  SolidTally tally;
  for (long pick = 0; pick < count; ++pick) {
    const SphereUnion spheres = anyUnion(recipe, random);
    const Solid& b = pool_b[random() % kPool];
    const ConvexGeometry whole = Sphere{spheres.reach[0]};
    const PosedConvexPair pair = place(whole, b.convex, pick, random);
    Truth truth;
    for (std::size_t i = 1; i < spheres.tree.nodes.size(); ++i) {
      const SphereNode& node = spheres.tree.nodes[i];
      const Pose at{Eigen::Matrix3d::Identity(), pair.world_from_a * node.center};
      const ConvexDistance leaf = measureCold(Sphere{node.radius}, at, b.convex, pair.world_from_b);
      truth.distance = std::min(truth.distance, leaf.measured.distance);
      truth.is_exact = truth.is_exact && leaf.quality == Quality::exact;
    }
    const ConvexDistance found = measure(&spheres, pair.world_from_a, b.ref(), pair.world_from_b);
    judge(pair, found.measured, truth, tally);
  }
  return tally;
}

}  // namespace collision_monitor::test
