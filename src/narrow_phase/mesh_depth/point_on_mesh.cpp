// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/mesh_depth/point_on_mesh.h"

#include <cmath>

#include "collision_monitor/geometry/ids.h"
#include "geometry/point_triangle.h"
#include "narrow_phase/mesh/nearest_search.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

PointOnMesh answerOf(const NearestSearch& search) noexcept {
  if (search.nearest.a == kNone) {
    return {std::numeric_limits<double>::infinity(), Vector3d::Zero(), kNone, search.visits};
  }
  return {std::sqrt(search.best.squared_distance), search.best.on_a, search.nearest.a,
          search.visits};
}

void measureTriangle(const MeshTree& mesh, std::uint32_t triangle, const Vector3d& point,
                     NearestSearch& search) noexcept {
  const Triangle& corners = mesh.triangles()[triangle];
  const Vector3d nearest = closestPointOnTriangle(point, corners[0], corners[1], corners[2]);
  const double squared = (nearest - point).squaredNorm();
  if (squared < search.best.squared_distance) {
    search.best = {squared, nearest, point};
    search.nearest.a = triangle;
  }
}

PlacedBound boundOfPoint(const MeshTree& mesh, const Vector3d& point) noexcept {
  const Pose centered{Eigen::Matrix3d::Identity(), point - mesh.center()};
  const Eigen::Vector3f zero = Eigen::Vector3f::Zero();
  return place(makePlacement(centered, mesh.radius() + centered.translation.norm()),
               {zero, zero, Eigen::Vector3f::UnitZ(), 0.0F, 0.0F});
}

}  // namespace

PointOnMesh nearestOnMesh(const MeshTree& mesh, const Vector3d& point, std::uint32_t start,
                          const PointQueryLimits& limits, MeshQueryMemory& memory) noexcept {
  NearestSearch search;
  search.best.squared_distance = limits.stop_beyond * limits.stop_beyond;
  if (start < mesh.triangles().size()) {
    measureTriangle(mesh, start, point, search);
  }
  if (search.best.squared_distance <= limits.cutoff * limits.cutoff) {
    return answerOf(search);
  }
  const PlacedBound bound = boundOfPoint(mesh, point);
  NodePairQueue from_root(memory);
  from_root.push({0.0F, 0, 0});
  constexpr std::uint32_t kNoBudget = std::numeric_limits<std::uint32_t>::max();
  branchAndBound(
      limits.cutoff, kNoBudget, from_root, search,
      [&](const MeshQueryMemory::NodePair& next, float limit, NodePairQueue& queue) {
        const std::uint32_t child = childOf(mesh, next.a);
        if (isTriangle(child)) {
          measureTriangle(mesh, triangleAt(child), point, search);
          return;
        }
        NodeBounds children;
        const std::uint32_t nearer = boundNearer(mesh.nodes()[child], bound, limit, children);
        queue.pushNearer(children, nearer, [&](std::uint32_t slot) {
          return MeshQueryMemory::NodePair{children.squared[slot], (child << kSlotBits) + slot, 0};
        });
      });
  return answerOf(search);
}

}  // namespace collision_monitor
