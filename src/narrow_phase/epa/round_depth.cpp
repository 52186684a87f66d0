// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/epa/round_depth.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "narrow_phase/closed_form/closest_points.h"
#include "narrow_phase/closed_form/core_distance.h"
#include "narrow_phase/gjk/distance_parallel_axes.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

// A cylinder. Frames: A's.
struct Round {
  Vector3d center;
  Vector3d axis;  // unit
  double radius;
  double half_length;
};

Round roundOf(const ConvexCore& core, const Pose& pose) noexcept {
  return {pose.translation, pose.rotation.col(2), core.half_extents.x(), core.half_extents.z()};
}

double reachAlong(const Round& round, const Vector3d& normal) noexcept {
  return round.radius * round.axis.cross(normal).norm() +
         round.half_length * std::abs(round.axis.dot(normal));
}

// Overlap of the cylinders along a unit direction from A to B.
double overlapAlong(const Round& a, const Round& b, const Vector3d& normal) noexcept {
  return reachAlong(a, normal) + reachAlong(b, normal) - (b.center - a.center).dot(normal);
}

struct Candidate {
  enum class Kind : unsigned char { cap_or_side_of_a, cap_or_side_of_b, both_sides };

  double depth{std::numeric_limits<double>::infinity()};
  Vector3d normal{Vector3d::UnitX()};
  Kind kind{Kind::both_sides};
};

void offer(const Round& a, const Round& b, const Vector3d& normal, Candidate::Kind kind,
           Candidate& best) noexcept {
  const double depth = overlapAlong(a, b, normal);
  if (depth < best.depth) {
    best = {depth, normal, kind};
  }
}

// Finds where sqrt(1 - (s x)^2) * radius + slope * x - height * sqrt(1 - x^2) is least on [0, 1],
// right of its one change from concave to convex: there the derivative only rises.
double leastPlace(double radius, double s, double slope, double height) noexcept {
  const double squared = radius * s * s;
  const auto bends_up = [&](double x) {
    const double ratio = (1.0 - s * s * x * x) / ((1.0 - x) * (1.0 + x));
    return ratio * std::sqrt(ratio) * height > squared;
  };
  const auto derivative = [&](double x) {
    return slope + x * (height / std::sqrt((1.0 - x) * (1.0 + x)) -
                        squared / std::sqrt(1.0 - s * s * x * x));
  };
  double low = 0.0;
  double high = 1.0;
  for (int step = 0; step < 60; ++step) {
    const double middle = 0.5 * (low + high);
    const bool is_beyond = bends_up(middle) && derivative(middle) > 0.0;
    (is_beyond ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

// Offers the normals across the side of one cylinder.
void offerAcross(const Round& a, const Round& b, bool is_side_of_a, Candidate& best) noexcept {
  const Round& side = is_side_of_a ? a : b;
  const Round& other = is_side_of_a ? b : a;
  const Candidate::Kind kind =
      is_side_of_a ? Candidate::Kind::cap_or_side_of_a : Candidate::Kind::cap_or_side_of_b;
  Vector3d cross = side.axis.cross(other.axis);
  const double sine = cross.norm();
  cross -= side.axis.dot(cross) * side.axis;  // removes rounding of nearly parallel axes
  const Vector3d between = b.center - a.center;
  const Vector3d both = signOf(between.dot(cross)) * cross.normalized();  // across both sides
  const Vector3d single = both.cross(side.axis);
  const double height = between.dot(both);
  offer(a, b, both, Candidate::Kind::both_sides, best);
  for (const double sign : {1.0, -1.0}) {
    const double slope = sine * other.half_length - sign * between.dot(single);
    const double x = leastPlace(other.radius, sine, slope, height);
    const Vector3d normal = sign * x * single + std::sqrt((1.0 - x) * (1.0 + x)) * both;
    offer(a, b, normal.normalized(), kind, best);
  }
}

struct DepthBounds {
  double at_least;
  double at_most;
};

Candidate leastOnKinks(const Round& a, const Round& b) noexcept {
  Candidate best;
  for (const double sign : {1.0, -1.0}) {
    offer(a, b, sign * a.axis, Candidate::Kind::cap_or_side_of_a, best);
    offer(a, b, sign * b.axis, Candidate::Kind::cap_or_side_of_b, best);
  }
  offerAcross(a, b, true, best);
  offerAcross(a, b, false, best);
  return best;
}

// True if no normal at which two rims meet gives less than `bounds.at_most`. The radius of
// curvature rules out sines to A's axis from `sine_to_axis` on, the lengths rule out smaller ones.
bool isLeast(const Round& a, const Round& b, const DepthBounds& bounds,
             double sine_to_axis) noexcept {
  const double sine = a.axis.cross(b.axis).norm();
  const double cosine = std::abs(a.axis.dot(b.axis));
  const double cosine_to_axis = std::sqrt(1.0 - sine_to_axis * sine_to_axis);
  const double sine_to_other = sine_to_axis * cosine - cosine_to_axis * sine;
  if (sine_to_other <= 0.0) {
    return false;
  }
  const double twist = sine / (sine_to_axis * sine_to_other);
  const double curvature_radius =
      2.0 * std::min(a.radius, b.radius) / sine_to_other * twist * twist;
  const Vector3d between = b.center - a.center;
  const double least_along = a.half_length * cosine_to_axis +
                             b.half_length * (cosine * cosine_to_axis - sine * sine_to_axis) -
                             std::abs(between.dot(a.axis)) -
                             sine_to_axis * between.cross(a.axis).norm();
  return curvature_radius < bounds.at_least && least_along > bounds.at_most;
}

bool isLeast(const Round& a, const Round& b, const DepthBounds& bounds) noexcept {
  constexpr double kSines[] = {0.001, 0.003, 0.01, 0.03, 0.1, 0.2, 0.4, 0.6, 0.8};
  return std::any_of(std::begin(kSines), std::end(kSines),
                     [&](double sine) { return isLeast(a, b, bounds, sine); });
}

// The point farthest along the normal; the middle of a side or a cap.
Vector3d farthest(const Round& round, const Vector3d& normal) noexcept {
  const double along = round.axis.dot(normal);
  const Vector3d across = normal - along * round.axis;
  const double length = across.norm();
  Vector3d point = round.center;
  point += std::abs(along) > kParallel ? Vector3d(signOf(along) * round.half_length * round.axis)
                                       : Vector3d(Vector3d::Zero());
  point +=
      length > kParallel ? Vector3d(round.radius / length * across) : Vector3d(Vector3d::Zero());
  return point;
}

// True if the normal is nearly across both axes. Whole sides are then extreme, and a rim is no
// better than the points above it.
bool isAcross(const Round& a, const Round& b, const Vector3d& normal) noexcept {
  constexpr double kSlope = 1e-9;
  return std::abs(a.axis.dot(normal)) <= kSlope && std::abs(b.axis.dot(normal)) <= kSlope;
}

Vector3d pointOnA(const Round& a, const Round& b, const Candidate& best) noexcept {
  switch (isAcross(a, b, best.normal) ? Candidate::Kind::both_sides : best.kind) {
    case Candidate::Kind::cap_or_side_of_a:
      return farthest(b, -best.normal) + best.depth * best.normal;
    case Candidate::Kind::cap_or_side_of_b:
      return farthest(a, best.normal);
    case Candidate::Kind::both_sides:
      break;
  }
  const Segment line_of_a{a.center + a.radius * best.normal, a.axis, a.half_length};
  const Segment line_of_b{b.center - b.radius * best.normal, b.axis, b.half_length};
  return line_of_a.at(closestParameters(line_of_a, line_of_b).on_a);
}

}  // namespace

bool depthOfRound(const ConvexPair& pair, double at_least, SignedDistance& cores) noexcept {
  if (!isRound(pair.a) || !isRound(pair.b)) {
    return false;
  }
  const Round a = roundOf(pair.a, Pose{});
  const Round b = roundOf(pair.b, pair.a_from_b);
  if (!(a.axis.cross(b.axis).norm() > kParallel)) {
    return false;
  }
  const Candidate best = leastOnKinks(a, b);
  if (!isLeast(a, b, {at_least, best.depth})) {
    return false;
  }
  cores.distance = -best.depth;
  cores.normal_a_to_b = best.normal;
  cores.point_on_a = pointOnA(a, b, best);
  cores.point_on_b = cores.point_on_a + cores.distance * cores.normal_a_to_b;
  return true;
}

}  // namespace collision_monitor
