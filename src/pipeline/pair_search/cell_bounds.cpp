// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/pair_search/cell_bounds.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace collision_monitor {
namespace {

/// [rad] or [m] How far a joint moves a point with a lever of one metre.
double chordOf(const PlacedCell& placed, std::size_t joint) noexcept {
  const double half = placed.halves[joint];
  return placed.motion.joints[joint].is_prismatic ? half
                                                  : 2.0 * std::sin(0.5 * std::min(half, kPi));
}

/// Moves a ball that is known to have moved by `moved`. Returns its lever.
double moveBy(const PlacedCell& placed, std::size_t joint, const Ball& ball,
              double& moved) noexcept {
  if (placed.motion.joints[joint].is_prismatic) {
    moved += chordOf(placed, joint);
    return 1.0;
  }
  const double lever =
      placed.axes[joint].cross(ball.center - placed.points[joint]).norm() + ball.radius + moved;
  moved += chordOf(placed, joint) * lever;
  return lever;
}

Ball swept(const PlacedCell& placed, std::size_t joint, const Ball& ball) noexcept {
  const double half = placed.halves[joint];
  if (placed.motion.joints[joint].is_prismatic) {
    return {ball.center, ball.radius + half};
  }
  const Eigen::Vector3d& axis = placed.axes[joint];
  const Eigen::Vector3d arm = ball.center - placed.points[joint];
  const Eigen::Vector3d across = arm - axis.dot(arm) * axis;
  const double angle = std::min(half, 0.5 * kPi);
  return {ball.center - (1.0 - std::cos(angle)) * across,
          ball.radius + std::sin(angle) * across.norm()};
}

void placeBalls(const std::vector<Ball>& balls, const Pose& world_from_link, std::size_t splits,
                std::size_t first, SweptBalls& swept_balls) {
  swept_balls.count = balls.size();
  swept_balls.balls.resize(splits * balls.size());
  for (std::size_t i = 0; i < balls.size(); ++i) {
    swept_balls.balls[first * balls.size() + i] = {world_from_link * balls[i].center,
                                                   balls[i].radius};
  }
}

void sweep(const PlacedCell& placed, std::size_t joint, std::size_t from, std::size_t to,
           SweptBalls& balls) noexcept {
  for (std::size_t i = 0; i < balls.count; ++i) {
    balls.balls[to * balls.count + i] = swept(placed, joint, balls.balls[from * balls.count + i]);
  }
}

/// The derivative of n . x by each variable, at a point x of one side: x . across + constant.
struct Slopes {
  std::vector<Eigen::Vector3d> across;
  std::vector<double> constant;
  std::vector<double> half;
};

/// @param first, last the joints that move this side; moves_a: it is A
Slopes slopesOf(const PlacedCell& placed, const Eigen::Vector3d& normal, std::size_t first,
                std::size_t last, bool moves_a) {
  const PairMotion& motion = placed.motion;
  Slopes slopes{std::vector<Eigen::Vector3d>(motion.ranges.size(), Eigen::Vector3d::Zero()),
                std::vector<double>(motion.ranges.size(), 0.0),
                std::vector<double>(motion.ranges.size(), 0.0)};
  for (std::size_t i = first; i < last; ++i) {
    const PairJoint& joint = motion.joints[i];
    const double factor = joint.carries_b == moves_a ? -joint.factor : joint.factor;
    slopes.half[joint.variable] = placed.halves[i] / std::abs(joint.factor);
    if (joint.is_prismatic) {
      slopes.constant[joint.variable] += factor * normal.dot(placed.axes[i]);
    } else {
      const Eigen::Vector3d across = normal.cross(placed.axes[i]);
      slopes.across[joint.variable] += factor * across;
      slopes.constant[joint.variable] -= factor * across.dot(placed.points[i]);
    }
  }
  return slopes;
}

/// The least of n . x less all it can change by, over the points; adds the changes at the least.
double leastAlong(const Eigen::Vector3d& normal, const Slopes& slopes, const PointCover& cover,
                  const Pose& world_from_link, std::vector<double>& changes) {
  const std::size_t count = slopes.half.size();
  double least = kInfinity;
  Eigen::Vector3d nearest = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& point : cover.points) {
    const Eigen::Vector3d x = world_from_link * point;
    double reach = normal.dot(x);
    for (std::size_t i = 0; i < count && reach < kInfinity; ++i) {
      reach -= slopes.half[i] * std::abs(slopes.across[i].dot(x) + slopes.constant[i]);
    }
    if (reach < least) {
      least = reach;
      nearest = x;
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    changes[i] += slopes.half[i] * std::abs(slopes.across[i].dot(nearest) + slopes.constant[i]);
  }
  return least - cover.radius;
}

/// Visits the second-order terms of one side, as visit(joint, other joint, value); a term of two
/// joints once. The joints begin at F and end at the link.
template <class Visit>
void visitCurvatures(const PlacedCell& placed, const std::vector<double>& levers, std::size_t first,
                     std::size_t last, Visit visit) noexcept {
  const auto joint_at = [&](std::size_t i) { return first < last ? first + i : first - 1 - i; };
  const std::size_t count = first < last ? last - first : first - last;
  for (std::size_t outer = 0; outer < count; ++outer) {
    const std::size_t j = joint_at(outer);
    const bool slides = placed.motion.joints[j].is_prismatic;
    const double reach = placed.halves[j] * (slides ? 1.0 : levers[j]);
    if (!slides) {
      visit(j, j, 0.5 * placed.halves[j] * reach);
    }
    for (std::size_t inner = 0; inner < outer; ++inner) {
      const std::size_t i = joint_at(inner);
      if (!placed.motion.joints[i].is_prismatic) {
        visit(i, j, placed.halves[i] * reach);
      }
    }
  }
}

}  // namespace

void findLevers(const PlacedCell& placed, const Ball& a, const Ball& b, Levers& levers) {
  const std::size_t count = placed.motion.joints.size();
  levers.of_a.resize(count);
  levers.of_b.resize(count);
  levers.moved_a.resize(count + 1);
  levers.moved_b.resize(count + 1);
  levers.moved_a[0] = levers.moved_b[count] = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    double moved = levers.moved_a[i];
    levers.of_a[i] = moveBy(placed, i, a, moved);
    levers.moved_a[i + 1] = moved;
  }
  for (std::size_t i = count; i > 0; --i) {
    double moved = levers.moved_b[i];
    levers.of_b[i - 1] = moveBy(placed, i - 1, b, moved);
    levers.moved_b[i - 1] = moved;
  }
  levers.travel = kInfinity;
  for (std::size_t i = 0; i <= count; ++i) {
    levers.travel = std::min(levers.travel, levers.moved_a[i] + levers.moved_b[i]);
  }
}

double shareOf(const PlacedCell& placed, const Levers& levers, std::size_t variable) noexcept {
  double share = 0.0;
  for (std::size_t i = 0; i < placed.motion.joints.size(); ++i) {
    if (placed.motion.joints[i].variable == variable) {
      share += chordOf(placed, i) * std::min(levers.of_a[i], levers.of_b[i]);
    }
  }
  return share;
}

bool areBallsApart(const PlacedCell& placed, const std::vector<Ball>& a, const std::vector<Ball>& b,
                   double rounding, SweepScratch& scratch) {
  const std::size_t count = placed.motion.joints.size();
  placeBalls(a, placed.world_from_link[index(placed.motion.a)], count + 1, 0, scratch.a);
  placeBalls(b, placed.world_from_link[index(placed.motion.b)], count + 1, count, scratch.b);
  for (std::size_t i = 0; i < count; ++i) {
    sweep(placed, i, i, i + 1, scratch.a);
    sweep(placed, count - 1 - i, count - i, count - 1 - i, scratch.b);
  }
  const auto is_apart = [&](std::size_t i, std::size_t j, std::size_t split) {
    const Ball& one = scratch.a.balls[split * a.size() + i];
    const Ball& other = scratch.b.balls[split * b.size() + j];
    const double reach = one.radius + other.radius + rounding;
    return (one.center - other.center).squaredNorm() > reach * reach;
  };
  std::size_t best = 0;  // splits that were good for one pair are mostly good for the next
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      std::size_t tried = 0;
      while (tried <= count && !is_apart(i, j, best)) {
        best = best == count ? 0 : best + 1;
        ++tried;
      }
      if (tried > count) {
        return false;
      }
    }
  }
  return true;
}

Curvature curvatureOf(const PlacedCell& placed, const Levers& levers) noexcept {
  const std::size_t count = placed.motion.joints.size();
  Curvature best;
  for (std::size_t split = 0; split <= count; ++split) {
    double total = 0.0;
    const auto add = [&](std::size_t /*one*/, std::size_t /*other*/, double value) {
      total += value;
    };
    visitCurvatures(placed, levers.of_a, split, 0, add);
    visitCurvatures(placed, levers.of_b, split, count, add);
    if (total < best.total) {
      best = {split, total};
    }
  }
  return best;
}

void addCurvatures(const PlacedCell& placed, const Levers& levers, std::size_t split,
                   std::vector<double>& of_variable) noexcept {
  const std::vector<PairJoint>& joints = placed.motion.joints;
  const auto add = [&](std::size_t one, std::size_t other, double value) {
    of_variable[joints[one].variable] += 0.5 * value;
    of_variable[joints[other].variable] += 0.5 * value;
  };
  visitCurvatures(placed, levers.of_a, split, 0, add);
  visitCurvatures(placed, levers.of_b, split, joints.size(), add);
}

double gapAlong(const PlacedCell& placed, const Eigen::Vector3d& normal, const Curvature& curvature,
                const PointCover& a, const PointCover& b, std::vector<double>& first_order) {
  const PairMotion& motion = placed.motion;
  first_order.assign(motion.ranges.size(), 0.0);
  const Slopes of_a = slopesOf(placed, -normal, 0, curvature.split, true);
  const Slopes of_b = slopesOf(placed, normal, curvature.split, motion.joints.size(), false);
  return leastAlong(-normal, of_a, a, placed.world_from_link[index(motion.a)], first_order) +
         leastAlong(normal, of_b, b, placed.world_from_link[index(motion.b)], first_order) -
         curvature.total;
}

}  // namespace collision_monitor
