// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "motion/moving_sphere.h"

#include <limits>

namespace collision_monitor {
namespace {

// Relative to the coordinates: well above the rounding error of a test's few sums.
constexpr double kRounding = 64.0 * std::numeric_limits<double>::epsilon();

}  // namespace

MovingSphere movingSphereOf(const ScrewMotion& motion, const Eigen::Vector3d& center,
                            double radius) noexcept {
  MovingSphere sphere;
  sphere.center = motion.start * center;
  sphere.travel = poseAt(motion, 1.0) * center - sphere.center;
  sphere.length = sphere.travel.norm();
  const double arc = arcHeight(motion, center);
  sphere.reach =
      radius + arc + kRounding * (sphere.center.cwiseAbs().sum() + sphere.length + radius + arc);
  return sphere;
}

bool mayMeetBySpeed(const MovingSphere& a, const MovingSphere& b, double margin) noexcept {
  const double reach = a.reach + b.reach + a.length + b.length + margin;
  return reach >= 0.0 && (b.center - a.center).squaredNorm() <= reach * reach;
}

bool mayMeetByClosing(const MovingSphere& a, const MovingSphere& b, double margin) noexcept {
  const Eigen::Vector3d between = b.center - a.center;
  const double distance = between.norm();
  const double gap = distance - a.reach - b.reach - margin;
  return gap <= 0.0 || gap * distance <= between.dot(a.travel - b.travel);
}

}  // namespace collision_monitor
