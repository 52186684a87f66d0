// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/bvh/bound_triangles.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "collision_monitor/geometry/ids.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

// An upper bound of the rounding error of a sum of a few numbers of size 1.
constexpr double kRounding = 4e-15;

// A float >= `value`: it adds more than the conversion can take away.
// @pre value >= 0
float roundedUp(double value) noexcept {
  constexpr double kUlp = std::numeric_limits<float>::epsilon();
  return static_cast<float>(value * (1.0 + kUlp)) + std::numeric_limits<float>::min();
}

// Not inlined on purpose. From -O2 on, g++ 12.2 drops several conversions to float and back at
// once, so bounds would be computed for numbers that are not stored.
[[gnu::noinline]] float nearestFloat(double value) noexcept { return static_cast<float>(value); }

// Half the width of an interval about a center that was rounded to a float.
float halfAbout(float center, double low, double high, double rounding) noexcept {
  const auto exact_center = static_cast<double>(center);
  return roundedUp(std::max(high - exact_center, exact_center - low) + rounding);
}

// Shorter than a unit vector by more than rounding adds here and in every later rotation.
Eigen::Vector3f shortUnit(const Vector3d& direction) noexcept {
  constexpr double kLength = 1.0 - 2e-6;
  const double length = direction.norm();
  const double scale = length > 0.0 ? kLength / length : 0.0;
  return {nearestFloat(scale * direction.x()), nearestFloat(scale * direction.y()),
          nearestFloat(scale * direction.z())};
}

}  // namespace

void boundNothing(std::uint32_t slot, MeshTreeNode& node) noexcept {
  // Far away, but with a finite square: infinities would turn into NaN.
  constexpr float kBeyondReach = 1e18F;
  for (std::uint32_t k = 0; k < 3; ++k) {
    node.center[k][slot] = kBeyondReach;
    node.half[k][slot] = 0.0F;
    node.normal[k][slot] = 0.0F;
  }
  node.slab_center[slot] = 0.0F;
  node.slab_half[slot] = 0.0F;
  node.child[slot] = kNone;
}

void boundByBox(const Eigen::Vector3f& low, const Eigen::Vector3f& high, double size,
                std::uint32_t slot, MeshTreeNode& node) noexcept {
  constexpr double kFloatRounding = 6e-8;
  for (std::uint32_t k = 0; k < 3; ++k) {
    const double rounding =
        kRounding * size +
        kFloatRounding * static_cast<double>(std::max(std::abs(low[k]), std::abs(high[k])));
    node.center[k][slot] = 0.5F * (low[k] + high[k]);
    node.half[k][slot] = halfAbout(node.center[k][slot], static_cast<double>(low[k]),
                                   static_cast<double>(high[k]), rounding);
  }
}

void boundBySlab(const TriangleSpan& triangles, const Vector3d& direction, const Vector3d& origin,
                 std::uint32_t slot, MeshTreeNode& node) noexcept {
  const Eigen::Vector3f normal = shortUnit(direction);
  const Vector3d exact_normal = normal.cast<double>();
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const Triangle* triangle = triangles.first; triangle != triangles.last; ++triangle) {
    for (const Vector3d& corner : *triangle) {
      const double height = exact_normal.dot(corner - origin);
      low = std::min(low, height);
      high = std::max(high, height);
    }
  }
  double size = 0.0;
  for (std::uint32_t k = 0; k < 3; ++k) {
    size += std::abs(origin[k]) +
            static_cast<double>(std::abs(node.center[k][slot]) + node.half[k][slot]);
    node.normal[k][slot] = normal[k];
  }
  node.slab_center[slot] = nearestFloat(0.5 * (low + high));
  node.slab_half[slot] = halfAbout(node.slab_center[slot], low, high, kRounding * size);
}

}  // namespace collision_monitor
