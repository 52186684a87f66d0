// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/recall_elements.h"

#include <algorithm>

#include "geometry/ball_motion.h"

namespace collision_monitor {
namespace {

// [m] How far any point of one may have come, seen from the other.
double motionSince(const LastMeasurement& last, const PlacedElement& a, const PlacedElement& b,
                   const std::array<Ball, 2>& balls) noexcept {
  constexpr double kRounding = 1e-12;  // of coordinates of some metres
  const Pose a_from_b = inverse(last.world_from_a) * last.world_from_b;
  const Pose a_from_b_now = inverse(a.world_from_element) * b.world_from_element;
  return kRounding +
         std::min(motionOfBall(balls[1].center, balls[1].radius, a_from_b, a_from_b_now),
                  motionOfBall(balls[0].center, balls[0].radius, inverse(a_from_b),
                               inverse(a_from_b_now)));
}

}  // namespace

Ball ballOf(const Element& element) {
  return element.convex ? ballOf(*element.convex) : ballOf(*element.mesh);
}

ElementDistance recallElements(const LastMeasurement& last, const PlacedElement& a,
                               const PlacedElement& b, const std::array<Ball, 2>& balls) noexcept {
  ElementDistance recalled = last.found;
  recalled.steps = 0;
  if (isSame(last.world_from_a, a.world_from_element) &&
      isSame(last.world_from_b, b.world_from_element)) {
    return recalled;
  }
  recalled.has_points = recalled.is_complete = false;
  if (recalled.quality == Quality::exact || recalled.quality == Quality::lower_bound) {
    recalled.quality = Quality::lower_bound;
    // What has gone far enough to be inside an open mesh is no longer known to be apart.
    const double motion = motionSince(last, a, b, balls);
    recalled.measured.distance = std::min(recalled.measured.distance, recalled.outside) - motion;
    recalled.outside -= motion;
  } else {
    recalled.quality = Quality::unknown;
  }
  return recalled;
}

}  // namespace collision_monitor
