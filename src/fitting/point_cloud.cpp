// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/point_cloud.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "collision_monitor/geometry/convex_hull.h"

namespace collision_monitor {
namespace {

constexpr double kPi = 3.14159265358979323846;

std::size_t farthestAlong(const Points& points, const Eigen::Vector3d& direction) {
  std::size_t farthest = 0;
  double reach = points[0].dot(direction);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double value = points[i].dot(direction);
    if (value > reach) {
      reach = value;
      farthest = i;
    }
  }
  return farthest;
}

}  // namespace

NormalisedPoints normalise(const Points& points) {
  Eigen::Vector3d low = points[0];
  Eigen::Vector3d high = points[0];
  for (const auto& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  NormalisedPoints result;
  result.centre = 0.5 * low + 0.5 * high;
  result.scale = (0.5 * high - 0.5 * low).norm();
  if (result.scale > 0.0) {
    result.points.reserve(points.size());
    for (const auto& point : points) {
      result.points.emplace_back((point - result.centre) / result.scale);
    }
  }
  return result;
}

Points spreadDirections(int count) {
  const double golden_angle = kPi * (3.0 - std::sqrt(5.0));
  Points directions;
  for (int i = 0; i < count; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / count;
    const double across = std::sqrt(1.0 - z * z);
    directions.emplace_back(across * std::cos(golden_angle * i),
                            across * std::sin(golden_angle * i), z);
  }
  return directions;
}

std::vector<Eigen::Matrix3d> spreadRotations(int count) {
  // The constants of the paper: sqrt(2) and the positive real root of x^4 = x + 4.
  const double phi = std::sqrt(2.0);
  const double psi = 1.533751168755204288118041;
  std::vector<Eigen::Matrix3d> rotations;
  for (int i = 0; i < count; ++i) {
    const double s = i + 0.5;
    const double inner = std::sqrt(s / count);
    const double outer = std::sqrt(1.0 - s / count);
    const double alpha = 2.0 * kPi * s / phi;
    const double beta = 2.0 * kPi * s / psi;
    rotations.push_back(Eigen::Quaterniond(outer * std::cos(beta), inner * std::sin(alpha),
                                           inner * std::cos(alpha), outer * std::sin(beta))
                            .normalized()
                            .toRotationMatrix());
  }
  return rotations;
}

Eigen::Matrix3d principalAxes(const Points& points) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const auto& point : points) {
    mean += point / static_cast<double>(points.size());
  }
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const auto& point : points) {
    scatter += (point - mean) * (point - mean).transpose();
  }
  Eigen::Matrix3d axes = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter).eigenvectors();
  axes.col(0) = axes.col(1).cross(axes.col(2));
  return axes;
}

Points extremePoints(const Points& points, const Points& directions) {
  std::vector<std::size_t> chosen;
  for (const auto& direction : directions) {
    chosen.push_back(farthestAlong(points, direction));
  }
  std::sort(chosen.begin(), chosen.end());
  chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  Points result;
  for (const auto i : chosen) {
    result.push_back(points[i]);
  }
  return result;
}

Points representativesOf(const Points& points) {
  constexpr int kCount = 100;
  return points.size() <= kCount ? points : extremePoints(points, spreadDirections(kCount));
}

Points outerPoints(const Points& points) {
  // Of 300 directions almost every one finds a corner of its own only on a hull with thousands of
  // them. A part of the points shows that as well as all.
  constexpr std::size_t kPart = 3000;
  constexpr int kDirections = 300;
  constexpr std::size_t kManyCorners = 280;
  if (points.size() > kPart) {
    Points part;
    for (std::size_t i = 0; i < points.size(); i += points.size() / kPart) {
      part.push_back(points[i]);
    }
    if (extremePoints(part, spreadDirections(kDirections)).size() > kManyCorners) {
      return points;
    }
  }
  return convexHullOf(points).vertices;
}

Eigen::Matrix3d rotationWithAxis(const Eigen::Vector3d& axis) {
  Eigen::Matrix3d rotation;
  rotation.col(2) = axis;
  rotation.col(0) = axis.unitOrthogonal();
  rotation.col(1) = axis.cross(rotation.col(0));
  return rotation;
}

}  // namespace collision_monitor
