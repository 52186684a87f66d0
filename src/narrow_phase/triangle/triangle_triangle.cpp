// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/triangle/triangle_triangle.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "narrow_phase/triangle/triangle_edges.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;
using Heights = std::array<double, 3>;

// Share of the size of both triangles. Heights below it are rounding and count as 0.
constexpr double kFlat = 1e-14;

double sizeOf(const Triangle& triangle) noexcept {
  return std::max({(triangle[1] - triangle[0]).cwiseAbs().maxCoeff(),
                   (triangle[2] - triangle[0]).cwiseAbs().maxCoeff()});
}

Heights heightsOver(const PreparedTriangle& plane, const Triangle& triangle,
                    double rounding) noexcept {
  Heights heights;
  for (std::size_t i = 0; i < 3; ++i) {
    const double height = heightOver(plane, triangle[i]);
    heights[i] = std::abs(height) > rounding ? height : 0.0;
  }
  return heights;
}

bool allOnOneSide(const Heights& heights) noexcept {
  return (heights[0] > 0.0 && heights[1] > 0.0 && heights[2] > 0.0) ||
         (heights[0] < 0.0 && heights[1] < 0.0 && heights[2] < 0.0);
}

struct Interval {
  double low{std::numeric_limits<double>::infinity()};
  double high{-std::numeric_limits<double>::infinity()};

  void include(double value) noexcept {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

// The part of the planes' common line that the triangle covers, along `axis`.
Interval stretchOf(const Triangle& triangle, const Heights& heights, Eigen::Index axis) noexcept {
  Interval stretch;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const double from = triangle[i][axis];
    const double to = triangle[j][axis];
    if (heights[i] == 0.0) {
      stretch.include(from);
    }
    if (heights[i] * heights[j] < 0.0) {
      stretch.include(from + heights[i] / (heights[i] - heights[j]) * (to - from));
    }
  }
  return stretch;
}

// True if the line along an edge of `a` has all of `b` strictly on its outer side, in the plane of
// coordinates p and q.
bool hasSeparatingEdge(const Triangle& a, const Triangle& b, Eigen::Index p, Eigen::Index q,
                       double rounding) noexcept {
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3d& start = a[i];
    const Vector3d along = a[(i + 1) % 3] - start;
    const auto sideOf = [&](const Vector3d& point) {
      return along[p] * (point[q] - start[q]) - along[q] * (point[p] - start[p]);
    };
    const double inner = sideOf(a[(i + 2) % 3]) < 0.0 ? -1.0 : 1.0;
    const double limit = -rounding * std::hypot(along[p], along[q]);
    if (std::all_of(b.begin(), b.end(),
                    [&](const Vector3d& corner) { return inner * sideOf(corner) < limit; })) {
      return true;
    }
  }
  return false;
}

bool overlapInPlane(const PreparedTriangle& a, const PreparedTriangle& b,
                    double rounding) noexcept {
  Eigen::Index axis = 0;
  a.normal.cwiseAbs().maxCoeff(&axis);
  const Eigen::Index p = (axis + 1) % 3;
  const Eigen::Index q = (axis + 2) % 3;
  return !hasSeparatingEdge(a.corners, b.corners, p, q, rounding) &&
         !hasSeparatingEdge(b.corners, a.corners, p, q, rounding);
}

// The distance of the plane and the triangle; 0 if they meet.
double gapOf(const Heights& heights) noexcept {
  return allOnOneSide(heights)
             ? std::min({std::abs(heights[0]), std::abs(heights[1]), std::abs(heights[2])})
             : 0.0;
}

// The gap of two triangles if the plane of one separates them; else 0.
struct PlaneGap {
  double gap;          // [m]
  Vector3d direction;  // from A to B
};

PlaneGap planeGapOf(const PreparedTriangle& a, const PreparedTriangle& b) noexcept {
  const Heights of_b = heightsOver(a, b.corners, 0.0);
  const Heights of_a = heightsOver(b, a.corners, 0.0);
  const double over_a = gapOf(of_b);
  const double over_b = gapOf(of_a);
  return over_a >= over_b ? PlaneGap{over_a, of_b[0] > 0.0 ? a.normal : Vector3d(-a.normal)}
                          : PlaneGap{over_b, of_a[0] > 0.0 ? Vector3d(-b.normal) : b.normal};
}

// [m^2] The squared gap along a direction of any length; 0 if it does not separate the triangles.
double squaredGapAlong(const Vector3d& direction, const Triangle& a, const Triangle& b) noexcept {
  const double end_of_a = std::max({direction.dot(a[0]), direction.dot(a[1]), direction.dot(a[2])});
  const double start_of_b =
      std::min({direction.dot(b[0]), direction.dot(b[1]), direction.dot(b[2])});
  const double gap = start_of_b - end_of_a;
  return gap > 0.0 ? gap * gap / direction.squaredNorm() : 0.0;
}

PointPair exchanged(const PointPair& pair) noexcept {
  return {pair.squared_distance, pair.on_b, pair.on_a};
}

// Tries B's corners, and the points where its edges cross the plane of A, with the face of A.
void improveByFaces(const PreparedTriangle& a, const Triangle& b, bool meets_plane,
                    PointPair& best) noexcept {
  for (std::size_t i = 0; i < 3; ++i) {
    improveByFace(a, b[i], best);
    if (meets_plane) {
      improveByPiercing(a, b[i], b[(i + 1) % 3], best);
    }
  }
}

}  // namespace

bool overlap(const Triangle& a, const Triangle& b) noexcept {
  const PreparedTriangle on_a = prepare(a);
  const PreparedTriangle on_b = prepare(b);
  const double rounding =
      kFlat * (sizeOf(a) + sizeOf(b) + a[0].cwiseAbs().maxCoeff() + b[0].cwiseAbs().maxCoeff());
  if (!on_a.hasPlane() || !on_b.hasPlane()) {
    return nearestPoints(a, b).squared_distance <= rounding * rounding;
  }
  const Heights heights_of_b = heightsOver(on_a, b, rounding);
  if (allOnOneSide(heights_of_b)) {
    return false;
  }
  const Heights heights_of_a = heightsOver(on_b, a, rounding);
  if (allOnOneSide(heights_of_a)) {
    return false;
  }
  const auto isFlat = [](const Heights& h) { return h[0] == 0.0 && h[1] == 0.0 && h[2] == 0.0; };
  if (isFlat(heights_of_a) || isFlat(heights_of_b)) {
    return overlapInPlane(on_a, on_b, rounding);
  }
  Eigen::Index axis = 0;
  on_a.normal.cross(on_b.normal).cwiseAbs().maxCoeff(&axis);
  const Interval of_a = stretchOf(a, heights_of_a, axis);
  const Interval of_b = stretchOf(b, heights_of_b, axis);
  return of_a.low <= of_b.high + rounding && of_b.low <= of_a.high + rounding;
}

TriangleDistance boundedDistance(const Triangle& a, const Triangle& b, const PointPair& start,
                                 double squared_cutoff) noexcept {
  // Between convex surfaces the direction of the nearest points so far separates nearly all.
  const Vector3d from_a_to_b = start.on_b - start.on_a;
  const double squared_gap = squaredGapAlong(from_a_to_b, a, b);
  if (squared_gap >= squared_cutoff) {
    return {start, squared_gap, from_a_to_b};
  }
  const PreparedTriangle on_a = prepare(a);
  const PreparedTriangle on_b = prepare(b);
  const PlaneGap plane = planeGapOf(on_a, on_b);
  if (plane.gap * plane.gap >= squared_cutoff) {
    return {start, plane.gap * plane.gap, plane.direction};
  }
  PointPair best = start;
  improveByFaces(on_a, b, plane.gap == 0.0, best);
  PointPair from_b = exchanged(best);
  improveByFaces(on_b, a, plane.gap == 0.0, from_b);
  best = exchanged(from_b);
  const EdgePair edges = nearestEdges(on_a, on_b);
  if (edges.squared_distance < best.squared_distance) {
    improveByEdges(on_a.edges[edges.a], on_b.edges[edges.b], best);
  }
  const bool is_nearer = best.squared_distance < start.squared_distance;
  return {best, best.squared_distance,
          is_nearer ? Vector3d(best.on_b - best.on_a) : Vector3d(Vector3d::Zero()),
          kVisitsToMeasure};
}

PointPair nearestPoints(const Triangle& a, const Triangle& b, const PointPair& start) noexcept {
  return boundedDistance(a, b, start, start.squared_distance).nearest;
}

}  // namespace collision_monitor
