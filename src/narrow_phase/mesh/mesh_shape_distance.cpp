// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "collision_monitor/geometry/ids.h"
#include "geometry/bvh/visit_held.h"
#include "narrow_phase/closed_form/core_distance.h"
#include "narrow_phase/gjk/convex_core.h"
#include "narrow_phase/mesh/mesh_and_core.h"
#include "narrow_phase/mesh_front/front_search.h"
#include "narrow_phase/mesh_inside/mesh_inside.h"
#include "narrow_phase/triangle/triangle_core.h"
#include "narrow_phase/triangle/triangle_edges.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

// Answer for the cores; A is the mesh. A core inside the solid gets out through the nearest point
// of the surface, or through a hole that is nearer.
SignedDistance coresOf(const MeshAndCore& pair, const NearestSearch& search,
                       const CoreInMesh& lies) noexcept {
  const PointPair& best = search.best;
  const double distance = std::sqrt(best.squared_distance);
  const Vector3d delta = best.on_b - best.on_a;
  const double length = delta.norm();  // near points carry more rounding
  if (distance > pair.rounding && length > 0.0) {
    if (lies.is_inside && lies.hold < distance) {
      return {-lies.hold, best.on_b - lies.hold / length * delta, best.on_b, -1.0 / length * delta};
    }
    if (lies.is_inside) {
      return {-distance, best.on_a, best.on_b, -1.0 / length * delta};
    }
    const double bound = std::sqrt(search.squaredBound());
    const Vector3d on_b = bound < distance ? best.on_a + bound / length * delta : best.on_b;
    return {bound, best.on_a, on_b, 1.0 / length * delta};
  }
  const Vector3d normal = anyNormalOf(prepare(pair.mesh.triangles()[search.nearest.a]));
  return {0.0, best.on_a, best.on_a, pair.core_from_mesh.rotation * normal};
}

void report(const MeshAndCore& pair, const NearestSearch& search, const CoreInMesh& lies,
            MeshDistance& answer) noexcept {
  const double radius = pair.radius;
  const bool is_inside = lies.is_inside;
  answer.nearest = search.nearest;
  const double core_distance =
      std::sqrt(std::min(search.best.squared_distance, search.squared_open));
  const bool meets = search.best.squared_distance <= radius * radius;
  if (search.nearest.a != kNone && (search.isComplete() || (meets && !is_inside))) {
    answer.measured = inflated(coresOf(pair, search, lies), 0.0, radius);
    answer.shortfall = std::sqrt(search.best.squared_distance) - std::sqrt(search.squaredBound());
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

// Reports the limit itself, not less by rounding.
void reportLimit(const NearestSearch& search, double stop_beyond, MeshDistance& answer) noexcept {
  if (answer.state == MeshState::lower_bound && search.nearest.a == kNone && search.isComplete() &&
      stop_beyond + search.radius >= 0.0) {
    answer.measured.distance = stop_beyond;
  }
}

// The query of a mesh and a core for searchFromFront.
struct CoreQuery {
  const MeshAndCore& pair;

  static bool areParts(Slot, Slot) noexcept { return false; }
  static double gapOfParts(Slot, Slot, const Vector3d&) noexcept { return 0.0; }
  static PartGap searchGapOfParts(Slot, Slot, double) noexcept { return {}; }
  bool areTriangles(Slot a, Slot) const noexcept { return isTriangle(childOf(pair.mesh, a)); }
  std::uint32_t triangleIn(Slot slot) const noexcept {
    return triangleAt(childOf(pair.mesh, slot));
  }
  void measure(const MeshQueryMemory::NodePair& bounds, NearestSearch& search) const noexcept {
    measureTriangle(pair, triangleIn(bounds.a), bounds, search);
  }
  void choose(Slot a, Slot, OpenedPair& opened) const noexcept {
    collision_monitor::choose(pair, a, opened);
  }
  const Eigen::Matrix3d& restingFromNode(const OpenedPair&) const noexcept {
    return pair.core_from_mesh.rotation;
  }
  double squaredGapAlong(const Vector3d& direction, Slot a, Slot) const noexcept {
    return collision_monitor::squaredGapAlong(direction, triangleInCore(pair, triangleIn(a)),
                                              pair.core);
  }
};

// What an earlier query left.
struct CoreStart {
  TrianglePair nearest;
  MeshFront* front{nullptr};
};

// A core that traveled less than its distance to the surface is still inside or still outside. But
// its nearest point is another one now, and may have passed through a hole of an open mesh.
CoreInMesh lookInside(const MeshAndCore& pair, const NearestSearch& search, double step,
                      MeshQueryMemory& memory) noexcept {
  CoreInMesh lies;
  if (search.front == nullptr || !(step < std::min(search.front->apart, search.front->outside))) {
    return collision_monitor::lookInside(pair, search, memory);
  }
  lies.hold = search.front->outside - step;
  if (pair.mesh.openSurface()) {
    const PointInMesh point =
        collision_monitor::lookInside(pair.mesh, pair.mesh_from_core * search.best.on_b, memory);
    lies.visits = point.visits;
    lies.is_inside = point.is_inside;
    lies.hold = point.is_inside ? point.hold
                                : std::min(lies.hold, std::max(point.hold, leastHold(pair.mesh)));
  }
  return lies;
}

// @return [m] by how much the core traveled since the last query
double searchCore(const MeshAndCore& pair, const CoreStart& start, std::uint32_t visit_budget,
                  MeshQueryMemory& memory, NearestSearch& search) noexcept {
  if (start.front != nullptr) {
    const double step = follow({pair.core_from_mesh, pair.mesh, pair.box.center(),
                                0.5 * pair.box.diagonal().norm(), -1.0, pair.rounding},
                               *start.front);
    NodePairQueue queue(memory);
    searchFromFront(CoreQuery{pair}, step, pair.rounding, visit_budget, queue, search);
    return step;
  }
  if (start.nearest.a < pair.mesh.triangles().size()) {
    measureTriangle(pair, start.nearest.a, search.bounds, search);
  }
  searchFromRoot(pair, 0.0, visit_budget, memory, search);
  return kInfinity;
}

void keepLies(const NearestSearch& search, const CoreInMesh& lies) noexcept {
  if (search.front != nullptr) {
    const double apart = std::sqrt(std::min(search.squaredBound(), search.squared_open));
    search.front->apart = lies.is_inside || !std::isfinite(apart) ? 0.0 : apart;
    search.front->outside = lies.hold;
  }
}

MeshDistance measureCore(const PlacedMesh& a, const InflatedCore& b, const Pose& world_from_b,
                         MeshQueryMemory& memory, const CoreStart& start,
                         const MeshQueryLimits& limits) noexcept {
  const MeshAndCore pair = makeMeshAndCore(a, b, world_from_b);
  MeshDistance answer;
  NearestSearch search;
  const double core_limit = std::max(limits.stop_beyond + b.radius, 0.0);
  search.best.squared_distance = core_limit * core_limit;
  search.tolerance = std::max(limits.tolerance, pair.rounding);
  search.rounding = pair.rounding;
  search.radius = b.radius;
  search.at_least = limits.at_least > 0.0 ? limits.at_least + b.radius : 0.0;
  search.best.on_b = anyPointOf(b.core);
  if (start.front != nullptr) {
    search.front = start.front;
    search.moving = movingBounds(pair.mesh, true);
  }
  const double step = searchCore(pair, start, limits.visit_budget, memory, search);
  const CoreInMesh lies = lookInside(pair, search, step, memory);
  keepLies(search, lies);
  if (lies.is_inside && search.nearest.a == kNone) {
    // The core is inside, and the surface is beyond the limit: searches again without the limit.
    search.front = nullptr;
    search.best.squared_distance = std::numeric_limits<double>::infinity();
    searchFromRoot(pair, 0.0, limits.visit_budget, memory, search);
  }
  answer.visits = search.visits + lies.visits;
  answer.outside = lies.is_inside ? kInfinity : lies.hold;
  report(pair, search, lies, answer);
  reportLimit(search, limits.stop_beyond, answer);
  answer.measured = placed(world_from_b, answer.measured);
  return answer;
}

MeshDistance measureConvex(const PlacedMesh& a, const PlacedConvex& b, MeshQueryMemory& memory,
                           const CoreStart& start, const MeshQueryLimits& limits) noexcept {
  if (!isFinite(a.world_from_mesh) || !isFinite(b.world_from_body)) {
    return {};
  }
  const auto measure = [&](const auto& geometry) noexcept {
    if constexpr (std::is_same_v<decltype(geometry), const HalfSpace&>) {
      return measureHalfSpace(a, b.world_from_body);
    } else {
      return measureCore(a, inflatedCoreOf(geometry), b.world_from_body, memory, start, limits);
    }
  };
  return visitHeld(measure, b.geometry);
}

}  // namespace

MeshDistance distanceBetween(const PlacedMesh& a, const PlacedShape& b, MeshQueryMemory& memory,
                             const TrianglePair& start, const MeshQueryLimits& limits) noexcept {
  if (!isFinite(a.world_from_mesh) || !isFinite(b.world_from_shape)) {
    return {};
  }
  const ConvexCore core{ConvexCore::Kind::box, coreHalfExtents(b.shape)};
  return measureCore(a, {core, radiusOf(b.shape)}, b.world_from_shape, memory, {start}, limits);
}

MeshDistance distanceBetween(const PlacedMesh& a, const PlacedConvex& b, MeshQueryMemory& memory,
                             const TrianglePair& start, const MeshQueryLimits& limits) noexcept {
  return measureConvex(a, b, memory, {start}, limits);
}

MeshDistance distanceBetween(const PlacedMesh& a, const PlacedConvex& b, MeshQueryMemory& memory,
                             MeshFront& front, const MeshQueryLimits& limits) noexcept {
  return measureConvex(a, b, memory, {{}, &front}, limits);
}

}  // namespace collision_monitor
