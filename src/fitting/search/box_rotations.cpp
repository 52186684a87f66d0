// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/search/box_rotations.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "fitting/search/point_cloud.h"
#include "fitting/search/simplex_search.h"
#include "geometry/hulls/planar_hull.h"

namespace collision_monitor {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using PointMatrix = Eigen::Matrix<double, Eigen::Dynamic, 3>;

constexpr int kStartRotations = 1000;
constexpr std::size_t kDescents = 8;
constexpr double kFirstStep = 0.1;  // [rad] of the simplex
// Makes flat boxes count by area, and thin ones by volume.
constexpr double kThickness = 1e-7;
// Two boxes count as equal when their axes differ by less than about 8 degrees.
constexpr double kSameBox = 0.02;

struct Candidate {
  Matrix3d rotation;
  double cost;
};

bool isBetter(const Candidate& a, const Candidate& b) { return a.cost < b.cost; }

Matrix3d turned(const Matrix3d& rotation, const Vector3d& turn) {
  const double angle = turn.norm();
  return angle > 0.0 ? Matrix3d(rotation * Eigen::AngleAxisd(angle, turn / angle)) : rotation;
}

/// Descends to small boxes around one set of points.
class BoxSearch {
 public:
  explicit BoxSearch(const Points& points)
      : points_(static_cast<Eigen::Index>(points.size()), 3), heights_(points_.rows()) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      points_.row(static_cast<Eigen::Index>(i)) = points[i].transpose();
    }
  }

  Candidate at(const Matrix3d& axes) {
    double cost = 1.0;
    for (int k = 0; k < 3; ++k) {
      cost *= extentAlong(axes.col(k)) + kThickness;
    }
    return {axes, cost};
  }

  /// A simplex search around a candidate, then around each of its axes in turn.
  void descend(double first_step, Candidate& candidate) {
    const auto cost = [&](const Vector3d& turn) {
      return at(turned(candidate.rotation, turn)).cost;
    };
    const Vector3d turn = searchSimplex<3>({first_step, 1e-5, 150}, cost);
    candidate = at(turned(candidate.rotation, turn));
    alignWithEdges(candidate);
  }

  void alignWithEdges(Candidate& candidate) {
    constexpr int kMaxRounds = 10;
    for (int round = 0; round < kMaxRounds; ++round) {
      const double before = candidate.cost;
      for (int k = 0; k < 3; ++k) {
        candidate = std::min(candidate, at(turnedByCalipers(candidate.rotation, k)), isBetter);
      }
      if (!(candidate.cost < before * (1.0 - 1e-6))) {
        return;
      }
    }
  }

 private:
  double extentAlong(const Vector3d& axis) {
    heights_ = points_.col(0) * axis.x() + points_.col(1) * axis.y() + points_.col(2) * axis.z();
    return heights_.maxCoeff() - heights_.minCoeff();
  }

  /// The box with the least area across its fixed axis `k`. One side of the least rectangle around
  /// a polygon lies on an edge of it (Freeman, Shapira 1975).
  Matrix3d turnedByCalipers(const Matrix3d& axes, int k) {
    const Vector3d u = axes.col((k + 1) % 3);
    const Vector3d v = axes.col((k + 2) % 3);
    flat_.clear();
    for (Eigen::Index i = 0; i < points_.rows(); ++i) {
      flat_.emplace_back(points_.row(i).dot(u), points_.row(i).dot(v));
    }
    const Eigen::Vector2d edge = bestEdge(convexPolygonOf(flat_));
    Matrix3d result = axes;
    result.col((k + 1) % 3) = (edge.x() * u + edge.y() * v).normalized();
    result.col((k + 2) % 3) = axes.col(k).cross(result.col((k + 1) % 3)).normalized();
    return result;
  }

  Eigen::Vector2d bestEdge(const std::vector<std::uint32_t>& polygon) const {
    double best_area = std::numeric_limits<double>::infinity();
    Eigen::Vector2d best_edge = Eigen::Vector2d::UnitX();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Eigen::Vector2d along = flat_[polygon[(i + 1) % polygon.size()]] - flat_[polygon[i]];
      if (!(along.norm() > 0.0)) {
        continue;
      }
      const Eigen::Vector2d edge = along.normalized();
      Eigen::AlignedBox2d box;
      for (const auto corner : polygon) {
        const Eigen::Vector2d& p = flat_[corner];
        box.extend(Eigen::Vector2d(p.dot(edge), p.y() * edge.x() - p.x() * edge.y()));
      }
      const double area = (box.sizes().array() + kThickness).prod();
      if (area < best_area) {
        best_area = area;
        best_edge = edge;
      }
    }
    return best_edge;
  }

  PointMatrix points_;
  Eigen::VectorXd heights_;
  std::vector<Eigen::Vector2d> flat_;
};

/// Searches of different sizes around the best box so far. A search that ends in a kink of the
/// volume, where a face meets an edge, leaves it with another simplex.
void refine(BoxSearch& search, Candidate& candidate) {
  for (const double first_step : {-0.03, 0.01, -0.1, 0.03}) {
    search.descend(first_step, candidate);
  }
}

/// 0 for axes that are equal up to order and sign.
double axisDifference(const Matrix3d& a, const Matrix3d& b) {
  return 3.0 - (a.transpose() * b).cwiseAbs().rowwise().maxCoeff().sum();
}

/// The best candidates, of which no two are equal boxes.
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

std::vector<Candidate> startBoxes(const Points& points, BoxSearch& search) {
  static const std::vector<Matrix3d> kRotations = spreadRotations(kStartRotations);
  std::vector<Candidate> starts;
  starts.reserve(kRotations.size());
  for (const auto& rotation : kRotations) {
    starts.push_back(search.at(rotation));
  }
  starts = distinctBest(std::move(starts), kDescents);
  starts.push_back(search.at(principalAxes(points)));
  starts.push_back(search.at(Matrix3d::Identity()));
  return starts;
}

}  // namespace

TurnedCore boxWithAxes(const Matrix3d& axes, const Points& points) {
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
  BoxSearch search(points);
  Candidate candidate = search.at(axes);
  search.descend(kFirstStep, candidate);
  refine(search, candidate);
  return candidate.rotation;
}

Matrix3d roughBoxRotation(const Points& points) {
  BoxSearch search(points);
  auto starts = startBoxes(points, search);
  for (auto& candidate : starts) {
    search.alignWithEdges(candidate);
  }
  return std::min_element(starts.begin(), starts.end(), isBetter)->rotation;
}

std::vector<Matrix3d> smallBoxRotations(const Points& points, std::size_t count) {
  BoxSearch search(points);
  auto starts = startBoxes(points, search);
  for (auto& candidate : starts) {
    search.descend(kFirstStep, candidate);
  }
  // Most starts have met by now. Those far behind will not catch up.
  starts = distinctBest(std::move(starts), count + 1);
  for (auto& candidate : starts) {
    refine(search, candidate);
  }
  std::vector<Matrix3d> rotations;
  for (const auto& candidate : distinctBest(std::move(starts), count)) {
    rotations.push_back(candidate.rotation);
  }
  return rotations;
}

}  // namespace collision_monitor
