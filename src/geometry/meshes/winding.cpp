// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/geometry/winding.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "geometry/constants.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

void addSpread(const Vector3d& delta, const Vector3d& normal, WindingMoments& moments) noexcept {
  for (std::size_t i = 0; i < 3; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    const Eigen::Index next = (k + 1) % 3;
    moments.spread[i] += delta[k] * normal[k];
    moments.spread[3 + i] += 0.5 * (delta[k] * normal[next] + delta[next] * normal[k]);
  }
}

// Moves a part to the center of the whole and adds it.
void add(const WindingMoments& part, WindingMoments& whole) noexcept {
  const Vector3d delta = part.center - whole.center;
  whole.normal += part.normal;
  whole.area += part.area;
  whole.squared += part.squared + part.area * delta.squaredNorm();
  whole.radius = std::max(whole.radius, delta.norm() + part.radius);
  for (std::size_t i = 0; i < part.spread.size(); ++i) {
    whole.spread[i] += part.spread[i];
  }
  addSpread(delta, part.normal, whole);
}

}  // namespace

WindingMoments momentsOf(const Triangle& triangle) noexcept {
  WindingMoments moments;
  moments.center = (triangle[0] + triangle[1] + triangle[2]) / 3.0;
  moments.normal = 0.5 * (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
  moments.area = moments.normal.norm();
  double squared = 0.0;
  for (const Vector3d& corner : triangle) {
    const double delta = (corner - moments.center).squaredNorm();
    squared += delta;
    moments.radius = std::max(moments.radius, std::sqrt(delta));
  }
  moments.squared = moments.area * squared / 12.0;
  return moments;
}

WindingMoments joined(const WindingMoments& one, const WindingMoments& other) noexcept {
  const double area = one.area + other.area;
  const double share = area > 0.0 ? other.area / area : 0.5;
  WindingMoments whole;
  whole.center = one.center + share * (other.center - one.center);
  add(one, whole);
  add(other, whole);
  return whole;
}

BoundedNumber windingOf(const WindingMoments& part, const Vector3d& point) noexcept {
  const Vector3d delta = part.center - point;
  const double squared = delta.squaredNorm();
  const double length = std::sqrt(squared);
  const double gap = length - part.radius;
  if (!(gap > 0.0)) {
    return {0.0, kInfinity};
  }
  const auto& s = part.spread;
  const double trace = s[0] + s[1] + s[2];
  const double along =
      s[0] * delta[0] * delta[0] + s[1] * delta[1] * delta[1] + s[2] * delta[2] * delta[2] +
      2.0 * (s[3] * delta[0] * delta[1] + s[4] * delta[1] * delta[2] + s[5] * delta[2] * delta[0]);
  const double cubed = squared * length;
  constexpr double kAround = 4.0 * kPi;
  const double near = 1.0 / (gap * gap);
  return {(part.normal.dot(delta) + trace - 3.0 * along / squared) / (kAround * cubed),
          3.0 / kAround * part.squared * near * near};
}

}  // namespace collision_monitor
