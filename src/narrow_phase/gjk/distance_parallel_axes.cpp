// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/gjk/distance_parallel_axes.h"

#include <algorithm>
#include <cmath>

#include "narrow_phase/closed_form/core_distance.h"

namespace collision_monitor {
namespace {

// Middle of the common part of the intervals |x| <= half_a and |x - center| <= half_b, or of the
// gap between them, clamped to the first.
double sharedMiddle(double half_a, double half_b, double center) noexcept {
  const double low = std::max(-half_a, center - half_b);
  const double high = std::min(half_a, center + half_b);
  return std::max(-half_a, std::min(half_a, 0.5 * (low + high)));
}

// The half plane of A's axis (up) and B's center (outward).
struct HalfPlane {
  Eigen::Vector3d outward{Eigen::Vector3d::UnitX()};
  Eigen::Vector3d up{Eigen::Vector3d::UnitZ()};
  double offset{0.0};  // of B's axis
  double height{0.0};  // of B's center, >= 0 along `up`
};

// Makes the half plane of an axis and a center. A point takes the axis of the other core.
HalfPlane makeHalfPlane(const Eigen::Vector3d& axis, const Eigen::Vector3d& center) noexcept {
  HalfPlane plane;
  const double along = axis.dot(center);
  plane.up = signOf(along) * axis;
  plane.height = std::abs(along);
  Eigen::Vector3d across = center - along * axis;
  // Near the axis, a rounded part along it would tilt the normal.
  across -= axis.dot(across) * axis;
  plane.offset = across.norm();
  plane.outward =
      plane.offset > kTouching ? Eigen::Vector3d(across / plane.offset) : perpendicularTo(axis);
  return plane;
}

}  // namespace

bool isRound(const ConvexCore& core) noexcept {
  const bool is_segment = core.kind == ConvexCore::Kind::box && core.half_extents.x() == 0.0 &&
                          core.half_extents.y() == 0.0;
  return core.kind == ConvexCore::Kind::cylinder || is_segment;
}

bool distanceOfParallelAxes(const ConvexPair& pair, SignedDistance& cores) noexcept {
  if (!isRound(pair.a) || !isRound(pair.b)) {
    return false;
  }
  const Eigen::Vector3d axis_of_b = pair.a_from_b.rotation.col(2);
  const bool is_parallel = axis_of_b.head<2>().norm() <= kParallel;
  if (!is_parallel && !isPoint(pair.a) && !isPoint(pair.b)) {
    return false;
  }
  const Eigen::Vector3d axis =
      isPoint(pair.a) ? axis_of_b : Eigen::Vector3d(Eigen::Vector3d::UnitZ());
  const HalfPlane plane = makeHalfPlane(axis, pair.a_from_b.translation);
  const Eigen::Vector3d& half_a = pair.a.half_extents;
  const Eigen::Vector3d& half_b = pair.b.half_extents;
  const double across = plane.offset - half_a.x() - half_b.x();
  const double along = plane.height - half_a.z() - half_b.z();

  double on_outward = sharedMiddle(half_a.x(), half_b.x(), plane.offset);
  double on_up = sharedMiddle(half_a.z(), half_b.z(), plane.height);
  if (across > 0.0 && along > 0.0) {
    cores.distance = std::hypot(across, along);
    cores.normal_a_to_b = (across * plane.outward + along * plane.up).normalized();
  } else if (across >= along) {
    cores.distance = across;
    cores.normal_a_to_b = plane.outward;
    on_outward = half_a.x();
  } else {
    cores.distance = along;
    cores.normal_a_to_b = plane.up;
    on_up = half_a.z();
  }
  cores.point_on_a = on_outward * plane.outward + on_up * plane.up;
  cores.point_on_b = cores.point_on_a + cores.distance * cores.normal_a_to_b;
  return true;
}

}  // namespace collision_monitor
