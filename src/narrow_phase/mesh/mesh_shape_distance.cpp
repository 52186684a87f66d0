// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "collision_monitor/geometry/visit_held.h"
#include "geometry/constants.h"
#include "narrow_phase/convex/convex_core.h"
#include "narrow_phase/core_distance.h"
#include "narrow_phase/mesh/mesh_inside.h"
#include "narrow_phase/mesh/mesh_support.h"
#include "narrow_phase/mesh/nearest_search.h"
#include "narrow_phase/mesh/triangle_core.h"
#include "narrow_phase/mesh/triangle_edges.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

// A mesh and a core, seen from the core.
struct MeshAndCore {
  const MeshTree& mesh;
  Pose core_from_mesh;
  ConvexCore core;
  double radius;    // [m] of the shape about its core
  double rounding;  // [m] a core this near touches the surface
};

// The box that holds the core, in its frame.
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

// A hull need not hold the origin of its frame.
Vector3d anyPointOf(const ConvexCore& core) noexcept {
  return core.kind == ConvexCore::Kind::hull ? core.hull->vertices().front()
                                             : Vector3d(Vector3d::Zero());
}

PlacedBound boundOfCore(const MeshAndCore& pair) noexcept {
  const Eigen::AlignedBox3d box = boxOf(pair.core);
  const Vector3d half_extents = 0.5 * box.sizes();
  const Pose mesh_from_core = inverse(pair.core_from_mesh);
  const Pose centered{mesh_from_core.rotation, mesh_from_core * box.center() - pair.mesh.center()};
  const double size = pair.mesh.radius() + half_extents.norm() + centered.translation.norm();
  constexpr float kUp = 1.0F + 1e-6F;
  const Eigen::Vector3f half = kUp * half_extents.cast<float>();
  return place(makePlacement(centered, size),
               {Eigen::Vector3f::Zero(), half, {0.0F, 0.0F, 1.0F / kUp}, 0.0F, half.z()});
}

void measureTriangle(const MeshAndCore& pair, std::uint32_t triangle,
                     NearestSearch& search) noexcept {
  offer({triangle, TrianglePair::kNone}, search.bounds, search,
        [&](const PointPair& start, double) {
          const Triangle& in_mesh = pair.mesh.triangles()[triangle];
          const Triangle in_core = {pair.core_from_mesh * in_mesh[0],
                                    pair.core_from_mesh * in_mesh[1],
                                    pair.core_from_mesh * in_mesh[2]};
          const PointPair found = nearestPoints(in_core, pair.core, start);
          return TriangleDistance{found, found.squared_distance};
        });
}

void openNode(const MeshAndCore& pair, std::uint32_t node, const PlacedBound& core, float limit,
              WaitingPairs& waiting) noexcept {
  NodeBounds children;
  const std::uint32_t nearer = boundNearer(pair.mesh.nodes()[node], core, limit, children);
  waiting.pushNearer(children, nearer, [node](float bound, std::uint32_t slot) {
    return MeshQueryMemory::Waiting{bound, (node << kSlotBits) + slot, 0};
  });
}

void searchFrom(const MeshAndCore& pair, std::uint32_t visit_budget, MeshQueryMemory& memory,
                NearestSearch& search) noexcept {
  const PlacedBound core = boundOfCore(pair);
  WaitingPairs from_root(memory);
  from_root.push({0.0F, 0, 0});
  searchNearest(pair.rounding, visit_budget, from_root, search,
                [&](const MeshQueryMemory::Waiting& next, float limit, WaitingPairs& waiting) {
                  const std::uint32_t child = childOf(pair.mesh, next.a);
                  if (isTriangle(child)) {
                    measureTriangle(pair, triangleAt(child), search);
                  } else {
                    openNode(pair, child, core, limit, waiting);
                  }
                });
}

// How the core lies in the inside of the mesh.
struct CoreInMesh {
  bool is_inside{false};
  double hold{kInfinity};  // [m] as of a point that is inside, or the least of all that are not
  std::uint32_t visits{0};
};

// Cores: the mesh is A. A core inside the solid has the surface behind it, and the way out is
// through the nearest point of it, or through a hole that is nearer.
SignedDistance coresOf(const MeshAndCore& pair, const NearestSearch& search,
                       const CoreInMesh& lies) noexcept {
  const PointPair& best = search.best;
  const double distance = std::sqrt(best.squared_distance);
  const Vector3d way = best.on_b - best.on_a;
  const double length = way.norm();  // where they hardly part, the points are rounded more
  if (distance > pair.rounding && length > 0.0) {
    if (lies.is_inside && lies.hold < distance) {
      return {-lies.hold, best.on_b - lies.hold / length * way, best.on_b, -1.0 / length * way};
    }
    const double sign = lies.is_inside ? -1.0 : 1.0;
    return {sign * distance, best.on_a, best.on_b, sign / length * way};
  }
  const Vector3d normal = anyNormalOf(prepare(pair.mesh.triangles()[search.nearest.a]));
  return {0.0, best.on_a, best.on_a, pair.core_from_mesh.rotation * normal};
}

// The core's frame. Calls visit(point) for its corners, or those of a round or many-cornered one
// that are farthest along axes and diagonals, until one returns true.
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

// A closed mesh that is not crossed holds all of the core or nothing.
CoreInMesh lookInside(const MeshAndCore& pair, const NearestSearch& search,
                      MeshQueryMemory& memory) noexcept {
  CoreInMesh lies;
  if (!pair.mesh.hasInside()) {
    return lies;
  }
  const Pose mesh_from_core = inverse(pair.core_from_mesh);
  const auto look = [&](const Vector3d& in_core) noexcept {
    const PointInMesh point = lookInside(pair.mesh, mesh_from_core * in_core, memory);
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

void report(const MeshAndCore& pair, const NearestSearch& search, const CoreInMesh& lies,
            MeshDistance& answer) noexcept {
  const double radius = pair.radius;
  const bool is_inside = lies.is_inside;
  answer.nearest = search.nearest;
  const double core_distance =
      std::sqrt(std::min(search.best.squared_distance, search.squared_open));
  const bool meets = search.best.squared_distance <= radius * radius;
  if (search.nearest.a != TrianglePair::kNone && (search.isComplete() || (meets && !is_inside))) {
    answer.measured = swept(coresOf(pair, search, lies), 0.0, radius);
    answer.state = answer.measured.distance > 0.0 ? MeshState::exact : MeshState::overlapping;
  } else if (!std::isfinite(core_distance)) {
    answer.state = MeshState::unknown;
  } else if (is_inside) {
    answer.measured.distance = -std::min(core_distance, lies.hold) - radius;
    answer.state = MeshState::overlapping;
  } else {
    answer.measured.distance = core_distance - radius;
    answer.state = MeshState::lower_bound;
  }
}

MeshDistance measureCore(const PlacedMesh& a, const SweptCore& b, const Pose& world_from_b,
                         MeshQueryMemory& memory, const TrianglePair& start,
                         const MeshQueryLimits& limits) noexcept {
  const Pose core_from_mesh = inverse(world_from_b) * a.world_from_mesh;
  const double size = a.tree.radius() + a.tree.center().norm() + core_from_mesh.translation.norm();
  const MeshAndCore pair{a.tree, core_from_mesh, b.core, b.radius, kTouchingShare * size};
  MeshDistance answer;
  NearestSearch search;
  const double core_limit = std::max(limits.stop_beyond + b.radius, 0.0);
  search.best.squared_distance = core_limit * core_limit;
  search.best.on_b = anyPointOf(b.core);
  if (start.a < a.tree.triangles().size()) {
    measureTriangle(pair, start.a, search);
  }
  searchFrom(pair, limits.visit_budget, memory, search);
  const CoreInMesh lies = lookInside(pair, search, memory);
  if (lies.is_inside && search.nearest.a == TrianglePair::kNone) {
    // All of the surface is farther than was asked for, and so is the way out.
    search.best.squared_distance = std::numeric_limits<double>::infinity();
    searchFrom(pair, limits.visit_budget, memory, search);
  }
  answer.visits = search.visits + lies.visits;
  answer.outside = lies.is_inside ? kInfinity : lies.hold;
  report(pair, search, lies, answer);
  answer.measured = placed(world_from_b, answer.measured);
  return answer;
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

}  // namespace

MeshDistance distanceBetween(const PlacedMesh& a, const PlacedShape& b, MeshQueryMemory& memory,
                             const TrianglePair& start, const MeshQueryLimits& limits) noexcept {
  if (!isFinite(a.world_from_mesh) || !isFinite(b.world_from_shape)) {
    return {};
  }
  const ConvexCore core{ConvexCore::Kind::box, coreHalfExtents(b.shape)};
  return measureCore(a, {core, radiusOf(b.shape)}, b.world_from_shape, memory, start, limits);
}

MeshDistance distanceBetween(const PlacedMesh& a, const PlacedConvex& b, MeshQueryMemory& memory,
                             const TrianglePair& start, const MeshQueryLimits& limits) noexcept {
  if (!isFinite(a.world_from_mesh) || !isFinite(b.world_from_body)) {
    return {};
  }
  const auto measure = [&](const auto& geometry) noexcept {
    if constexpr (std::is_same_v<decltype(geometry), const HalfSpace&>) {
      return measureHalfSpace(a, b.world_from_body);
    } else {
      return measureCore(a, sweptCoreOf(geometry), b.world_from_body, memory, start, limits);
    }
  };
  return visitHeld(measure, b.geometry);
}

}  // namespace collision_monitor
