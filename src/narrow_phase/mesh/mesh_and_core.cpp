// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/mesh/mesh_and_core.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "collision_monitor/geometry/ids.h"
#include "narrow_phase/mesh_depth/mesh_support.h"
#include "narrow_phase/mesh_inside/mesh_inside.h"
#include "narrow_phase/triangle/triangle_core.h"
#include "narrow_phase/triangle/triangle_edges.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

// The box about the core. Frames: the core's.
Eigen::AlignedBox3d boxOf(const ConvexCore& core) noexcept {
  if (core.kind != ConvexCore::Kind::hull) {
    return {-core.half_extents, core.half_extents};
  }
  Eigen::AlignedBox3d box;
  for (const Vector3d& vertex : core.hull->vertices()) {
    box.extend(vertex);
  }
  return box;
}

PlacedBound boundOfCore(const MeshTree& mesh, const Pose& mesh_from_core,
                        const Eigen::AlignedBox3d& box) noexcept {
  const Vector3d half_extents = 0.5 * box.sizes();
  const Pose centered{mesh_from_core.rotation, mesh_from_core * box.center() - mesh.center()};
  const double size = mesh.radius() + half_extents.norm() + centered.translation.norm();
  constexpr float kUp = 1.0F + 1e-6F;
  const Eigen::Vector3f half = kUp * half_extents.cast<float>();
  return place(makePlacement(centered, size),
               {Eigen::Vector3f::Zero(), half, {0.0F, 0.0F, 1.0F / kUp}, 0.0F, half.z()});
}

// Calls visit(point) until it returns true: for the corners of a box, or the points of a cylinder
// or a hull that are farthest along axes and diagonals. Frames: the core's.
template <class Visit>
void forProbes(const ConvexCore& core, const Visit& visit) noexcept {
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3d along((corner & 1) != 0 ? 1.0 : -1.0, (corner & 2) != 0 ? 1.0 : -1.0,
                         (corner & 4) != 0 ? 1.0 : -1.0);
    const Vector3d axis = along.x() * Vector3d::Unit(corner % 3);
    if (core.kind == ConvexCore::Kind::hull) {
      const auto farthest = [&](const Vector3d& direction) noexcept {
        const auto& vertices = core.hull->vertices();
        return *std::max_element(vertices.begin(), vertices.end(),
                                 [&](const Vector3d& one, const Vector3d& other) {
                                   return direction.dot(one) < direction.dot(other);
                                 });
      };
      if (visit(farthest(along)) || visit(farthest(axis))) {
        return;
      }
    } else if (core.kind == ConvexCore::Kind::cylinder) {
      const bool is_along_x = (corner & 2) != 0;
      const Vector3d rim(is_along_x ? along.x() : 0.0, is_along_x ? 0.0 : along.x(), along.z());
      if (visit(core.half_extents.cwiseProduct(rim))) {
        return;
      }
    } else if (visit(core.half_extents.cwiseProduct(along))) {
      return;
    }
  }
}

}  // namespace

MeshAndCore makeMeshAndCore(const PlacedMesh& a, const InflatedCore& b,
                            const Pose& world_from_b) noexcept {
  const Pose core_from_mesh = inverse(world_from_b) * a.world_from_mesh;
  const Pose mesh_from_core = inverse(core_from_mesh);
  const double size = a.tree.radius() + a.tree.center().norm() + core_from_mesh.translation.norm();
  const Eigen::AlignedBox3d box = boxOf(b.core);
  return {a.tree,
          core_from_mesh,
          mesh_from_core,
          b.core,
          box,
          boundOfCore(a.tree, mesh_from_core, box),
          b.radius,
          kTouchingShare * size};
}

Vector3d anyPointOf(const ConvexCore& core) noexcept {
  return core.kind == ConvexCore::Kind::hull ? core.hull->vertices().front()
                                             : Vector3d(Vector3d::Zero());
}

Triangle triangleInCore(const MeshAndCore& pair, std::uint32_t triangle) noexcept {
  const Triangle& in_mesh = pair.mesh.triangles()[triangle];
  return {pair.core_from_mesh * in_mesh[0], pair.core_from_mesh * in_mesh[1],
          pair.core_from_mesh * in_mesh[2]};
}

void measureTriangle(const MeshAndCore& pair, std::uint32_t triangle,
                     const MeshQueryMemory::NodePair& bounds, NearestSearch& search) noexcept {
  const Triangle in_core = triangleInCore(pair, triangle);
  offer(
      {triangle, kNone}, bounds, search,
      [&](const PointPair& start, double squared_cutoff) {
        return boundedDistance(in_core, pair.core, start, squared_cutoff);
      },
      [&](const Vector3d& direction) { return squaredGapAlong(direction, in_core, pair.core); });
}

void choose(const MeshAndCore& pair, Slot slot, OpenedPair& opened) noexcept {
  const std::uint32_t node = childOf(pair.mesh, slot);
  opened.is_of_a = true;
  opened.first = node << kSlotBits;
  opened.other = 0;
  opened.node = &pair.mesh.nodes()[node];
  opened.placed = pair.bound;
}

void searchFromRoot(const MeshAndCore& pair, double cutoff, std::uint32_t visit_budget,
                    MeshQueryMemory& memory, NearestSearch& search) noexcept {
  NodePairQueue from_root(memory);
  from_root.push({0.0F, 0, 0});
  branchAndBound(std::max(pair.rounding, cutoff), visit_budget, from_root, search,
                 [&](const MeshQueryMemory::NodePair& next, float limit, NodePairQueue& queue) {
                   const std::uint32_t child = childOf(pair.mesh, next.a);
                   if (isTriangle(child)) {
                     measureTriangle(pair, triangleAt(child), next, search);
                   } else {
                     OpenedPair opened;
                     choose(pair, next.a, opened);
                     boundChildren(limit, opened);
                     queue.pushNearer(opened);
                   }
                 });
}

CoreInMesh lookInside(const MeshAndCore& pair, const NearestSearch& search, MeshQueryMemory& memory,
                      bool asks_hold) noexcept {
  CoreInMesh lies;
  if (!pair.mesh.hasInside()) {
    return lies;
  }
  const auto look = [&](const Vector3d& in_core) noexcept {
    const PointInMesh point =
        lookInside(pair.mesh, pair.mesh_from_core * in_core, memory, asks_hold);
    lies.visits += point.visits;
    lies.is_inside = point.is_inside;
    lies.hold = point.is_inside ? point.hold
                                : std::min(lies.hold, std::max(point.hold, leastHold(pair.mesh)));
    return point.is_inside;
  };
  if (!look(search.best.on_b) && !pair.mesh.isClosed()) {
    forProbes(pair.core, look);
  }
  return lies;
}

MeshDistance measureHalfSpace(const PlacedMesh& a, const Pose& world_from_half_space) noexcept {
  const Vector3d normal = -world_from_half_space.rotation.col(2);  // from the mesh down
  MeshDistance answer;
  SignedDistance& measured = answer.measured;
  measured.point_on_a = farthestAlong(a, normal);
  measured.normal_a_to_b = normal;
  measured.distance = normal.dot(world_from_half_space.translation - measured.point_on_a);
  measured.point_on_b = measured.point_on_a + measured.distance * normal;
  answer.state = measured.distance > 0.0 ? MeshState::exact : MeshState::overlapping;
  return answer;
}

}  // namespace collision_monitor
