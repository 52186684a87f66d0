// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/search/point_cloud.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/constants.h"
#include "geometry/hulls/convex_hull.h"

namespace collision_monitor {
namespace {

constexpr std::size_t kBlock = 64;

/// Some of the points, in columns of x, y and z. The last point repeats to fill the block.
using Block = Eigen::Array<double, kBlock, 3>;

Block blockOf(const Points& points, std::size_t first) {
  Block block;
  for (std::size_t i = 0; i < kBlock; ++i) {
    const std::size_t from = std::min(first + i, points.size() - 1);
    block.row(static_cast<Eigen::Index>(i)) = points[from].transpose();
  }
  return block;
}

auto reachesAlong(const Eigen::Vector3d& direction, const Block& block) {
  return block.col(0) * direction.x() +
         (block.col(1) * direction.y() + block.col(2) * direction.z());
}

/// For each direction, the first of the points farthest along it.
std::vector<std::size_t> farthestPoints(const Points& points, const Points& directions) {
  std::vector<std::size_t> farthest(directions.size(), 0);
  std::vector<double> reach(directions.size(), -std::numeric_limits<double>::infinity());
  for (std::size_t first = 0; first < points.size(); first += kBlock) {
    const Block block = blockOf(points, first);
    for (std::size_t i = 0; i < directions.size(); ++i) {
      if (reachesAlong(directions[i], block).maxCoeff() > reach[i]) {
        Eigen::Index place = 0;
        reach[i] = reachesAlong(directions[i], block).maxCoeff(&place);
        farthest[i] = first + static_cast<std::size_t>(place);
      }
    }
  }
  return farthest;
}

/// The inside is n . x <= offset.
struct FacePlane {
  Eigen::Vector3d normal;
  double offset;
};

/// The planes of a hull's faces; none if it is flat.
std::vector<FacePlane> planesOf(const TriangleMesh& hull, double extent) {
  constexpr double kFlat = 1e-6;  // of the extent
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const auto& corner : hull.vertices) {
    middle += corner / static_cast<double>(hull.vertices.size());
  }
  std::vector<FacePlane> planes;
  for (const auto& t : hull.triangles) {
    const Eigen::Vector3d& corner = hull.vertices[t[0]];
    const Eigen::Vector3d normal =
        (hull.vertices[t[1]] - corner).cross(hull.vertices[t[2]] - corner).normalized();
    if (!(normal.dot(corner - middle) > kFlat * extent)) {
      return {};
    }
    planes.push_back({normal, normal.dot(corner)});
  }
  return planes;
}

/// The points that are beyond one of the planes by more than `hair`.
Points beyondPlanes(const Points& points, const std::vector<FacePlane>& planes, double hair) {
  Eigen::Array<double, kBlock, 1> excess;
  Points beyond;
  for (std::size_t first = 0; first < points.size(); first += kBlock) {
    const Block block = blockOf(points, first);
    excess.setConstant(-std::numeric_limits<double>::infinity());
    for (const auto& plane : planes) {
      excess = excess.max(block.col(0) * plane.normal.x() + block.col(1) * plane.normal.y() +
                          block.col(2) * plane.normal.z() - plane.offset);
    }
    for (std::size_t i = 0; i < std::min(kBlock, points.size() - first); ++i) {
      if (excess[static_cast<Eigen::Index>(i)] > hair) {
        beyond.push_back(points[first + i]);
      }
    }
  }
  return beyond;
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
  result.center = 0.5 * low + 0.5 * high;
  result.scale = (0.5 * high - 0.5 * low).norm();
  if (result.scale > 0.0) {
    result.points.reserve(points.size());
    for (const auto& point : points) {
      result.points.emplace_back((point - result.center) / result.scale);
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
  std::vector<std::size_t> chosen = farthestPoints(points, directions);
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
  constexpr std::size_t kFew = 100;
  constexpr double kHair = 1e-13;  // of the largest coordinates: the rounding of a face
  if (points.size() > kFew) {
    double extent = 0.0;
    double largest = 0.0;
    for (const auto& point : points) {
      extent = std::max(extent, (point - points.front()).cwiseAbs().maxCoeff());
      largest = std::max(largest, point.cwiseAbs().maxCoeff());
    }
    const TriangleMesh inner = convexHullOf(representativesOf(points));
    const auto planes = planesOf(inner, extent);
    if (!planes.empty()) {
      Points outer = beyondPlanes(points, planes, kHair * largest);
      outer.insert(outer.end(), inner.vertices.begin(), inner.vertices.end());
      return outer;
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
