// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/proofs/segment_clearance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/bvh/visit_near.h"
#include "geometry/constants.h"
#include "geometry/point_triangle.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;
using Triangle = TriangleBvh::Triangle;

constexpr int kMaxCuts = 40;
constexpr double kConverged = 1e-13;

/// A lower bound that is linear along the segment, by its values at both ends.
struct Line {
  double at_a{0.0};
  double at_b{0.0};

  double at(double t) const { return at_a + t * (at_b - at_a); }
};

/// The bound from the direction between the triangle and a point of the segment.
/// @return false if that point is on the triangle.
bool boundFrom(const Triangle& triangle, const Vector3d& a, const Vector3d& b, double t,
               Line& line) {
  const Vector3d point = a + t * (b - a);
  Vector3d normal = point - closestPointOnTriangle(point, triangle[0], triangle[1], triangle[2]);
  const double distance = normal.norm();
  if (!(distance > 0.0)) {
    return false;
  }
  normal /= distance;
  // Relative to a corner, to limit rounding far from the origin.
  const Vector3d& origin = triangle[0];
  const double reach =
      std::max({0.0, normal.dot(triangle[1] - origin), normal.dot(triangle[2] - origin)});
  line = {normal.dot(a - origin) - reach, normal.dot(b - origin) - reach};
  return true;
}

/// Where the larger of two lines is least.
double lowestPlace(const Line& left, const Line& right) {
  const double falls = left.at_a - right.at_a;
  const double rises = right.at_b - left.at_b;
  const auto upper = [&](double t) { return std::max(left.at(t), right.at(t)); };
  double place = upper(0.0) <= upper(1.0) ? 0.0 : 1.0;
  if (falls * rises > 0.0) {
    const double crossing = falls / (falls + rises);
    place = upper(crossing) < upper(place) ? crossing : place;
  }
  return place;
}

double largestCoordinate(const Triangle& triangle, const Vector3d& a, const Vector3d& b) {
  double largest = std::max(a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff());
  for (const auto& corner : triangle) {
    largest = std::max(largest, corner.cwiseAbs().maxCoeff());
  }
  return largest;
}

/// The least of `cutoff` and the bounds of all triangles.
double clearanceOfPiece(const TriangleBvh& mesh, const Vector3d& a, const Vector3d& b,
                        double cutoff) {
  visitNear(mesh, unitQuery(mesh.unitFrame(), a.cwiseMin(b), a.cwiseMax(b)), cutoff,
            [&](std::uint32_t triangle) {
              cutoff = std::min(cutoff, clearanceBound(mesh.triangles()[triangle], a, b, cutoff));
              return cutoff;
            });
  return cutoff;
}

}  // namespace

double clearanceBound(const Triangle& triangle, const Vector3d& a, const Vector3d& b,
                      double cutoff) noexcept {
  const double allowance = 64.0 * kUnitRoundOff * largestCoordinate(triangle, a, b);
  Line left;
  Line right;
  if (!boundFrom(triangle, a, b, 0.0, left) || !boundFrom(triangle, a, b, 1.0, right)) {
    return 0.0;
  }
  double bound = 0.0;
  for (int i = 0; i < kMaxCuts; ++i) {
    const double place = lowestPlace(left, right);
    const double lowest = std::max(left.at(place), right.at(place));
    bound = std::max(bound, lowest - allowance);
    Line cut;
    if (bound >= cutoff || place == 0.0 || place == 1.0 || !boundFrom(triangle, a, b, place, cut)) {
      break;
    }
    (cut.at_a > cut.at_b ? left : right) = cut;
    if (cut.at(place) - lowest <= kConverged * std::abs(lowest)) {
      break;
    }
  }
  return bound;
}

double clearanceBound(const TriangleBvh& mesh, const Vector3d& a, const Vector3d& b) noexcept {
  constexpr double kMaxPieces = 32.0;
  // A slanting segment has a wide box; pieces about as long as the clearance do not.
  const double middle = mesh.nearestTo(0.5 * a + 0.5 * b).distance;
  const double wanted = (b - a).norm() / std::max(2.0 * middle, 1e-300);
  const int pieces = static_cast<int>(std::ceil(std::clamp(wanted, 1.0, kMaxPieces)));
  double clearance = std::numeric_limits<double>::infinity();
  Vector3d from = a;
  for (int i = 1; i <= pieces; ++i) {
    const Vector3d to = i == pieces ? b : Vector3d(a + i * ((b - a) / pieces));
    clearance = clearanceOfPiece(mesh, from, to, clearance);
    from = to;
  }
  // Rounding moves the ends of pieces off the segment.
  const double largest = std::max(a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff());
  return std::max(0.0, clearance - 64.0 * kUnitRoundOff * largest);
}

}  // namespace collision_monitor
