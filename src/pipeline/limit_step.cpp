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

/// Per step, by LinkId; an unknown link counts as one at rest.
void findTwists(const CycleSetup& setup, SweepWork& work) noexcept {
  constexpr double kBend = 1.0 / 8.0;
  const double longer = work.last_elapsed > 0.0 ? work.elapsed / work.last_elapsed : 0.0;
  for (std::size_t i = 0; i < work.twists.size(); ++i) {
    const ScrewMotion& motion = work.link_motions[i];
    work.ball_centers[i] = motion.start * work.link_balls[i].center;
    work.twists[i] = work.has_motion[i] != 0 ? twistOf(motion) : Twist();
    if (setup.is_continuous) {
      const bool is_known = work.has_motion[i] != 0 && work.had_motion[i] != 0 && longer > 0.0;
      work.bends[i] =
          is_known ? kBend * (work.twists[i] - longer * twistOf(work.last_motions[i])) : Twist();
    }
  }
}

/// The pair that goes farthest, measured by its thickness.
struct Farthest {
  double share{0.0};  ///< way / thickness
  LinkPairIndex pair{kNone};
};

/// @param twists per step, by LinkId
Farthest findFarthest(const CycleSetup& setup, const SweepWork& work,
                      const std::vector<Twist>& twists) noexcept {
  Farthest farthest;
  for (LinkPairIndex i = 0; i < setup.checked.size(); ++i) {
    const std::size_t a = index(setup.checked[i].a);
    const std::size_t b = index(setup.checked[i].b);
    const Twist twist = twists[b] - twists[a];
    const double radius = work.link_balls[b].radius;
    const double moved = velocityAt(twist, work.ball_centers[b]).squaredNorm();
    const double turned = twist.angular.squaredNorm() * radius * radius;
    const double least = farthest.share * work.thickness[i];
    // The way's square is at most twice that: most pairs need no root.
    if (2.0 * (moved + turned) > least * least) {
      const double share = (std::sqrt(moved) + std::sqrt(turned)) / work.thickness[i];
      farthest = share > farthest.share ? Farthest{share, i} : farthest;
    }
  }
  return farthest;
}

StepCap capOf(double step, double longest, LinkPairIndex pair) noexcept {
  return {longest, pair, step > longest};
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
  findTwists(setup, work);
  StepLimit& limit = work.step;
  limit.step = work.elapsed;
  const Farthest moved = findFarthest(setup, work, work.twists);
  limit.at_poses = capOf(work.elapsed, work.elapsed / moved.share, moved.pair);
  limit.on_way = limit.at_poses;
  if (setup.is_continuous) {
    // A way grows with the step, a bend with its square.
    const Farthest bent = findFarthest(setup, work, work.bends);
    limit.on_way = capOf(work.elapsed, work.elapsed / std::sqrt(bent.share), bent.pair);
  }
}

}  // namespace collision_monitor
