// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/limit_step.h"

#include <algorithm>
#include <cmath>

#include "collision_monitor/geometry/twist.h"

namespace collision_monitor {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double thicknessOf(const Shape& shape) noexcept {
  return 2.0 * (coreHalfExtents(shape).minCoeff() + radiusOf(shape));
}

/// Per step.
Twist twistOf(const ScrewMotion& motion) noexcept {
  return twistAbout(motion.start.translation, motion.travel, motion.turn);
}

/// What of the links' motion nobody looks at, per step.
void findUnseen(const CycleSetup& setup, SweepWork& work) noexcept {
  constexpr double kBend = 1.0 / 8.0;
  const double longer = work.last_elapsed > 0.0 ? work.elapsed / work.last_elapsed : 0.0;
  for (std::size_t i = 0; i < work.unseen.size(); ++i) {
    const Twist now = twistOf(work.link_motions[i]);
    const bool is_known = work.has_motion[i] != 0 &&
                          (!setup.is_continuous || (work.had_motion[i] != 0 && longer > 0.0));
    const Twist seen = setup.is_continuous ? longer * twistOf(work.last_motions[i]) : Twist();
    work.unseen[i] = is_known ? (setup.is_continuous ? kBend : 1.0) * (now - seen) : Twist();
  }
}

}  // namespace

std::vector<double> thicknessOfPairs(const CycleSetup& setup) {
  std::vector<double> least(setup.checked.size(), kInfinity);
  for (std::size_t i = 0; i < setup.table.size(); ++i) {
    const BodyPair& pair = setup.table.pairs()[i];
    const double thickness = thicknessOf(setup.bodies[index(pair.a)].shape) +
                             thicknessOf(setup.bodies[index(pair.b)].shape);
    double& of_links = least[setup.link_pair_of[i]];
    of_links = thickness > 0.0 ? std::min(of_links, thickness) : of_links;
  }
  return least;
}

void limitStep(const CycleSetup& setup, SweepWork& work) noexcept {
  findUnseen(setup, work);
  StepLimit& limit = work.step;
  limit = {work.elapsed, kInfinity, kNone, false};
  for (LinkPairIndex i = 0; i < setup.checked.size(); ++i) {
    const std::size_t a = index(setup.checked[i].a);
    const std::size_t b = index(setup.checked[i].b);
    const Ball& ball = work.link_balls[b];
    const Twist twist = work.unseen[b] - work.unseen[a];
    const Eigen::Vector3d center = work.link_motions[b].start * ball.center;
    const double way = velocityAt(twist, center).norm() + twist.angular.norm() * ball.radius;
    const double share = work.thickness[i] / way;
    // A way grows with the step, a bend with its square.
    const double longest = work.elapsed * (setup.is_continuous ? std::sqrt(share) : share);
    if (longest < limit.longest) {
      limit.longest = longest;
      limit.pair = i;
    }
  }
  limit.is_exceeded = limit.step > limit.longest;
}

}  // namespace collision_monitor
