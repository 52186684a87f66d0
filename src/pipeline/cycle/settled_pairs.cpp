// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/cycle/settled_pairs.h"

#include <algorithm>
#include <cmath>

#include "geometry/constants.h"
#include "pipeline/data/activation_distance.h"
#include "pipeline/refine/refinement.h"

namespace collision_monitor {
namespace {

constexpr double kRounding = 1e-9;  // [m] of bounds and travels

/// [m] An upper bound of the distance; infinite if the search has only proven a lower one, or if
/// meshes overlap: a point inside an open one may leave it through a hole.
double farthestOf(const PairDistance& pair) noexcept {
  const bool has_points = (pair.is_refined && !pair.is_raised) || pair.quality == Quality::exact;
  const bool is_bound = pair.quality != Quality::estimate && (pair.shortfall > 0.0 || has_points);
  return is_bound ? pair.measured.distance + pair.shortfall : kInfinity;
}

/// Somewhat more than `least`: the next cycle mostly says no more. Where more was expected, as
/// where what pairs say jumps, that falls slowly.
double slightlyMore(double least, double share, double step, double expected) noexcept {
  constexpr double kKept = 0.95;
  const double more = least + share * std::abs(least) + step;
  return std::isfinite(expected) && expected > more ? more + kKept * (expected - more) : more;
}

LeastOfPairs slightlyMore(const LeastOfPairs& least, const LeastOfPairs& expected) noexcept {
  LeastOfPairs more;
  more.distance = slightlyMore(least.distance, 0.1, 0.002, expected.distance);
  more.warned = slightlyMore(least.warned, 0.1, 0.002, expected.warned);
  more.time = slightlyMore(least.time, 0.25, 0.005, expected.time);
  more.scale = std::min(1.0, slightlyMore(least.scale, 0.25, 0.02, expected.scale));
  return more;
}

}  // namespace

SettledPairs::SettledPairs(const CycleSetup& setup, const NearBodies& near,
                           CycleBuffers& buffers) noexcept
    : setup_(setup),
      near_(near),
      buffers_(buffers),
      memory_(buffers.memory),
      robots_(buffers.robots),
      events_(buffers.events) {
  for (const LinkPairIndex pair : events_.settled) {
    events_.is_settled[pair] = 0;
  }
  events_.settled.clear();
  buffers_.passed_over = 0;
}

double SettledPairs::reachOf(const ElementsPlace& pair) const noexcept {
  const CheckedLinkPair& links = setup_.checked[pair.link_pair];
  const Watched& of_a = robots_.watched[robots_.robot_of_link[index(links.a)]];
  const Watched& of_b = robots_.watched[robots_.robot_of_link[index(links.b)]];
  const double time = std::max(of_a.of_settled, of_b.of_settled);
  const PairReach& reach = near_.reaches.of_limits[pair.limits];
  const double speed = near_.reaches.speed[pair.reach_place];
  const StopRule& rule = setup_.ahead.stop;
  const double at_rest = memory_.speed.stopped[pair.link_pair] != 0 ? reach.stop
                         : speed <= rule.rest_speed                 ? reach.contact
                                                    : std::max(reach.contact, rule.stop_distance);
  const double told = std::max(of_a.warned, of_b.warned);
  return std::isnan(speed) ? kInfinity : std::max(told, at_rest + time * speed);
}

double SettledPairs::limitOf(const ElementsPlace& pair) const noexcept {
  if (memory_.reported[pair.link_pair] != Verdict::warning) {
    return std::max(near_.byLinks(pair), near_.heardOf(pair));
  }
  const double clear = clearBeyond(limitsOf(setup_, pair.link_pair));
  return std::max({near_.toldOf(pair), clear, reachOf(pair)});
}

void SettledPairs::recall(const ElementsPlace& pair, double travel) noexcept {
  const ElementPair& elements = setup_.element_pairs[pair.elements];
  const LastMeasurement& last = memory_.refined.lastOf(pair.elements);
  const std::vector<Pose>& poses = buffers_.body_poses.world_from_element;
  const std::vector<Ball>& balls = buffers_.refine.balls;
  const ElementDistance recalled =
      recallElements(last, {setup_.elements[index(elements.a)], poses[index(elements.a)]},
                     {setup_.elements[index(elements.b)], poses[index(elements.b)]},
                     {balls[index(elements.a)], balls[index(elements.b)]});
  if (recalled.quality != Quality::lower_bound) {
    return;
  }
  const double tolerance = buffers_.refine.limits.tolerance + kRounding;
  // At unchanged poses, all of the last measurement is recalled, as it was measured.
  const double nearest = std::min(recalled.measured.distance, recalled.outside);
  DistanceCache& cache = memory_.distance_cache;
  cache.elements[pair.elements] =
      std::max(cache.elements[pair.elements], nearest - tolerance + travel);
  if (last.found.has_points) {
    const double motion = std::min(last.found.measured.distance, last.found.outside) - nearest;
    double& of_links = cache.links[pair.link_pair];
    of_links = std::min(of_links, last.found.measured.distance + last.found.shortfall + motion +
                                      tolerance - travel);
  }
}

bool SettledPairs::isProven(const ElementsPlace& pair, double limit, double travel) const noexcept {
  const DistanceCache& cache = memory_.distance_cache;
  const bool is_warning = memory_.reported[pair.link_pair] == Verdict::warning;
  return cache.elements[pair.elements] - travel > limit &&
         (!is_warning || cache.links[pair.link_pair] + travel <=
                             limitsOf(setup_, pair.link_pair).warning_distance);
}

bool SettledPairs::isSettled(const ElementsPlace& pair) noexcept {
  if (memory_.reported[pair.link_pair] == Verdict::contact) {
    return false;
  }
  const double travel = travelOfLinks(memory_.distance_cache, pair);
  const double limit = limitOf(pair);
  if (isProven(pair, limit, travel)) {
    return true;
  }
  const bool was_measured = memory_.distance_cache.elements[pair.elements] > -kInfinity;
  if (!was_measured || !(memory_.refined.lastOf(pair.elements).found.measured.distance > limit)) {
    return false;
  }
  recall(pair, travel);
  // What is recalled holds for these poses, not for the way to them.
  const std::vector<BodyTravel>& travels = memory_.distance_cache.travels;
  const double way = travels[index(pair.a)].of_link + travels[index(pair.b)].of_link;
  return isProven(pair, std::max(limit, clearBeyond(limitsOf(setup_, pair.link_pair)) + way),
                  travel);
}

bool SettledPairs::passOver(const ElementsPlace& pair) noexcept {
  const bool is_told = near_.toldOf(pair) >= near_.reaches.of_limits[pair.limits].all;
  if (is_told || !isSettled(pair)) {
    return false;
  }
  ++buffers_.passed_over;
  const bool is_warning = memory_.reported[pair.link_pair] == Verdict::warning;
  if (is_warning && events_.is_settled[pair.link_pair] == 0) {
    events_.is_settled[pair.link_pair] = 1;
    events_.settled.push_back(pair.link_pair);
  }
  return true;
}

void keepProven(const CycleSetup& setup, CycleBuffers& buffers) noexcept {
  DistanceCache& cache = buffers.memory.distance_cache;
  const RefineWork& refined = buffers.refine;
  const double tolerance = refined.limits.tolerance + kRounding;
  for (const PairDistance& pair : buffers.distances.pairs) {
    const ElementPairIndex elements = setup.element_pair_of[index(pair.pair)];
    const double travel = travelOfLinks(cache, setup.table[pair.pair]);
    // Bodies that are not the nearest, or beyond the reach of all limits, were not measured. Into
    // an open mesh, motion may lead sooner than to its surface.
    const double nearest =
        refined.is_measured[elements] != 0
            ? std::min(pair.measured.distance, refined.tasks[refined.task_of[elements]].outside)
            : std::min(cache.nearest[elements], buffers.activation.least_near);
    const bool is_apart = pair.quality != Quality::estimate;
    cache.elements[elements] = is_apart ? nearest - tolerance + travel : -kInfinity;
    double& of_links = cache.links[setup.link_pair_of[index(pair.pair)]];
    of_links = std::min(of_links, farthestOf(pair) + tolerance - travel);
  }
}

bool isMoreThanExpected(const CycleSetup& setup, const RobotSpeeds& robots,
                        const PairEvents& events) noexcept {
  const double reported = leastActivationDistanceOf(setup);
  for (std::size_t i = 0; i < robots.least.size(); ++i) {
    const LeastOfPairs& least = robots.least[i];
    const LeastOfPairs& expected = robots.expected[i];
    const bool is_more = least.distance > std::min(expected.distance, reported) ||
                         least.time > expected.time || least.scale > expected.scale ||
                         (!events.settled.empty() && least.warned > expected.warned);
    if (!expectsNothing(expected) && is_more) {
      return true;
    }
  }
  return false;
}

void expectNothing(RobotSpeeds& robots) noexcept {
  std::fill(robots.expected.begin(), robots.expected.end(), LeastOfPairs());
}

void expectFound(const CycleSetup& setup, RobotSpeeds& robots) noexcept {
  constexpr double kMore = 1e-6;  // beyond rounding: what was found is found again
  for (std::size_t i = 0; i < robots.expected.size(); ++i) {
    const LeastOfPairs& least = robots.least[i];
    robots.expected[i] = {least.distance + kMore, least.warned + kMore, least.time + kMore,
                          std::min(1.0, least.scale + kMore)};
    if (least.distance > leastActivationDistanceOf(setup)) {
      robots.expected[i] = LeastOfPairs();
    }
  }
}

void expectNext(const CycleSetup& setup, RobotSpeeds& robots) noexcept {
  for (std::size_t i = 0; i < robots.expected.size(); ++i) {
    const bool looks_at_all =
        robots.may_be_free[i] != 0 || robots.least[i].distance > leastActivationDistanceOf(setup);
    robots.expected[i] =
        looks_at_all ? LeastOfPairs() : slightlyMore(robots.least[i], robots.expected[i]);
  }
}

}  // namespace collision_monitor
