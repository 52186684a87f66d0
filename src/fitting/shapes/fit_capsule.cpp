// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/shapes/fit_capsule.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "fitting/search/box_rotations.h"
#include "fitting/search/core_descent.h"
#include "fitting/search/core_set.h"
#include "fitting/search/point_cloud.h"
#include "fitting/search/small_shapes.h"
#include "fitting/shapes/fit_sphere.h"

namespace collision_monitor {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kStartDirections =
    300;  // over the whole sphere: half of them count, 13 degrees apart
constexpr std::size_t kDescents = 12;
constexpr double kSameAxis = 0.97;  // cosine of 14 degrees

const FreeExtents kOnlyLength{false, false, true};
// Capsules of least grown volume have shorter caps than those of least volume: see DescentGoal.
constexpr double kRadiusGrowths[] = {0.1, 0.3, 1.0};

/// A nearly smallest circle around 2-D points.
/// Source: Badoiu, Clarkson, "Smaller Core-Sets for Balls" (2003), section 3.
Vector2d circleCenter(const std::vector<Vector2d>& points) {
  constexpr int kRounds = 20;
  Vector2d center = Vector2d::Zero();
  for (int i = 1; i <= kRounds; ++i) {
    const auto farthest =
        std::max_element(points.begin(), points.end(), [&](const auto& a, const auto& b) {
          return (a - center).squaredNorm() < (b - center).squaredNorm();
        });
    center += (*farthest - center) / (i + 1.0);
  }
  return center;
}

/// A capsule along `axis`. Its line passes through the center of the projected points; its ends are
/// as near as the points allow.
TurnedCore capsuleAlong(const Vector3d& axis, const Points& points) {
  TurnedCore core;
  core.rotation = rotationWithAxis(axis);
  std::vector<Vector2d> shadow;
  for (const auto& point : points) {
    shadow.emplace_back(core.rotation.leftCols<2>().transpose() * point);
  }
  const Vector2d center = circleCenter(shadow);
  double radius_squared = 0.0;
  for (const auto& point : shadow) {
    radius_squared = std::max(radius_squared, (point - center).squaredNorm());
  }
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double room = radius_squared - (shadow[i] - center).squaredNorm();
    const double cap = std::sqrt(std::max(room, 0.0));
    const double height = axis.dot(points[i]);
    low = std::min(low, height + cap);
    high = std::max(high, height - cap);
  }
  core.center = core.rotation.leftCols<2>() * center + 0.5 * (low + high) * axis;
  core.half_extents.z() = std::max(0.5 * (high - low), 0.0);
  core.radius = enclosingRadius(core, points);
  return core;
}

/// The best capsules with clearly different axes, and some along natural axes.
std::vector<TurnedCore> startCapsules(const Points& points) {
  std::vector<TurnedCore> all;
  for (const auto& axis : spreadDirections(kStartDirections)) {
    if (axis.z() > 0.0) {
      all.push_back(capsuleAlong(axis, points));
    }
  }
  std::sort(all.begin(), all.end(), IsSmaller{});
  std::vector<TurnedCore> chosen;
  for (const auto& candidate : all) {
    const Vector3d axis = candidate.rotation.col(2);
    const bool is_new = std::all_of(chosen.begin(), chosen.end(), [&](const TurnedCore& other) {
      return std::abs(axis.dot(other.rotation.col(2))) < kSameAxis;
    });
    if (is_new && chosen.size() < kDescents) {
      chosen.push_back(candidate);
    }
  }
  // Manufactured parts have axes whose valley can be narrower than the spacing of directions.
  for (const Eigen::Matrix3d& axes : {Eigen::Matrix3d(Eigen::Matrix3d::Identity()),
                                      principalAxes(points), roughBoxRotation(points)}) {
    for (int k = 0; k < 3; ++k) {
      chosen.push_back(capsuleAlong(axes.col(k), points));
    }
  }
  return chosen;
}

}  // namespace

std::vector<PosedShape> smallCapsules(const Points& points) {
  const NormalisedPoints cloud = normalise(points);
  if (!(cloud.scale > 0.0)) {
    return {{Capsule{}, {Eigen::Matrix3d::Identity(), points[0]}}};
  }
  const Points representatives = representativesOf(cloud.points);
  DescentGoal goal;
  goal.free_extents = kOnlyLength;
  auto cores = descendAll(startCapsules(representatives), representatives, cloud.points, goal);
  for (const double growth : kRadiusGrowths) {
    goal.growth = growth;
    cores.push_back(descendAll({cores.front()}, representatives, cloud.points, goal).front());
  }
  std::vector<PosedShape> fits;
  for (const auto& core : cores) {
    const PosedShape fit = placedInCloud(core, cloud);
    fits.push_back(
        {Capsule{coreHalfExtents(fit.shape).z(), radiusOf(fit.shape)}, fit.geometry_from_body});
  }
  const PosedShape sphere = fitSphere(points);
  if (volumeOf(sphere.shape) < volumeOf(fits.front().shape)) {
    const PosedShape ball{Capsule{0.0, radiusOf(sphere.shape)}, sphere.geometry_from_body};
    fits.insert(fits.begin(), ball);
  }
  return fits;
}

PosedShape fitCapsule(const Points& points) { return smallCapsules(points).front(); }

}  // namespace collision_monitor
