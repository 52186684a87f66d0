// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/triangle/triangle_core.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/point_triangle.h"
#include "narrow_phase/gjk/gjk.h"
#include "narrow_phase/triangle/triangle_box.h"
#include "narrow_phase/triangle/triangle_edges.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

// As TriangleDistance::visits.
constexpr std::uint32_t kVisitsOfBox = 6;
constexpr std::uint32_t kVisitsOfSearch = 9;

// A point is a segment of length 0.
PointPair nearestToSegment(const Triangle& triangle, const Vector3d& half_extents,
                           const PointPair& start) noexcept {
  const PreparedTriangle prepared = prepare(triangle);
  const Vector3d& end = half_extents;
  PointPair best = start;
  improveByPiercing(prepared, -end, end, best);
  const Edge core = makeEdge(-end, end);
  for (const Edge& edge : prepared.edges) {
    improveByEdges(edge, core, best);
  }
  improveByFace(prepared, -end, best);
  improveByFace(prepared, end, best);
  return best;
}

// A point of the triangle inside the core.
Vector3d sharedPoint(const Simplex& touching) noexcept {
  if (!touching.contains_origin) {
    return touching.pointOnA();
  }
  const auto& corners = touching.vertices;
  Eigen::Matrix3d edges;
  for (std::size_t k = 0; k < 3; ++k) {
    edges.col(static_cast<Eigen::Index>(k)) = corners[k + 1].difference - corners[0].difference;
  }
  const Vector3d weights = -edges.inverse() * corners[0].difference;
  return (1.0 - weights.sum()) * corners[0].on_a + weights[0] * corners[1].on_a +
         weights[1] * corners[2].on_a + weights[2] * corners[3].on_a;
}

Vector3d closestInCylinder(const Vector3d& half_extents, const Vector3d& point) noexcept {
  const double across = point.head<2>().norm();
  const double scale = across > half_extents.x() ? half_extents.x() / across : 1.0;
  return {scale * point.x(), scale * point.y(),
          std::clamp(point.z(), -half_extents.z(), half_extents.z())};
}

void offerPoint(const Vector3d& half_extents, const Vector3d& on_triangle,
                PointPair& best) noexcept {
  const Vector3d in_cylinder = closestInCylinder(half_extents, on_triangle);
  const double squared_distance = (on_triangle - in_cylinder).squaredNorm();
  if (squared_distance < best.squared_distance) {
    best = {squared_distance, on_triangle, in_cylinder};
  }
}

// The distance to a convex solid is convex along an edge: golden sections find its minimum.
void improveOnEdge(const Vector3d& half_extents, const Vector3d& from, const Vector3d& to,
                   PointPair& best) noexcept {
  constexpr double kGolden = 0.6180339887498949;
  const auto squaredAt = [&](double share) {
    const Vector3d point = from + share * (to - from);
    return (point - closestInCylinder(half_extents, point)).squaredNorm();
  };
  double low = 0.0;
  double high = 1.0;
  for (int step = 0; step < 90; ++step) {
    const double left = high - kGolden * (high - low);
    const double right = low + kGolden * (high - low);
    const bool is_left = squaredAt(left) <= squaredAt(right);
    (is_left ? high : low) = is_left ? right : left;
  }
  offerPoint(half_extents, from + 0.5 * (low + high) * (to - from), best);
}

// For a triangle that nearly touches a cylinder, where GJK stalls: tries its edges and its face.
void improveByFeatures(const Triangle& triangle, const ConvexCore& cylinder,
                       PointPair& best) noexcept {
  const Vector3d normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
  std::uint32_t vertex = 0;
  for (const double sign : {1.0, -1.0}) {
    const Vector3d extreme = supportPoint(cylinder, sign * normal, vertex);
    offerPoint(cylinder.half_extents,
               closestPointOnTriangle(extreme, triangle[0], triangle[1], triangle[2]), best);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    improveOnEdge(cylinder.half_extents, triangle[k], triangle[(k + 1) % 3], best);
  }
}

// From the box about the triangle to the box about the core; 0 for hulls.
Vector3d wayToBox(const Triangle& triangle, const ConvexCore& core) noexcept {
  if (core.kind == ConvexCore::Kind::hull) {
    return Vector3d::Zero();
  }
  const Vector3d least = triangle[0].cwiseMin(triangle[1]).cwiseMin(triangle[2]);
  const Vector3d most = triangle[0].cwiseMax(triangle[1]).cwiseMax(triangle[2]);
  return (-core.half_extents - most).cwiseMax(0.0) - (least - core.half_extents).cwiseMax(0.0);
}

// Runs GJK. Whatever the bounds say, its points are points of both.
PointPair nearestBySearch(const Triangle& triangle, const ConvexCore& core,
                          const PointPair& start) noexcept {
  ConvexCore corners;
  corners.kind = ConvexCore::Kind::triangle;
  corners.triangle = &triangle;
  ConvexPair pair = makeConvexPair(corners, Pose{}, core, Pose{});
  static const ConvexWarmStart kNothing{};
  const GjkResult found = runGjk(pair, kNothing, {std::sqrt(start.squared_distance)});
  if (found.state == GjkResult::State::overlapping) {
    const Vector3d shared = sharedPoint(found.simplex);
    return {0.0, shared, shared};
  }
  PointPair best = start;
  if (found.state == GjkResult::State::stopped) {
    return best;
  }
  const double squared_distance = found.simplex.distance * found.simplex.distance;
  if (squared_distance < best.squared_distance) {
    best = {squared_distance, found.simplex.pointOnA(), found.simplex.pointOnB()};
  }
  if (found.state == GjkResult::State::stalled && core.kind == ConvexCore::Kind::cylinder) {
    improveByFeatures(triangle, core, best);
  }
  return best;
}

}  // namespace

double squaredGapAlong(const Vector3d& direction, const Triangle& triangle,
                       const ConvexCore& core) noexcept {
  const double end_of_triangle = std::max(
      {direction.dot(triangle[0]), direction.dot(triangle[1]), direction.dot(triangle[2])});
  std::uint32_t vertex = 0;
  const double gap = direction.dot(supportPoint(core, -direction, vertex)) - end_of_triangle;
  return gap > 0.0 ? gap * gap / direction.squaredNorm() : 0.0;
}

TriangleDistance boundedDistance(const Triangle& triangle, const ConvexCore& core,
                                 const PointPair& start, double squared_cutoff) noexcept {
  const Vector3d normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
  const Vector3d to_core = normal.dot(triangle[0]) < 0.0 ? normal : Vector3d(-normal);
  for (const Vector3d& direction : {Vector3d(start.on_b - start.on_a), to_core}) {
    const double squared = squaredGapAlong(direction, triangle, core);
    if (squared >= squared_cutoff) {
      return {start, squared, direction};
    }
  }
  const Vector3d to_box = wayToBox(triangle, core);
  if (to_box.squaredNorm() >= squared_cutoff) {
    return {start, to_box.squaredNorm(), to_box};
  }
  const bool is_box = core.kind == ConvexCore::Kind::box && core.half_extents.x() > 0.0;
  const bool is_segment = core.kind == ConvexCore::Kind::box && !is_box;
  if (is_box) {
    const Vector3d across = acrossEdges(triangle, core.half_extents, squared_cutoff);
    if (!across.isZero(0.0)) {
      return {start, squaredGapAlong(across, triangle, core), across};
    }
  }
  const PointPair best = nearestPoints(triangle, core, start);
  const bool is_nearer = best.squared_distance < start.squared_distance;
  return {best, best.squared_distance,
          is_nearer ? Vector3d(best.on_b - best.on_a) : Vector3d(Vector3d::Zero()),
          is_segment ? kVisitsToMeasure
          : is_box   ? kVisitsOfBox
                     : kVisitsOfSearch};
}

PointPair nearestPoints(const Triangle& triangle, const ConvexCore& core,
                        const PointPair& start) noexcept {
  if (core.kind != ConvexCore::Kind::box) {
    return nearestBySearch(triangle, core, start);
  }
  const Vector3d& half = core.half_extents;
  return half.x() == 0.0 && half.y() == 0.0 ? nearestToSegment(triangle, half, start)
                                            : nearestToBox(triangle, half, start);
}

}  // namespace collision_monitor
