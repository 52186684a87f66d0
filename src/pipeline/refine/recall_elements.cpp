// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/refine/recall_elements.h"

#include <algorithm>
#include <cmath>

#include "geometry/ball_motion.h"

namespace collision_monitor {
namespace {

// [m] An upper bound of how far any point of one has moved relative to the other.
double motionSince(const LastMeasurement& last, const PlacedElement& a, const PlacedElement& b,
                   const std::array<Ball, 2>& balls) noexcept {
  constexpr double kRounding = 1e-12;  // of coordinates of some metres
  const Pose before = inverse(last.world_from_a) * last.world_from_b;  // A from B
  const Pose now = inverse(a.world_from_element) * b.world_from_element;
  const double turn = turnBetween(before, now);  // of A seen from B, too
  const Eigen::Vector3d of_b = now * balls[1].center - before * balls[1].center;
  const Eigen::Vector3d of_a = now.rotation.transpose() * (balls[0].center - now.translation) -
                               before.rotation.transpose() * (balls[0].center - before.translation);
  return kRounding +
         std::min(of_b.norm() + turn * balls[1].radius, of_a.norm() + turn * balls[0].radius);
}

/// Points of two elements, where these are now.
struct CarriedPoints {
  Eigen::Vector3d on_a;
  Eigen::Vector3d a_to_b;  ///< unit
  double length;           ///< [m] between them; 0: `a_to_b` means nothing
};

CarriedPoints carryPoints(const Eigen::Vector3d& of_a, const Eigen::Vector3d& of_b,
                          const PlacedElement& a, const PlacedElement& b) noexcept {
  const Eigen::Vector3d on_a = a.world_from_element * of_a;
  const Eigen::Vector3d travel = b.world_from_element * of_b - on_a;
  const double length = travel.norm();
  return {on_a, travel / length, length};
}

SignedDistance measuredAt(const CarriedPoints& points, double distance) noexcept {
  return {distance, points.on_a, points.on_a + distance * points.a_to_b, points.a_to_b};
}

}  // namespace

Ball ballOf(const Element& element) {
  return element.convex ? ballOf(*element.convex) : ballOf(*element.mesh);
}

ElementDistance recallElements(const LastMeasurement& last, const PlacedElement& a,
                               const PlacedElement& b, const std::array<Ball, 2>& balls) noexcept {
  ElementDistance recalled = last.found;
  recalled.work = 0;
  if (isSame(last.world_from_a, a.world_from_element) &&
      isSame(last.world_from_b, b.world_from_element)) {
    return recalled;
  }
  recalled.has_points = recalled.is_complete = false;
  if (recalled.quality == Quality::exact || recalled.quality == Quality::lower_bound) {
    recalled.quality = Quality::lower_bound;
    // Motion may have brought one inside an open mesh: `outside` bounds this, too.
    const double motion = motionSince(last, a, b, balls);
    recalled.measured.distance = std::min(recalled.measured.distance, recalled.outside) - motion;
    recalled.outside -= motion;
  } else {
    recalled.quality = Quality::unknown;
  }
  return recalled;
}

std::optional<ElementDistance> recallPoints(const WitnessPoints& last, const PlacedElement& a,
                                            const PlacedElement& b, double bound) noexcept {
  if (std::isinf(last.error) || !(bound > 0.0) || (a.element.convex && b.element.convex)) {
    return std::nullopt;
  }
  const CarriedPoints points = carryPoints(last.on_a, last.on_b, a, b);
  if (!(points.length > 0.0)) {
    return std::nullopt;
  }
  ElementDistance found;
  found.shortfall = points.length + last.error - bound;
  found.quality = last.quality;
  found.has_points = found.is_complete = true;
  found.measured = measuredAt(points, bound);
  return found;
}

std::optional<ElementDistance> recallOverlap(const LastMeasurement& last, const PlacedElement& a,
                                             const PlacedElement& b,
                                             const std::array<Ball, 2>& balls) noexcept {
  constexpr double kPart = 0.5;  // a search for depths restarts after a step as long as the depth
  const double depth = -last.found.measured.distance;
  if (last.found.quality != Quality::estimate) {
    return std::nullopt;
  }
  const double motion = motionSince(last, a, b, balls);
  const SignedDistance& measured = last.found.measured;
  CarriedPoints points = carryPoints(inverse(last.world_from_a) * measured.point_on_a,
                                     inverse(last.world_from_b) * measured.point_on_b, a, b);
  if (!(motion < kPart * depth) || !(points.length > 0.0)) {
    return std::nullopt;
  }
  points.a_to_b *= -1.0;
  ElementDistance found = last.found;
  found.work = 0;
  found.is_complete = true;
  found.shortfall = depth + motion;
  found.measured = measuredAt(points, -(depth + motion));
  return found;
}

}  // namespace collision_monitor
