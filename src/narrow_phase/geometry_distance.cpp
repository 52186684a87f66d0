// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/geometry_distance.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "geometry/bvh/visit_held.h"
#include "narrow_phase/closed_form/core_distance.h"
#include "narrow_phase/mesh_depth/mesh_depth.h"
#include "narrow_phase/mesh_depth/mesh_way_out.h"

namespace collision_monitor {
namespace {

template <class Geometry>
struct Placed {
  const Geometry& geometry;
  const Pose& world_from_body;
};

using PlacedTree = Placed<MeshTree>;
using PlacedSolid = Placed<ConvexGeometry>;
using PlacedUnion = Placed<SphereUnion>;

template <class Other>
bool isHalfSpace(const Other&) noexcept {
  return false;
}
bool isHalfSpace(const ConvexGeometry& geometry) noexcept {
  return std::holds_alternative<HalfSpace>(geometry);
}

ConvexDistance swappedAnswer(const ConvexDistance& ab) noexcept {
  return {swapped(ab.measured), ab.quality};
}

ConvexDistance measure(const PlacedSolid& a, const PlacedSolid& b,
                       GeometrySearch& search) noexcept {
  return signedDistanceBetween(a.geometry, a.world_from_body, b.geometry, b.world_from_body,
                               search.convex);
}

ConvexDistance measure(const PlacedTree& a, const PlacedTree& b, GeometrySearch& search) noexcept {
  const PlacedMesh mesh_a{a.geometry, a.world_from_body};
  const PlacedMesh mesh_b{b.geometry, b.world_from_body};
  const MeshDistance found = distanceBetween(mesh_a, mesh_b, search.mesh);
  if (found.state == MeshState::unknown) {
    return {};
  }
  if (found.state != MeshState::overlapping) {
    return {found.measured, Quality::exact};
  }
  constexpr std::uint32_t kPoints = 200;
  KeptDepth nothing;
  const MeshDepth deep = depthOf(mesh_a, mesh_b, search.mesh, nothing, kPoints);
  const WayOut out = wayOut(mesh_a, mesh_b, deep.deepest.normal_a_to_b);
  const Eigen::Vector3d& point = found.measured.point_on_a;
  return {{-out.length, point, point - out.length * out.direction, out.direction},
          Quality::lower_bound};
}

ConvexDistance measure(const PlacedTree& a, const PlacedSolid& b, GeometrySearch& search) noexcept {
  const MeshDistance found =
      distanceBetween(PlacedMesh{a.geometry, a.world_from_body},
                      PlacedConvex{b.geometry, b.world_from_body}, search.mesh);
  if (found.state == MeshState::unknown) {
    return {};
  }
  const bool is_exact = found.state == MeshState::exact || isHalfSpace(b.geometry);
  return {found.measured, is_exact ? Quality::exact : Quality::estimate};
}

ConvexDistance measure(const PlacedSolid& a, const PlacedTree& b, GeometrySearch& search) noexcept {
  return swappedAnswer(measure(b, a, search));
}

// Descends a union and keeps the least answer of a leaf. Each node is one sphere: a leaf's own, or
// one that holds all leaves below.
template <class Other>
void descend(const PlacedUnion& a, std::uint32_t index, const Placed<Other>& other,
             GeometrySearch& search, ConvexDistance& least) noexcept {
  const SphereNode& node = a.geometry.tree.nodes[index];
  const bool is_leaf = node.child_count == 0;
  const ConvexGeometry sphere = Sphere{is_leaf ? node.radius : a.geometry.reach[index]};
  const Pose at{Eigen::Matrix3d::Identity(), a.world_from_body * node.center};
  forget(search.convex.warm);
  const ConvexDistance here = measure(PlacedSolid{sphere, at}, other, search);
  if (least.quality != Quality::unknown && here.measured.distance >= least.measured.distance) {
    return;
  }
  if (is_leaf) {
    least = here;
    return;
  }
  for (std::uint32_t i = 0; i < node.child_count; ++i) {
    descend(a, node.first_child + i, other, search, least);
  }
}

template <class Other>
ConvexDistance measureUnion(const PlacedUnion& a, const Placed<Other>& b,
                            GeometrySearch& search) noexcept {
  ConvexDistance least;
  descend(a, 0, b, search, least);
  if (least.measured.distance < 0.0 && !isHalfSpace(b.geometry)) {
    least.quality = Quality::estimate;
  }
  return least;
}

template <class Other>
ConvexDistance measure(const PlacedUnion& a, const Placed<Other>& b,
                       GeometrySearch& search) noexcept {
  return measureUnion(a, b, search);
}

template <class Other>
ConvexDistance measure(const Placed<Other>& a, const PlacedUnion& b,
                       GeometrySearch& search) noexcept {
  return swappedAnswer(measureUnion(b, a, search));
}

ConvexDistance measure(const PlacedUnion& a, const PlacedUnion& b,
                       GeometrySearch& search) noexcept {
  return measureUnion(a, b, search);
}

}  // namespace

SphereUnion makeSphereUnion(SphereTree tree) {
  if (tree.nodes.empty()) {
    throw std::invalid_argument("a sphere tree without nodes is no solid");
  }
  SphereUnion made{std::move(tree), {}};
  const auto& nodes = made.tree.nodes;
  made.reach.resize(nodes.size());
  constexpr double kUp = 1.0 + 1e-15;
  for (std::size_t i = nodes.size(); i-- > 0;) {  // children come after their parents
    made.reach[i] = nodes[i].child_count == 0 ? nodes[i].radius : 0.0;
    for (std::uint32_t k = 0; k < nodes[i].child_count; ++k) {
      const std::size_t child = nodes[i].first_child + k;
      const double beyond = (nodes[child].center - nodes[i].center).norm() + made.reach[child];
      made.reach[i] = std::max(made.reach[i], kUp * beyond);
    }
  }
  return made;
}

ConvexDistance signedDistanceBetween(const GeometryRef& a, const Pose& world_from_a,
                                     const GeometryRef& b, const Pose& world_from_b,
                                     GeometrySearch& search) noexcept {
  if (!isFinite(world_from_a) || !isFinite(world_from_b)) {
    return {};
  }
  const auto with_a = [&](const auto* geometry_a) noexcept {
    const auto with_b = [&](const auto* geometry_b) noexcept {
      using A = std::decay_t<decltype(*geometry_a)>;
      using B = std::decay_t<decltype(*geometry_b)>;
      return measure(Placed<A>{*geometry_a, world_from_a}, Placed<B>{*geometry_b, world_from_b},
                     search);
    };
    return visitHeld(with_b, b);
  };
  return visitHeld(with_a, a);
}

}  // namespace collision_monitor
