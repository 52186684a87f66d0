// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/box_rotations.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "fitting/point_cloud.h"
#include "fitting/simplex_search.h"
#include "geometry/planar_hull.h"

namespace collision_monitor {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using PointMatrix = Eigen::Matrix<double, Eigen::Dynamic, 3>;

constexpr int kStartRotations = 1000;
constexpr std::size_t kDescents = 8;
// Counts a flat box by its area, a thin one by its volume.
constexpr double kThickness = 1e-7;
// Two boxes are taken as one when their axes differ by less than about 8 degrees.
constexpr double kSameBox = 0.02;

struct Candidate {
  Matrix3d rotation;
  double cost;
};

bool isBetter(const Candidate& a, const Candidate& b) { return a.cost < b.cost; }

double extentAlong(const PointMatrix& points, const Vector3d& axis) {
  const Eigen::VectorXd heights = points * axis;
  return heights.maxCoeff() - heights.minCoeff();
}

double boxCost(const PointMatrix& points, const Matrix3d& axes) {
  double cost = 1.0;
  for (int k = 0; k < 3; ++k) {
    cost *= extentAlong(points, axes.col(k)) + kThickness;
  }
  return cost;
}

Matrix3d turned(const Matrix3d& rotation, const Vector3d& turn) {
  const double angle = turn.norm();
  return angle > 0.0 ? Matrix3d(rotation * Eigen::AngleAxisd(angle, turn / angle)) : rotation;
}

/// The box that keeps axis `k` and has the least area across it: one side of the least rectangle
/// around a polygon lies on an edge of it (Freeman, Shapira 1975).
Matrix3d turnedByCalipers(const PointMatrix& points, const Matrix3d& axes, int k) {
  const Vector3d u = axes.col((k + 1) % 3);
  const Vector3d v = axes.col((k + 2) % 3);
  std::vector<Eigen::Vector2d> flat;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    flat.emplace_back(points.row(i).dot(u), points.row(i).dot(v));
  }
  const auto polygon = convexPolygonOf(flat);
  double best_area = std::numeric_limits<double>::infinity();
  Eigen::Vector2d best_edge = Eigen::Vector2d::UnitX();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d along = flat[polygon[(i + 1) % polygon.size()]] - flat[polygon[i]];
    if (!(along.norm() > 0.0)) {
      continue;
    }
    const Eigen::Vector2d edge = along.normalized();
    Eigen::AlignedBox2d box;
    for (const auto corner : polygon) {
      const Eigen::Vector2d& p = flat[corner];
      box.extend(Eigen::Vector2d(p.dot(edge), p.y() * edge.x() - p.x() * edge.y()));
    }
    const double area = (box.sizes().array() + kThickness).prod();
    if (area < best_area) {
      best_area = area;
      best_edge = edge;
    }
  }
  Matrix3d result = axes;
  result.col((k + 1) % 3) = (best_edge.x() * u + best_edge.y() * v).normalized();
  result.col((k + 2) % 3) = axes.col(k).cross(result.col((k + 1) % 3)).normalized();
  return result;
}

void alignWithEdges(const PointMatrix& points, Candidate& candidate) {
  constexpr int kMaxRounds = 10;
  for (int round = 0; round < kMaxRounds; ++round) {
    const double before = candidate.cost;
    for (int k = 0; k < 3; ++k) {
      const Matrix3d axes = turnedByCalipers(points, candidate.rotation, k);
      const double cost = boxCost(points, axes);
      if (cost < candidate.cost) {
        candidate = {axes, cost};
      }
    }
    if (!(candidate.cost < before * (1.0 - 1e-6))) {
      return;
    }
  }
}

/// Simplex searches of different size about the best box so far: a search that ends in a kink of
/// the volume, where a face meets an edge, gets out of it with another simplex.
void descend(const PointMatrix& points, Candidate& candidate) {
  const auto cost = [&](const Vector3d& turn) {
    return boxCost(points, turned(candidate.rotation, turn));
  };
  for (const double first_step : {0.1, -0.03, 0.01, -0.1, 0.03}) {
    const Vector3d turn = searchSimplex<3>({first_step, 1e-5, 150}, cost);
    const Matrix3d rotation = turned(candidate.rotation, turn);
    candidate = {rotation, boxCost(points, rotation)};
    alignWithEdges(points, candidate);
  }
}

/// 0 for the same axes up to order and sign.
double axisDifference(const Matrix3d& a, const Matrix3d& b) {
  return 3.0 - (a.transpose() * b).cwiseAbs().rowwise().maxCoeff().sum();
}

/// The best candidates of which no two are the same box.
std::vector<Candidate> distinctBest(std::vector<Candidate> candidates, std::size_t count) {
  std::sort(candidates.begin(), candidates.end(), isBetter);
  std::vector<Candidate> chosen;
  for (const auto& candidate : candidates) {
    const bool is_new = std::none_of(chosen.begin(), chosen.end(), [&](const Candidate& other) {
      return axisDifference(candidate.rotation, other.rotation) < kSameBox;
    });
    if (is_new) {
      chosen.push_back(candidate);
    }
    if (chosen.size() == count) {
      break;
    }
  }
  return chosen;
}

PointMatrix toMatrix(const Points& points) {
  PointMatrix matrix(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i) {
    matrix.row(static_cast<Eigen::Index>(i)) = points[i].transpose();
  }
  return matrix;
}

}  // namespace

PlacedCore boxWithAxes(const Matrix3d& axes, const Points& points) {
  Vector3d low = axes.transpose() * points[0];
  Vector3d high = low;
  for (const auto& point : points) {
    const Vector3d in_axes = axes.transpose() * point;
    low = low.cwiseMin(in_axes);
    high = high.cwiseMax(in_axes);
  }
  return {axes, axes * (0.5 * (low + high)), 0.5 * (high - low), 0.0};
}

Matrix3d refineBoxRotation(const Matrix3d& axes, const Points& points) {
  const PointMatrix matrix = toMatrix(points);
  Candidate candidate{axes, boxCost(matrix, axes)};
  descend(matrix, candidate);
  return candidate.rotation;
}

std::vector<Matrix3d> smallBoxRotations(const Points& points, std::size_t count) {
  const PointMatrix matrix = toMatrix(points);
  std::vector<Candidate> starts;
  for (const auto& rotation : spreadRotations(kStartRotations)) {
    starts.push_back({rotation, boxCost(matrix, rotation)});
  }
  starts = distinctBest(std::move(starts), kDescents);
  for (const Matrix3d& rotation : {principalAxes(points), Matrix3d(Matrix3d::Identity())}) {
    starts.push_back({rotation, boxCost(matrix, rotation)});
  }
  for (auto& candidate : starts) {
    descend(matrix, candidate);
  }
  std::vector<Matrix3d> rotations;
  for (const auto& candidate : distinctBest(std::move(starts), count)) {
    rotations.push_back(candidate.rotation);
  }
  return rotations;
}

}  // namespace collision_monitor
