// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/refine/measure_elements.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>

#include "collision_monitor/geometry/ids.h"
#include "geometry/bvh/visit_held.h"
#include "narrow_phase/closed_form/core_distance.h"
#include "narrow_phase/distance.h"
#include "narrow_phase/mesh_depth/mesh_depth.h"
#include "narrow_phase/mesh_depth/point_on_mesh.h"
#include "pipeline/refine/element_parts.h"

namespace collision_monitor {
namespace {

// Work of other steps, in opened node pairs.
constexpr std::uint32_t kSetUpWork = 8;   // poses and inner shapes
constexpr std::uint32_t kApartWork = 8;   // two convex geometries
constexpr std::uint32_t kDepthWork = 60;  // depth of two convex geometries
constexpr std::uint32_t kPointSteps = 4;  // depth of one point in a mesh, without nodes

bool areExact(const PlacedElement& a, const PlacedElement& b) noexcept {
  return a.element.is_exact && b.element.is_exact;
}

/// [m] The cutoff of unpadded distances: minus the paddings it is at least `search.cutoff`.
double stopBeyond(const PlacedElement& a, const PlacedElement& b,
                  const ElementSearch& search) noexcept {
  const double paddings = a.element.padding + b.element.padding;
  const double sum = search.cutoff + paddings;
  return paddings > 0.0 ? std::nextafter(sum, std::numeric_limits<double>::infinity()) : sum;
}

ElementDistance measureConvex(const PlacedElement& a, const PlacedElement& b,
                              ElementSearch& search) noexcept {
  const double cutoff =
      search.stands_alone ? stopBeyond(a, b, search) : std::numeric_limits<double>::infinity();
  ConvexSearch convex{search.scratch.convex, search.memory.warm, cutoff, search.stands_alone};
  const ConvexDistance found = signedDistanceBetween(
      *a.element.convex, a.world_from_element, *b.element.convex, b.world_from_element, convex);
  ElementDistance answer;
  answer.work = found.measured.distance > 0.0 ? kApartWork : kDepthWork;
  answer.is_complete = true;
  if (found.quality != Quality::unknown) {
    answer.quality =
        found.quality == Quality::exact && areExact(a, b) ? Quality::exact : Quality::lower_bound;
    answer.has_points = found.quality == Quality::exact || found.measured.distance < cutoff;
    answer.measured = found.measured;
  }
  return answer;
}

template <class Start>
MeshDistance searchFrom(Start& start, const PlacedElement& a, const PlacedElement& b,
                        double at_least, ElementSearch& search) noexcept {
  const MeshQueryLimits limits{stopBeyond(a, b, search), search.budget, search.tolerance,
                               !search.stands_alone,     at_least,      search.memory.held};
  if (isSimple(b)) {
    return distanceBetween(meshOf(a), convexOf(b), search.scratch.mesh, start, limits);
  }
  if (!isSimple(a)) {
    return distanceBetween(meshOf(a), meshOf(b), search.scratch.mesh, start, limits);
  }
  MeshDistance found = distanceBetween(meshOf(b), convexOf(a), search.scratch.mesh, start, limits);
  found.measured = swapped(found.measured);
  return found;
}

/// Replaces a triangle by the nearest to a point, or by one within a thousandth of `distance`.
/// @return visits
std::uint32_t moveNear(const PlacedMesh& mesh, const Eigen::Vector3d& point, double distance,
                       MeshQueryMemory& memory, std::uint32_t& triangle) noexcept {
  const PointOnMesh found = nearestOnMesh(mesh.tree, inverse(mesh.world_from_mesh) * point,
                                          triangle, {1e-3 * distance}, memory);
  triangle = found.triangle;
  return found.visits;
}

/// Where hulls are nearest, meshes are mostly near, too: a search that begins there passes over
/// most of the rest. @return visits
std::uint32_t startAtHulls(const PlacedElement& a, const PlacedElement& b,
                           const SignedDistance& hulls, ElementSearch& search) noexcept {
  if (isSimple(a) || isSimple(b)) {
    return 0;
  }
  TrianglePair& start = search.memory.nearest;
  MeshQueryMemory& memory = search.scratch.mesh;
  return moveNear(meshOf(a), hulls.point_on_a, hulls.distance, memory, start.a) +
         moveNear(meshOf(b), hulls.point_on_b, hulls.distance, memory, start.b);
}

/// Searches from the front or from the last triangles.
/// @param hulls from measureHulls
MeshDistance searchFromLast(const PlacedElement& a, const PlacedElement& b,
                            const MeshDistance& hulls, double at_least,
                            ElementSearch& search) noexcept {
  if (search.memory.front != nullptr) {
    return searchFrom(*search.memory.front, a, b, at_least, search);
  }
  const std::uint32_t visits = at_least > 0.0 ? startAtHulls(a, b, hulls.measured, search) : 0;
  TrianglePair& nearest = search.memory.nearest;
  MeshDistance found = searchFrom(nearest, a, b, at_least, search);
  found.visits += visits;
  nearest = found.nearest.a == kNone ? nearest : found.nearest;
  return found;
}

/// @param hulls from measureHulls
MeshDistance searchMeshes(const PlacedElement& a, const PlacedElement& b, const MeshDistance& hulls,
                          ElementSearch& search) noexcept {
  const double at_least = hulls.state == MeshState::lower_bound ? hulls.measured.distance : 0.0;
  MeshDistance found = searchFromLast(a, b, hulls, at_least, search);
  // What comes into an open mesh comes through the hulls first.
  found.outside = std::max(found.outside, at_least);
  return found;
}

/// Measures hulls; false if they give neither the distance nor a bound at the cutoff.
bool measureHulls(const PlacedElement& a, const PlacedElement& b, ElementSearch& search,
                  MeshDistance& found, ElementDistance& answer) noexcept {
  const double stop_beyond = stopBeyond(a, b, search);
  found = distanceByHulls(heldSurfaceOf(a), heldSurfaceOf(b), {stop_beyond, search.tolerance},
                          search.scratch.mesh, {search.memory.warm, search.memory.nearest});
  answer.work += kApartWork + found.visits;
  if (found.state != MeshState::exact && !(found.measured.distance >= stop_beyond)) {
    return false;
  }
  answer.measured = found.measured;
  answer.shortfall = found.shortfall;
  answer.outside = found.outside;
  answer.has_points = found.state == MeshState::exact;
  answer.is_complete = true;
  answer.quality = answer.has_points && areExact(a, b) ? Quality::exact : Quality::lower_bound;
  return true;
}

/// The distance of the geometries from that of surfaces around them: farther apart, less deep.
SignedDistance withoutExcess(const PlacedElement& a, const PlacedElement& b,
                             const SignedDistance& of_surfaces) noexcept {
  return inflated(of_surfaces, -a.element.mesh_excess, -b.element.mesh_excess);
}

/// A search that the budget ended inside a solid has a depth but no points that show it.
void matchPoints(SignedDistance& overlap) noexcept {
  overlap.distance = std::min(overlap.distance, 0.0);  // surfaces touch, up to rounding
  const Eigen::Vector3d between = overlap.point_on_b - overlap.point_on_a;
  constexpr double kRounding = 1e-9;
  if ((between - overlap.distance * overlap.normal_a_to_b).norm() > kRounding) {
    overlap.distance = 0.0;
    overlap.point_on_b = overlap.point_on_a;
  }
}

/// Surroundings of geometries may overlap where the geometries do not: then reports nothing.
void reportOverlap(const PlacedElement& a, const PlacedElement& b,
                   ElementDistance& answer) noexcept {
  answer.is_complete = true;
  if (areExact(a, b) && answer.measured.distance <= 0.0) {
    answer.quality = Quality::estimate;
    answer.has_points = true;
  }
}

ElementDistance measureMeshes(const PlacedElement& a, const PlacedElement& b,
                              ElementSearch& search) noexcept {
  ElementDistance answer;
  answer.work = kSetUpWork;
  // Elements that overlapped mostly still do, and then hulls give no answer.
  const bool overlapped = search.memory.last.found.quality == Quality::estimate;
  MeshDistance hulls;
  if (!overlapped && measureHulls(a, b, search, hulls, answer)) {
    return answer;
  }
  const bool is_inside = measureInside(a, b, answer.measured) && answer.measured.distance < 0.0;
  if (is_inside && a.element.mesh && b.element.mesh) {
    reportOverlap(a, b, answer);  // a search would find no more
    return answer;
  }
  const MeshDistance found = searchMeshes(a, b, hulls, search);
  search.memory.held = found.held;
  answer.work += found.visits;
  answer.outside = found.outside;
  if (found.state == MeshState::overlapping) {
    SignedDistance of_geometries = found.measured;
    matchPoints(of_geometries);
    if (!is_inside || of_geometries.distance < answer.measured.distance) {
      answer.measured = of_geometries;
    }
    reportOverlap(a, b, answer);
  } else if (is_inside) {
    reportOverlap(a, b, answer);
  } else if (found.state != MeshState::unknown) {
    answer.measured = found.measured;
    answer.shortfall = found.shortfall;
    answer.has_points = found.state == MeshState::exact;
    answer.is_complete = answer.has_points || found.measured.distance >= stopBeyond(a, b, search);
    answer.quality = answer.has_points && areExact(a, b) ? Quality::exact : Quality::lower_bound;
  }
  return answer;
}

/// Converts the distance of unpadded elements to that of padded ones.
ElementDistance padded(const PlacedElement& a, const PlacedElement& b,
                       ElementDistance answer) noexcept {
  if (a.element.padding + b.element.padding > 0.0) {
    answer.measured = inflated(answer.measured, a.element.padding, b.element.padding);
    answer.quality = answer.quality == Quality::exact ? Quality::lower_bound : answer.quality;
  }
  return answer;
}

}  // namespace

bool measureInside(const PlacedElement& a, const PlacedElement& b, SignedDistance& least) noexcept {
  least.distance = std::numeric_limits<double>::infinity();
  const InnerShapes& in_a = a.element.inner;
  const InnerShapes& in_b = b.element.inner;
  for (const auto* inner_a : {&in_a.sphere, &in_a.capsule}) {
    for (const auto* inner_b : {&in_b.sphere, &in_b.capsule}) {
      if (!*inner_a || !*inner_b) {
        continue;
      }
      const SignedDistance found =
          distanceBetween((*inner_a)->shape, a.world_from_element * (*inner_a)->geometry_from_body,
                          (*inner_b)->shape, b.world_from_element * (*inner_b)->geometry_from_body);
      least = found.distance < least.distance ? found : least;
    }
  }
  return least.distance < std::numeric_limits<double>::infinity();
}

std::optional<Shape> shapeOf(const std::optional<ConvexGeometry>& geometry) noexcept {
  const auto take = [](const auto& held) noexcept -> std::optional<Shape> {
    if constexpr (std::is_convertible_v<decltype(held), Shape>) {
      return Shape(held);
    } else {
      return std::nullopt;
    }
  };
  return geometry ? visitHeld(take, *geometry) : std::nullopt;
}

ElementDistance measureElements(const PlacedElement& a, const PlacedElement& b,
                                ElementSearch& search) noexcept {
  return padded(a, b,
                a.element.convex && b.element.convex ? measureConvex(a, b, search)
                                                     : measureMeshes(a, b, search));
}

ElementDistance measureByHulls(const PlacedElement& a, const PlacedElement& b,
                               ElementSearch& search) noexcept {
  const MeshDistance found =
      distanceByHulls(heldSurfaceOf(a), heldSurfaceOf(b), {stopBeyond(a, b, search)},
                      search.scratch.mesh, {search.memory.warm, search.memory.nearest});
  ElementDistance answer;
  answer.work = kApartWork + found.visits;
  if (found.state != MeshState::unknown) {
    answer.measured = found.measured;
    answer.has_points = found.state == MeshState::exact;
    answer.quality = answer.has_points && areExact(a, b) ? Quality::exact : Quality::lower_bound;
  }
  return padded(a, b, answer);
}

std::uint32_t deepenElements(const PlacedElement& a, const PlacedElement& b,
                             std::uint32_t most_points, ElementSearch& search,
                             SignedDistance& overlap) noexcept {
  const std::uint32_t points = std::min(most_points, search.budget / kPointSteps);
  KeptDepth* const kept = points > 0 ? keptDepth(search.memory) : nullptr;
  if (kept == nullptr) {
    return 0;
  }
  const MeshDepth found = depthOf(meshOf(a), meshOf(b), search.scratch.mesh, *kept, points);
  const SignedDistance deepest =
      inflated(withoutExcess(a, b, found.deepest), a.element.padding, b.element.padding);
  if (deepest.distance < overlap.distance) {
    overlap = deepest;
  }
  return kPointSteps * found.points + found.visits;
}

}  // namespace collision_monitor
