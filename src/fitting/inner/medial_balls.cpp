// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/inner/medial_balls.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/interruption.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;
using Triangle = TriangleBvh::Triangle;

constexpr int kMaxRounds = 30;
// Of a distance. With less, queries from the middle of round bodies visit thousands of triangles.
constexpr double kTolerance = 0.1;

struct SurfacePoint {
  Vector3d point;
  Vector3d inward;
};

Vector3d doubleArea(const Triangle& triangle) {
  return (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
}

/// Spreads points by equal shares of the area, in a triangle by a low-discrepancy sequence.
/// Source: Martin Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences" (2018).
std::vector<SurfacePoint> spreadOver(const std::vector<Triangle>& triangles, int count) {
  double area = 0.0;
  for (const auto& triangle : triangles) {
    area += doubleArea(triangle).norm();
  }
  std::vector<SurfacePoint> points;
  double passed = 0.0;
  for (const auto& triangle : triangles) {
    const Vector3d normal = doubleArea(triangle);
    const double size = normal.norm();
    passed += size;
    while (points.size() < static_cast<std::size_t>(count) &&
           (static_cast<double>(points.size()) + 0.5) * area < passed * count && size > 0.0) {
      const auto i = static_cast<double>(points.size() + 1);
      double u = std::fmod(0.7548776662466927 * i, 1.0);
      double v = std::fmod(0.5698402909980532 * i, 1.0);
      if (u + v > 1.0) {
        u = 1.0 - u;
        v = 1.0 - v;
      }
      points.push_back(
          {triangle[0] + u * (triangle[1] - triangle[0]) + v * (triangle[2] - triangle[0]),
           -normal / size});
    }
  }
  return points;
}

NearestPoint nearestToCenter(const TriangleBvh& surface, const SurfacePoint& from, double radius) {
  return surface.nearestTo(from.point + radius * from.inward, NearestPoint{}, kTolerance);
}

/// The first radius of a series up to `largest` whose ball holds a point of the surface. It
/// ascends: in a thin wall a large ball's center is outside, and both faces are about equally far.
double radiusToShrink(const TriangleBvh& surface, const SurfacePoint& from, double largest) {
  constexpr double kFirst = 1.0 / 4096.0;
  constexpr double kGrowth = 4.0;
  double radius = kFirst * largest;
  while (radius < largest &&
         nearestToCenter(surface, from, radius).distance >= radius * (1.0 - kTolerance)) {
    radius *= kGrowth;
  }
  return std::min(radius, largest);
}

std::optional<EmptyBall> emptyBallAt(const TriangleBvh& surface, const SurfacePoint& from,
                                     double largest) {
  double radius = radiusToShrink(surface, from, largest);
  for (int i = 0; i < kMaxRounds; ++i) {
    const NearestPoint nearest = nearestToCenter(surface, from, radius);
    if (nearest.distance >= radius * (1.0 - kTolerance)) {
      return EmptyBall{from.point + radius * from.inward, nearest.distance / (1.0 + kTolerance)};
    }
    // The ball through both points that touches the surface in the first.
    const Vector3d gap = nearest.point - from.point;
    const double ahead = 2.0 * gap.dot(from.inward);
    if (!(ahead > 0.0)) {
      return std::nullopt;
    }
    radius = std::min(gap.squaredNorm() / ahead, radius);
  }
  return std::nullopt;
}

}  // namespace

std::vector<EmptyBall> medialBalls(const TriangleBvh& surface, int count) {
  const Aabb& bounds = surface.bounds();
  const double largest = 0.5 * (bounds.max - bounds.min).minCoeff();
  std::vector<EmptyBall> balls;
  for (const auto& point : spreadOver(surface.triangles(), count)) {
    throwIfInterrupted();
    // No ball inside the surface is larger.
    if (const auto ball = emptyBallAt(surface, point, largest)) {
      balls.push_back(*ball);
    }
  }
  std::stable_sort(balls.begin(), balls.end(),
                   [](const auto& a, const auto& b) { return a.radius > b.radius; });
  return balls;
}

std::vector<EmptyBall> separateBalls(const std::vector<EmptyBall>& balls, std::size_t most) {
  std::vector<EmptyBall> kept;
  for (const auto& ball : balls) {
    const bool is_new = std::none_of(kept.begin(), kept.end(), [&](const EmptyBall& other) {
      return (ball.center - other.center).norm() < 0.5 * other.radius;
    });
    if (is_new && kept.size() < most) {
      kept.push_back(ball);
    }
  }
  return kept;
}

}  // namespace collision_monitor
