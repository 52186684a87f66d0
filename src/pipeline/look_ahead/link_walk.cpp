// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/look_ahead/link_walk.h"

#include <algorithm>
#include <cmath>

#include "geometry/constants.h"
#include "model/object_links.h"
#include "pipeline/data/activation_distance.h"
#include "pipeline/data/motion_bound.h"
#include "pipeline/look_ahead/object_ranges.h"
#include "pipeline/look_ahead/walk_link_pairs.h"

namespace collision_monitor {
namespace {

double thicknessOf(const Shape& shape) noexcept {
  return 2.0 * (coreHalfExtents(shape).minCoeff() + radiusOf(shape));
}

/// The links that need columns, in order of id.
std::vector<LinkId> linksInPairs(const CycleSetup& setup) {
  const LinkId first_of_world = firstOfWorld(setup.model);
  const std::vector<LinkId> first_of = firstCarried(setup.model);
  std::vector<bool> is_in_pair(setup.model.links.size(), false);
  for (const CheckedLinkPair& pair : setup.checked) {
    is_in_pair[index(pair.a)] = true;
    is_in_pair[index(isInRange(first_of_world, pair) ? first_of[index(pair.b)] : pair.b)] = true;
  }
  std::vector<LinkId> links;
  for (std::size_t link = 0; link < is_in_pair.size(); ++link) {
    if (is_in_pair[link]) {
      links.push_back(idAt<LinkId>(link));
    }
  }
  return links;
}

std::vector<LinkBlock> makeLinkBlocks(const CycleSetup& setup, const std::vector<LinkId>& links,
                                      const std::vector<double>& thickness) {
  const auto slotOf = [&](LinkId link) {
    const auto place = std::lower_bound(links.begin(), links.end(), link);
    return static_cast<std::uint32_t>(place - links.begin());
  };
  const LinkId first_of_world = firstOfWorld(setup.model);
  std::vector<LinkBlock> blocks;
  for (std::uint32_t i = 0; i < setup.checked.size(); ++i) {
    const CheckedLinkPair& pair = setup.checked[i];
    if (isInRange(first_of_world, pair)) {
      continue;
    }
    const std::uint32_t a = slotOf(pair.a);
    const std::uint32_t b = slotOf(pair.b);
    if (blocks.empty() || blocks.back().pairs.one != a ||
        b >= blocks.back().pairs.first + kBlockLanes) {
      blocks.emplace_back().pairs = {a, b, 0, i};
    }
    LinkBlock& block = blocks.back();
    const std::uint32_t lane = b - block.pairs.first;
    block.pairs.is_pair |= 1U << lane;
    block.thickness[lane] = thickness[i];
  }
  return blocks;
}

/// @pre blocks and of_limits are filled
std::vector<LaneReaches> makeLaneReaches(const CycleSetup& setup,
                                         const ActivationDistances& reaches) {
  std::vector<LaneReaches> of_blocks;
  if (setup.own_limits.empty()) {
    return of_blocks;
  }
  for (const LinkBlock& block : reaches.blocks) {
    LaneReaches& lanes = of_blocks.emplace_back();
    std::size_t pair = block.pairs.first_pair;
    for (std::size_t lane = 0; lane < kBlockLanes; ++lane) {
      if ((block.pairs.is_pair >> lane & 1U) != 0) {
        const PairReach& reach = reaches.of_limits[setup.checked[pair++].limits];
        lanes.all[lane] = reach.all;
        lanes.stop[lane] = reach.stop;
        lanes.contact[lane] = reach.contact;
      }
    }
  }
  return of_blocks;
}

PairReach reachFor(const CycleSetup& setup, const Limits& limits) {
  PairReach reach;
  reach.all = activationDistanceOf(limits);
  reach.near = nearActivationDistanceOf(setup, limits);
  reach.contact = std::max(0.0, limits.contact_distance);  // as contactOfBodies
  reach.stop = std::max(reach.contact, setup.ahead.stop.stop_distance + limits.hysteresis);
  return reach;
}

PairReach farthestOf(const std::vector<PairReach>& of_limits) {
  PairReach farthest = of_limits.front();
  for (const PairReach& reach : of_limits) {
    farthest.all = std::max(farthest.all, reach.all);
    farthest.near = std::max(farthest.near, reach.near);
    farthest.stop = std::max(farthest.stop, reach.stop);
    farthest.contact = std::max(farthest.contact, reach.contact);
  }
  return farthest;
}

void writeTwist(const Twist& twist, std::size_t c, std::size_t slot, BodyRows& rows) noexcept {
  writeVector(twist.linear, c, slot, rows);
  writeVector(twist.angular, c + 3, slot, rows);
}

/// [m] An upper bound of how far any point of the ball has moved since the last cycle.
double travelOf(const ScrewMotion& motion, const Ball& ball) noexcept {
  return velocityAt(motion, ball.center).norm() + motion.turn.norm() * ball.radius;
}

/// Per time between two cycles.
Twist twistOf(const ScrewMotion& motion) noexcept {
  return twistAbout(motion.start.translation, motion.travel, motion.turn);
}

/// Writes where links are, how they move and how far their pairs are looked at.
void writeLinks(const CycleSetup& setup, const LinkPoses& poses, const RobotSpeeds& robots,
                const SweepWork& sweep, ActivationDistances& reaches) noexcept {
  const Twist unknown{Eigen::Vector3d::Constant(kUnknown), Eigen::Vector3d::Constant(kUnknown)};
  const LinkVelocities& velocities = poses.velocities;
  for (std::size_t slot = 0; slot < reaches.links.size(); ++slot) {
    const std::size_t link = index(reaches.links[slot]);
    const Ball& ball = reaches.balls[slot];
    writeVector(poses.world_from_link[link] * ball.center, link_column::center, slot, reaches.rows);
    writeTwist(velocities.known[link] != 0 ? velocities.of_link[link] : unknown,
               link_column::velocity, slot, reaches.rows);
    reaches.rows.at(link_column::travel)[slot] =
        setup.is_continuous ? travelOf(sweep.link_motions[link], ball) : 0.0;
    const Watched& watched = robots.watched[robots.robot_of_link[link]];
    reaches.rows.at(link_column::time)[slot] = watched.time;
    reaches.rows.at(link_column::distance)[slot] = watched.distance;
  }
}

/// Writes how links moved since the last cycle; unknown motion counts as rest.
void writeSteps(const SweepWork& sweep, ActivationDistances& reaches) noexcept {
  constexpr double kBend = 1.0 / 8.0;
  const double longer = sweep.last_elapsed > 0.0 ? sweep.elapsed / sweep.last_elapsed : 0.0;
  for (std::size_t slot = 0; slot < reaches.links.size(); ++slot) {
    const std::size_t link = index(reaches.links[slot]);
    const ScrewMotion& motion = sweep.link_motions[link];
    const Twist moved = sweep.has_motion[link] != 0 ? twistOf(motion) : Twist();
    const bool is_known =
        sweep.has_motion[link] != 0 && sweep.had_motion[link] != 0 && longer > 0.0;
    const Twist bent =
        is_known ? kBend * (moved - longer * twistOf(sweep.last_motions[link])) : Twist();
    writeVector(motion.start * reaches.balls[slot].center, link_column::last_center, slot,
                reaches.rows);
    writeTwist(moved, link_column::moved, slot, reaches.rows);
    writeTwist(bent, link_column::bent, slot, reaches.rows);
  }
}

/// Gives pairs of two parts an infinite thickness: they limit no step.
void splitBlocks(const LinkPoses& poses, ActivationDistances& reaches) noexcept {
  for (LinkBlock& block : reaches.blocks) {
    std::size_t pair = block.pairs.first_pair;
    const PartId part = poses.part[index(reaches.links[block.pairs.one])];
    for (std::size_t lane = 0; lane < kBlockLanes; ++lane) {
      if ((block.pairs.is_pair >> lane & 1U) != 0) {
        const LinkId other = reaches.links[block.pairs.first + lane];
        block.thickness[lane] =
            poses.part[index(other)] == part ? reaches.thickness[pair] : kInfinity;
        ++pair;
      }
    }
  }
}

/// Updates thickness; costs nothing while all links are in one part.
void findSplit(const LinkPoses& poses, ActivationDistances& reaches) noexcept {
  const bool was_split = reaches.is_split;
  reaches.is_split = std::any_of(reaches.links.begin(), reaches.links.end(), [&](LinkId link) {
    return poses.part[index(link)] != poses.part[index(reaches.links.front())];
  });
  if (was_split || reaches.is_split) {
    splitBlocks(poses, reaches);
  }
}

void findWatched(const CycleSetup& setup, const ActivationDistances& reaches,
                 RobotSpeeds& robots) noexcept {
  for (std::size_t i = 0; i < robots.watched.size(); ++i) {
    const LeastOfPairs& expected = robots.expected[i];
    const double told = std::max(expected.time, setup.ahead.stop.stop_time * expected.scale);
    const auto cut = [&](double time) { return std::min(time, setup.ahead.horizon); };
    const double of_contact = std::max(told, reaches.contact_time);
    robots.watched[i] = {cut(std::max(of_contact, reaches.warning_time)), cut(of_contact),
                         expected.distance, expected.warned};
  }
}

StepCap capOf(double step, double longest, LinkPairIndex pair) noexcept {
  return {longest, pair, step > longest};
}

}  // namespace

ActivationDistances makeActivationDistances(const CycleSetup& setup) {
  ActivationDistances reaches;
  reaches.links = linksInPairs(setup);
  reaches.thickness = thicknessOfPairs(setup);
  reaches.of_limits.push_back(reachFor(setup, setup.limits));
  for (const OwnLimits& own : setup.own_limits) {
    reaches.of_limits.push_back(reachFor(setup, own.limits));
  }
  reaches.farthest = farthestOf(reaches.of_limits);
  reaches.least_near = std::min_element(reaches.of_limits.begin(), reaches.of_limits.end(),
                                        [](const PairReach& one, const PairReach& other) {
                                          return one.near < other.near;
                                        })
                           ->near;
  reaches.contact_time = largestOfLimits(setup, [](const Limits& limits) noexcept {
    return limits.contact_time > 0.0 ? limits.contact_time + limits.time_hysteresis : 0.0;
  });
  reaches.warning_time = largestOfLimits(setup, [](const Limits& limits) noexcept {
    return limits.warning_time > 0.0 ? limits.warning_time + limits.time_hysteresis : 0.0;
  });
  reaches.blocks = makeLinkBlocks(setup, reaches.links, reaches.thickness);
  reaches.of_blocks = makeLaneReaches(setup, reaches);
  reaches.rows.stride = (groupCountOf(reaches.links.size()) + 1) * kBlockLanes;
  reaches.rows.numbers.resize(link_column::count * reaches.rows.stride, 0.0);
  const std::vector<Ball> balls = linkBalls(setup);
  for (std::size_t slot = 0; slot < reaches.links.size(); ++slot) {
    reaches.balls.push_back(balls[index(reaches.links[slot])]);
    reaches.rows.at(link_column::radius)[slot] = reaches.balls.back().radius;
  }
  makeObjectRanges(setup, reaches);
  reaches.motion.resize(setup.checked.size() + reaches.ranges.size(), kInfinity);
  reaches.told = reaches.speed = reaches.motion;
  return reaches;
}

std::vector<double> thicknessOfPairs(const CycleSetup& setup) {
  std::vector<double> of_bodies;
  of_bodies.reserve(setup.bodies.size());
  for (const Body& body : setup.bodies) {
    of_bodies.push_back(thicknessOf(body.shape));
  }
  std::vector<double> least(setup.checked.size(), kInfinity);
  for (std::size_t i = 0; i < setup.table.size(); ++i) {
    const BodyPair& pair = setup.table.pairs()[i];
    const double thickness = of_bodies[index(pair.a)] + of_bodies[index(pair.b)];
    double& of_links = least[setup.link_pair_of[i]];
    of_links = thickness > 0.0 ? std::min(of_links, thickness) : of_links;
  }
  return least;
}

void findActivationDistances(const CycleSetup& setup, const LinkPoses& poses, RobotSpeeds& robots,
                             SweepWork& sweep, ActivationDistances& reaches) noexcept {
  const bool has_step = sweep.elapsed > 0.0;
  findWatched(setup, reaches, robots);
  writeLinks(setup, poses, robots, sweep, reaches);
  findSplit(poses, reaches);
  if (has_step) {
    writeSteps(sweep, reaches);
  }
  const WalkQuestion question{has_step, setup.is_continuous};
  Farthest farthest = walkLinkPairs(question, reaches);
  walkObjectRanges(question, poses, reaches, farthest);
  if (has_step) {
    StepLimit& limit = sweep.step;
    limit.step = sweep.elapsed;
    limit.at_poses =
        capOf(sweep.elapsed, sweep.elapsed / farthest.moved.share, farthest.moved.pair);
    // Travel grows with the time between poses, bending with its square.
    limit.on_way = setup.is_continuous
                       ? capOf(sweep.elapsed, sweep.elapsed / std::sqrt(farthest.bent.share),
                               farthest.bent.pair)
                       : limit.at_poses;
  }
}

}  // namespace collision_monitor
