// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/proofs/proof.h"

#include <algorithm>
#include <cmath>

#include "geometry/constants.h"

namespace collision_monitor {
namespace {

// [m] Below this a square underflows, and a computed length may be 0 although the true one is not.
constexpr double kUnderflow = 1e-150;

/// The relative part of the bound: 32 u + 2 |R^T R - I|.
double relativeError(const PosedShape& fit) noexcept {
  const Eigen::Matrix3d& rotation = fit.geometry_from_body.rotation;
  const Eigen::Matrix3d defect = rotation.transpose() * rotation - Eigen::Matrix3d::Identity();
  // The defect itself has an error of 4 u per entry, 12 u in norm.
  return 32.0 * kUnitRoundOff + 2.0 * (defect.norm() + 12.0 * kUnitRoundOff);
}

double sizeOf(const Shape& shape) noexcept {
  return coreHalfExtents(shape).norm() + radiusOf(shape);
}

double upperBound(const PosedShape& fit, double computed_excess, double extent) noexcept {
  return computed_excess + relativeError(fit) * (extent + sizeOf(fit.shape)) + kUnderflow;
}

/// Grows the fit until the bound shows that it encloses.
template <class Bound>
double widenUntil(PosedShape& fit, const Bound& bound) {
  double widening = 0.0;
  double excess = bound(fit);
  const Shape tight = fit.shape;
  // Growth raises the bound by a few u of the size, so a second or third round may be needed.
  // Doubling ends the loop even if the growth is lost in the rounding of a large radius.
  while (excess > 0.0) {
    widening = std::max(2.0 * widening, widening + excess);
    fit.shape = grown(tight, widening);
    excess = bound(fit);
  }
  return widening;
}

}  // namespace

double provenExcess(const PosedShape& fit, const Points& points) noexcept {
  double extent = 0.0;
  for (const auto& point : points) {
    extent = std::max(extent, (point - fit.geometry_from_body.translation).norm());
  }
  return upperBound(fit, excessOver(fit, points), extent);
}

double provenExcess(const PosedShape& fit, const Cylinder& cylinder) noexcept {
  const Eigen::Vector3d core = coreHalfExtents(fit.shape);
  const double across = cylinder.radius - std::min(core.x(), core.y());
  const double along = cylinder.half_length - core.z();
  const double outside = std::hypot(std::max(across, 0.0), std::max(along, 0.0));
  const double inside = std::min(std::max(across, along), 0.0);
  const double reach = outside + inside - radiusOf(fit.shape);
  return upperBound(fit, reach, std::hypot(cylinder.radius, cylinder.half_length));
}

double provenExcess(const PosedShape& fit, const Capsule& capsule) noexcept {
  const Points ends{{0.0, 0.0, capsule.half_length}, {0.0, 0.0, -capsule.half_length}};
  const double excess = excessOver(fit, ends) + capsule.radius;
  return upperBound(fit, excess, capsule.half_length + capsule.radius);
}

double widenUntilProven(const Points& points, PosedShape& fit, double margin) {
  return widenUntil(
      fit, [&](const PosedShape& candidate) { return provenExcess(candidate, points) + margin; });
}

double widenUntilProven(const Cylinder& cylinder, PosedShape& fit) {
  return widenUntil(fit,
                    [&](const PosedShape& candidate) { return provenExcess(candidate, cylinder); });
}

double widenUntilProven(const Capsule& capsule, PosedShape& fit) {
  return widenUntil(fit,
                    [&](const PosedShape& candidate) { return provenExcess(candidate, capsule); });
}

}  // namespace collision_monitor
