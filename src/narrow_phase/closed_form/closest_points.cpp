// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/closed_form/closest_points.h"

#include <algorithm>
#include <cmath>

#include "narrow_phase/closed_form/core_distance.h"

namespace collision_monitor {
namespace {

double clampTo(double half_length, double parameter) noexcept {
  return std::max(-half_length, std::min(half_length, parameter));
}

// Middle of the part of `a` beside `b`, or the end of `a` nearest to `b` if there is no such part.
// Both are parallel. `b_on_a` is the parameter of b's center on a.
double middleOfOverlap(double half_a, double half_b, double b_on_a) noexcept {
  const double low = std::max(-half_a, b_on_a - half_b);
  const double high = std::min(half_a, b_on_a + half_b);
  return clampTo(half_a, 0.5 * (low + high));
}

}  // namespace

double closestParameter(const Segment& segment, const Eigen::Vector3d& point) noexcept {
  return clampTo(segment.half_length, segment.direction.dot(point - segment.center));
}

Eigen::Vector3d towardsNormalCone(const Segment& segment, double parameter,
                                  const Eigen::Vector3d& outward) noexcept {
  const double along = outward.dot(segment.direction);
  const bool is_within = std::abs(parameter) < segment.half_length;
  return is_within || along * parameter < 0.0 ? Eigen::Vector3d(outward - along * segment.direction)
                                              : outward;
}

ClosestParameters closestParameters(const Segment& a, const Segment& b) noexcept {
  // Uses plain numbers. Reading in pairs what was stored number by number stalls the processor,
  // which costs half the time of a pair of capsules in bench/pairs_bench.
  const double ux = a.direction.x(), uy = a.direction.y(), uz = a.direction.z();
  const double vx = b.direction.x(), vy = b.direction.y(), vz = b.direction.z();
  const double rx = b.center.x() - a.center.x();
  const double ry = b.center.y() - a.center.y();
  const double rz = b.center.z() - a.center.z();
  const double nx = uy * vz - uz * vy;
  const double ny = uz * vx - ux * vz;
  const double nz = ux * vy - uy * vx;
  const double sine_squared = nx * nx + ny * ny + nz * nz;
  const double cosine = ux * vx + uy * vy + uz * vz;
  const double b_on_a = ux * rx + uy * ry + uz * rz;
  const double a_on_b = -(vx * rx + vy * ry + vz * rz);
  const double r_cross_v_dot_n =
      (ry * vz - rz * vy) * nx + (rz * vx - rx * vz) * ny + (rx * vy - ry * vx) * nz;

  ClosestParameters closest;
  closest.on_a = sine_squared > kParallel * kParallel
                     ? clampTo(a.half_length, r_cross_v_dot_n / sine_squared)
                     : middleOfOverlap(a.half_length, b.half_length, b_on_a);
  // Makes each parameter the best for the other. The second line matters if b was clamped.
  closest.on_b = clampTo(b.half_length, a_on_b + closest.on_a * cosine);
  closest.on_a = clampTo(a.half_length, b_on_a + closest.on_b * cosine);
  return closest;
}

}  // namespace collision_monitor
