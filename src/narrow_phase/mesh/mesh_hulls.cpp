// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/mesh/mesh_hulls.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "collision_monitor/geometry/ids.h"
#include "geometry/bvh/visit_held.h"
#include "narrow_phase/closed_form/core_distance.h"
#include "narrow_phase/gjk/convex_core.h"
#include "narrow_phase/gjk/gjk.h"
#include "narrow_phase/mesh_depth/point_on_mesh.h"
#include "narrow_phase/warm_start/distance_from_warm_start.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

// Share of the sizes: points this near to a triangle are on it.
constexpr double kOnSurface = 1e-13;

std::optional<InflatedCore> coreOf(const ConvexGeometry& around) noexcept {
  const auto take = [](const auto& held) noexcept -> std::optional<InflatedCore> {
    if constexpr (std::is_same_v<decltype(held), const HalfSpace&>) {
      return std::nullopt;
    } else {
      return inflatedCoreOf(held);
    }
  };
  return visitHeld(take, around);
}

struct CoreGap {
  MeshState state;
  SignedDistance cores;
};

// Runs a search. Cores that meet get no depth.
CoreGap searchGap(const PlacedCore& a, const PlacedCore& b, double cutoff,
                  ConvexWarmStart& warm) noexcept {
  ConvexPair pair = makeConvexPair(a.core, a.world_from_core, b.core, b.world_from_core);
  const GjkResult found = runGjk(pair, warm, {cutoff});
  keepWarm(found.simplex.vertices.data(), found.simplex.size, pair, warm);
  if (found.state == GjkResult::State::overlapping || !(found.lower > touchingDistance(pair))) {
    return {MeshState::unknown, {}};
  }
  if (found.state != GjkResult::State::settled) {
    SignedDistance bound;
    bound.distance = found.lower;
    return {MeshState::lower_bound, bound};
  }
  const Simplex& simplex = found.simplex;
  const Vector3d point_on_a = simplex.pointOnA();
  return {
      MeshState::exact,
      placed(a.world_from_core, {simplex.distance, point_on_a,
                                 point_on_a + simplex.distance * simplex.normal, simplex.normal})};
}

CoreGap gapBetween(const PlacedCore& a, const PlacedCore& b, double cutoff, bool asks_nearest,
                   ConvexWarmStart& warm) noexcept {
  const auto confirmed = asks_nearest ? distanceFromWarmStart(a, b, warm) : std::nullopt;
  return confirmed ? CoreGap{MeshState::exact, confirmed->cores} : searchGap(a, b, cutoff, warm);
}

bool isOpen(const HeldSurface& surface) noexcept {
  return surface.mesh != nullptr && surface.mesh->openSurface();
}

// [m] How far a point of the solid is off the surface; infinity if that is more than `allowed`.
// Tries the triangle of the last point first.
double offSurface(const HeldSurface& surface, const Vector3d& point, double allowed,
                  MeshQueryMemory& memory, std::uint32_t& last, std::uint32_t& visits) noexcept {
  if (surface.mesh == nullptr) {
    return 0.0;
  }
  const MeshTree& mesh = *surface.mesh;
  const Vector3d in_mesh = inverse(surface.world_from_body) * point;
  const double on_surface = kOnSurface * (mesh.radius() + mesh.center().norm() +
                                          surface.world_from_body.translation.norm());
  const PointOnMesh found =
      nearestOnMesh(mesh, in_mesh, last, {0.5 * on_surface, std::max(on_surface, allowed)}, memory);
  visits += 1 + found.visits;
  if (found.triangle == kNone) {
    return std::numeric_limits<double>::infinity();
  }
  last = found.triangle;
  return found.distance < on_surface ? 0.0 : found.distance;
}

// Accepts the nearest points of the solids if the surfaces are within the tolerance of them, and
// the distance is no less than half of that of the surfaces.
void takePoints(const HeldSurface& a, const HeldSurface& b, double tolerance,
                MeshQueryMemory& memory, TrianglePair& nearest, MeshDistance& answer) noexcept {
  const double allowed = std::min(tolerance, answer.measured.distance);
  const double off_a =
      offSurface(a, answer.measured.point_on_a, allowed, memory, nearest.a, answer.visits);
  if (!(off_a < std::numeric_limits<double>::infinity())) {
    return;
  }
  const double off_b =
      offSurface(b, answer.measured.point_on_b, allowed - off_a, memory, nearest.b, answer.visits);
  if (off_b < std::numeric_limits<double>::infinity()) {
    answer.state = MeshState::exact;
    answer.shortfall = off_a + off_b;
    answer.nearest = nearest;
  }
}

}  // namespace

MeshDistance distanceByHulls(const HeldSurface& a, const HeldSurface& b, const HullGoal& goal,
                             MeshQueryMemory& memory, const HullMemory& last) noexcept {
  const std::optional<InflatedCore> core_a = coreOf(a.around);
  const std::optional<InflatedCore> core_b = coreOf(b.around);
  MeshDistance answer;
  if (!core_a || !core_b || !isFinite(a.world_from_body) || !isFinite(b.world_from_body)) {
    return answer;
  }
  const double radii = core_a->radius + core_b->radius;
  const CoreGap gap = gapBetween({core_a->core, a.world_from_body, last.warm.vertex_of_a},
                                 {core_b->core, b.world_from_body, last.warm.vertex_of_b},
                                 goal.stop_beyond + radii, goal.asks_nearest, last.warm);
  if (gap.state == MeshState::unknown || !(gap.cores.distance > radii)) {
    return answer;
  }
  answer.state = MeshState::lower_bound;
  answer.measured = inflated(gap.cores, core_a->radius, core_b->radius);
  // What must come through the other's hull first cannot be inside before.
  answer.outside = isOpen(a) || isOpen(b) ? answer.measured.distance : answer.outside;
  if (gap.state == MeshState::exact && answer.measured.distance < goal.stop_beyond) {
    takePoints(a, b, goal.tolerance, memory, last.nearest, answer);
  }
  return answer;
}

}  // namespace collision_monitor
