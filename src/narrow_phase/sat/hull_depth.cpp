// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/sat/hull_depth.h"

#include <Eigen/Geometry>
#include <cmath>

#include "narrow_phase/gjk/flat_contact.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;
using Kind = HullAxis::Kind;

// Of both hulls. With more, a polytope grows about as fast: docs/decisions/convex-steps.md.
constexpr std::size_t kFewFaces = 40;

bool isFaceted(const ConvexCore& core) noexcept {
  return core.kind == ConvexCore::Kind::hull && core.hull->hasVolume() &&
         !core.hull->edges().empty();
}

// True if a point in a face's plane lies inside its edges.
bool liesIn(const ConvexHull& hull, std::uint32_t face, const Vector3d& point,
            double tolerance) noexcept {
  const Vector3d& normal = hull.faces()[face].normal;
  const ConvexHull::Indices ring = hull.ringOf(face);
  const Vector3d* from = &hull.vertices()[*(ring.end() - 1)];
  for (const std::uint32_t corner : ring) {
    const Vector3d* to = &hull.vertices()[corner];
    const Vector3d edge = *to - *from;
    if (edge.cross(point - *from).dot(normal) < -tolerance * edge.norm()) {
      return false;
    }
    from = to;
  }
  return true;
}

// Where the common perpendicular of two lines meets the first, as a share of `along_a`.
double shareOfA(const Vector3d& along_a, const Vector3d& along_b,
                const Vector3d& between) noexcept {
  const Vector3d across = along_a.cross(along_b);
  return between.cross(along_b).dot(across) / across.squaredNorm();
}

bool isShare(double share, double length, double tolerance) noexcept {
  return share * length >= -tolerance && (share - 1.0) * length <= tolerance;
}

// The contact point on A, and whether it lies on both features.
struct PointOnA {
  Vector3d point;
  bool is_on_both{false};
};

PointOnA betweenEdges(const ConvexPair& pair, const HullAxis& axis, double tolerance) noexcept {
  const ConvexHull::Edge& edge_a = pair.a.hull->edges()[axis.feature_of_a];
  const ConvexHull::Edge& edge_b = pair.b.hull->edges()[axis.feature_of_b];
  const Vector3d& from_a = pair.a.hull->vertices()[edge_a.from];
  const Vector3d from_b = pair.a_from_b * pair.b.hull->vertices()[edge_b.from];
  const Vector3d along_a = pair.a.hull->vertices()[edge_a.to] - from_a;
  const Vector3d along_b = pair.a_from_b * pair.b.hull->vertices()[edge_b.to] - from_b;
  const Vector3d between = from_b - from_a;
  const double share_a = shareOfA(along_a, along_b, between);
  const double share_b = -shareOfA(along_b, along_a, between);
  return {from_a + share_a * along_a, isShare(share_a, along_a.norm(), tolerance) &&
                                          isShare(share_b, along_b.norm(), tolerance)};
}

PointOnA pointOnA(const ConvexPair& pair, const HullAxis& axis, double tolerance) noexcept {
  const Vector3d delta = axis.separation * axis.direction;
  if (axis.kind == Kind::face_of_a) {
    const Vector3d lowest = pair.a_from_b * pair.b.hull->vertices()[axis.feature_of_b] - delta;
    return {lowest, liesIn(*pair.a.hull, axis.feature_of_a, lowest, tolerance)};
  }
  if (axis.kind == Kind::face_of_b) {
    const Vector3d& lowest = pair.a.hull->vertices()[axis.feature_of_a];
    const Vector3d in_b =
        pair.a_from_b.rotation.transpose() * (lowest + delta - pair.a_from_b.translation);
    return {lowest, liesIn(*pair.b.hull, axis.feature_of_b, in_b, tolerance)};
  }
  return betweenEdges(pair, axis, tolerance);
}

void takeVertices(const HullAxis& axis, ConvexPair& pair) noexcept {
  const ConvexHull& a = *pair.a.hull;
  const ConvexHull& b = *pair.b.hull;
  switch (axis.kind) {
    case Kind::face_of_a:
      pair.vertex_of_a = *a.ringOf(axis.feature_of_a).begin();
      pair.vertex_of_b = axis.feature_of_b;
      break;
    case Kind::face_of_b:
      pair.vertex_of_a = axis.feature_of_a;
      pair.vertex_of_b = *b.ringOf(axis.feature_of_b).begin();
      break;
    case Kind::edges:
      pair.vertex_of_a = a.edges()[axis.feature_of_a].from;
      pair.vertex_of_b = b.edges()[axis.feature_of_b].from;
      break;
  }
}

}  // namespace

bool haveFewFaces(const ConvexPair& pair) noexcept {
  return isFaceted(pair.a) && isFaceted(pair.b) &&
         pair.a.hull->faces().size() + pair.b.hull->faces().size() <= kFewFaces;
}

bool depthOfHulls(ConvexPair& pair, SignedDistance& found) noexcept {
  const double tolerance = roundingOf(pair);
  const double touching = -2.0 * touchingDistance(pair);
  const HullAxis axis = bestAxis(*pair.a.hull, *pair.b.hull, pair.a_from_b, touching);
  takeVertices(axis, pair);
  if (!(axis.separation < touching)) {
    return false;
  }
  const Pose origin;
  const PlacedCore a{pair.a, origin, pair.vertex_of_a};
  const PlacedCore b{pair.b, pair.a_from_b, pair.vertex_of_b};
  const PlacedPair placed = makePlacedPair(a, b);
  const SupportPlanes planes = supportPlanes(placed, axis.direction);
  if (!meet(planes, axis.separation, tolerance)) {
    return false;
  }
  const PointOnA on_a = pointOnA(pair, axis, tolerance);
  SignedDistance deep{axis.separation, on_a.point, on_a.point + axis.separation * axis.direction,
                      axis.direction};
  const bool is_centered = centerOnPatch(placed, planes, deep);
  if (!is_centered && !on_a.is_on_both) {
    return false;
  }
  found = deep;
  return true;
}

}  // namespace collision_monitor
