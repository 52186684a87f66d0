// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/shapes/fit_sphere.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

namespace collision_monitor {
namespace {

/// A ball and the points on its surface that determine it.
struct Ball {
  Eigen::Vector3d center{Eigen::Vector3d::Zero()};
  double radius{std::numeric_limits<double>::infinity()};
  Points support;
};

/// The smallest ball with all of `support` (1 to 4 points) on its surface.
/// @return false if the points are not affinely independent.
bool circumscribe(const Points& support, Ball& ball) {
  const auto edge_count = static_cast<Eigen::Index>(support.size()) - 1;
  ball.support = support;
  ball.center = support[0];
  if (edge_count > 0) {
    // The center is support[0] + sum of x_j edge_j with edge_i . (center - support[0]) =
    // |edge_i|^2 / 2 for every i.
    Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3> edges(3, edge_count);
    for (Eigen::Index i = 0; i < edge_count; ++i) {
      edges.col(i) = support[static_cast<std::size_t>(i) + 1] - support[0];
    }
    const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3> gram =
        edges.transpose() * edges;
    const auto solver = gram.fullPivLu();
    if (!solver.isInvertible()) {
      return false;
    }
    ball.center += edges * solver.solve(0.5 * gram.diagonal());
  }
  ball.radius = 0.0;
  for (const auto& point : support) {
    ball.radius = std::max(ball.radius, (point - ball.center).norm());
  }
  return true;
}

bool holdsAll(const Ball& ball, const Points& points) {
  // Rounding of the circumcenter may put a point of the support farther out by this.
  const double limit = ball.radius * (1.0 + 1e-12);
  return std::all_of(points.begin(), points.end(),
                     [&](const auto& p) { return (p - ball.center).norm() <= limit; });
}

/// The smallest ball of up to five points that has the last one on its surface.
Ball smallestBall(const Points& candidates) {
  Ball best;
  const std::size_t others = candidates.size() - 1;
  for (unsigned subset = 0; subset < (1u << others); ++subset) {
    Points support{candidates.back()};
    for (std::size_t i = 0; i < others; ++i) {
      if ((subset >> i & 1u) != 0u) {
        support.push_back(candidates[i]);
      }
    }
    Ball ball;
    if (support.size() <= 4 && circumscribe(support, ball) && ball.radius < best.radius &&
        holdsAll(ball, candidates)) {
      best = ball;
    }
  }
  return best;
}

std::size_t farthestFrom(const Eigen::Vector3d& center, const Points& points) {
  std::size_t farthest = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    if ((points[i] - center).squaredNorm() > (points[farthest] - center).squaredNorm()) {
      farthest = i;
    }
  }
  return farthest;
}

/// Grows the ball until it holds all points. The farthest point enters the support each time.
void growOver(const Points& points, Ball& ball) {
  for (;;) {
    Points candidates = ball.support;
    candidates.push_back(points[farthestFrom(ball.center, points)]);
    const double reach = (candidates.back() - ball.center).norm();
    if (reach <= ball.radius * (1.0 + 1e-13)) {
      return;
    }
    const Ball larger = smallestBall(candidates);
    // In exact arithmetic every round grows the ball. If it does not, doubles allow no better.
    if (!(larger.radius > ball.radius) || !std::isfinite(larger.radius)) {
      return;
    }
    ball = larger;
  }
}

}  // namespace

PosedShape fitSphere(const Points& points) {
  constexpr std::size_t kStride = 16;
  Ball ball;
  circumscribe({points[0]}, ball);
  // A few of many points suffice for most rounds.
  Points few;
  for (std::size_t i = 0; i < points.size(); i += kStride) {
    few.push_back(points[i]);
  }
  growOver(few, ball);
  growOver(points, ball);
  const double radius = (points[farthestFrom(ball.center, points)] - ball.center).norm();
  return {Sphere{radius}, {Eigen::Matrix3d::Identity(), ball.center}};
}

}  // namespace collision_monitor
