// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/shapes/rough_fit.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "fitting/proofs/near_cores.h"
#include "fitting/search/simplex_search.h"
#include "fitting/shapes/fit_sphere.h"

namespace collision_monitor {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

enum Kind : std::size_t { kSphere, kCapsule, kBox, kRoundedBox };

// By how much the edges of a box are rounded, as a fraction of its least half extent.
constexpr double kRoundings[] = {0.3, 0.6, 1.0};

/// Between the mean and the maximum. Units: metres.
double roughCost(const OvershootSum& sum) noexcept {
  const Overshoot overshoot = sum.total();
  return overshoot.fourth_power_mean + 0.3 * overshoot.max;
}

/// Keeps the better one of the best so far and another core.
void consider(const TurnedCore& core, Kind kind, const RoughGoal& goal, RoughFit& best) {
  const double cost = goal.costOf(core, best.cost);
  if (cost < best.cost) {
    best = {core, kind, cost};
  }
}

TurnedCore roundedIn(const TurnedCore& box, double rounding, const Points& points) {
  TurnedCore core = box;
  core.half_extents = (box.half_extents - Vector3d::Constant(rounding)).cwiseMax(0.0);
  core.radius = enclosingRadius(core, points);
  return core;
}

/// A capsule along the longest axis, which becomes z.
TurnedCore capsuleIn(const TurnedCore& box, const Points& points) {
  Eigen::Index longest = 0;
  box.half_extents.maxCoeff(&longest);
  TurnedCore core = box;
  for (Eigen::Index k = 0; k < 3; ++k) {
    core.rotation.col((k + 2 - longest + 3) % 3) = box.rotation.col(k);
  }
  Vector3d across = box.half_extents;
  across[longest] = 0.0;
  core.half_extents = {0.0, 0.0, std::max(box.half_extents[longest] - across.maxCoeff(), 0.0)};
  core.radius = enclosingRadius(core, points);
  return core;
}

/// The core of a kind, moved by `step` (relative to the size): rotation, shift, change of extents.
template <int N>
TurnedCore stepped(const RoughFit& fit, double size, const Eigen::Matrix<double, N, 1>& step,
                   const Points& points) {
  TurnedCore core = fit.core;
  const Vector3d turn = step.template head<3>();
  if (turn.squaredNorm() > 0.0) {
    core.rotation = fit.core.rotation * Eigen::AngleAxisd(turn.norm(), turn.normalized());
  }
  if constexpr (N == 3) {
    return boxAround(core.rotation, points);
  } else {
    core.center += size * core.rotation * step.template segment<3>(3);
    if constexpr (N == 7) {
      core.half_extents.z() = std::abs(core.half_extents.z() + size * step[6]);
    } else {
      core.half_extents = (core.half_extents + size * step.template tail<3>()).cwiseAbs();
    }
    core.radius = enclosingRadius(core, points);
    return core;
  }
}

template <int N>
RoughFit polishedIn(const RoughFit& fit, const Points& points, const RoughGoal& goal) {
  const double size = fit.core.half_extents.norm() + fit.core.radius;
  const SimplexLimits limits{0.1, 1e-3, 40 * N};
  const auto best =
      searchSimplex<N>(limits, [&](const Eigen::Matrix<double, N, 1>& step, double bound) {
        return goal.costOf(stepped<N>(fit, size, step, points), bound);
      });
  RoughFit result = fit;
  result.core = stepped<N>(fit, size, best, points);
  result.cost = goal.costOf(result.core);
  return result;
}

}  // namespace

TurnedCore boxAround(const Matrix3d& frame, const Points& points) {
  Vector3d low = frame.transpose() * points.front();
  Vector3d high = low;
  for (const auto& point : points) {
    const Vector3d at = frame.transpose() * point;
    low = low.cwiseMin(at);
    high = high.cwiseMax(at);
  }
  TurnedCore core;
  core.rotation = frame;
  core.center = frame * (0.5 * (low + high));
  core.half_extents = 0.5 * (high - low);
  return core;
}

OvershootSum RoughGoal::overshootOf(const TurnedCore& core, double bound) const {
  constexpr double kNear = 0.05;  // of the size: a shape's own face at the plane
  const double near = plane ? kNear * (core.half_extents.norm() + core.radius) : 0.0;
  const NearCores near_others(others, core, grid.spacing());
  const auto skip = [&](const PointRows& points,
                        std::array<unsigned char, PointRows::kMost>& is_skipped) {
    near_others.mark(points, is_skipped);
    for (std::size_t i = 0; plane && i < points.count; ++i) {
      const Vector3d point(points.at[0][i], points.at[1][i], points.at[2][i]);
      is_skipped[i] = is_skipped[i] != 0 || std::abs(plane->heightOf(point)) < near;
    }
  };
  return roughOvershoot(core, grid, skip,
                        [&](const OvershootSum& least) { return roughCost(least) >= bound; });
}

double RoughGoal::costOf(const TurnedCore& core, double bound) const {
  return roughCost(overshootOf(core, bound));
}

RoughFit fitRoughly(const Points& points, const std::vector<Matrix3d>& frames,
                    const RoughGoal& goal) {
  RoughFit best;
  for (const auto& frame : frames) {
    const TurnedCore box = boxAround(frame, points);
    if (goal.kinds.box) {
      consider(box, kBox, goal, best);
    }
    if (goal.kinds.capsule) {
      consider(capsuleIn(box, points), kCapsule, goal, best);
    }
    for (const double rounding : kRoundings) {
      if (goal.kinds.rounded_box) {
        const double depth = rounding * box.half_extents.minCoeff();
        consider(roundedIn(box, depth, points), kRoundedBox, goal, best);
      }
    }
  }
  if (goal.kinds.sphere && !(goal.kinds.capsule && goal.kinds.rounded_box)) {
    TurnedCore core;
    core.center = fitSphere(points).geometry_from_body.translation;
    core.radius = enclosingRadius(core, points);
    consider(core, kSphere, goal, best);
  }
  return best;
}

RoughFit polished(const RoughFit& fit, const Points& points, const RoughGoal& goal) {
  switch (fit.kind) {
    case kBox:
      return polishedIn<3>(fit, points, goal);
    case kCapsule:
      return polishedIn<7>(fit, points, goal);
    case kRoundedBox:
      return polishedIn<9>(fit, points, goal);
    default:
      return fit;
  }
}

PosedShape placedShape(const RoughFit& fit) {
  const TurnedCore& core = fit.core;
  const Pose pose{core.rotation, core.center};
  switch (fit.kind) {
    case kSphere:
      return {Sphere{core.radius}, pose};
    case kCapsule:
      return {Capsule{core.half_extents.z(), core.radius}, pose};
    case kBox:
      return {Box{core.half_extents}, pose};
    default:
      return {RoundedBox{core.half_extents, core.radius}, pose};
  }
}

TurnedCore coreOf(const PosedShape& shape) noexcept {
  const Pose& pose = shape.geometry_from_body;
  return {pose.rotation, pose.translation, coreHalfExtents(shape.shape), radiusOf(shape.shape)};
}

}  // namespace collision_monitor
