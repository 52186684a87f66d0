// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/cycle/measure_told.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "collision_monitor/geometry/ids.h"
#include "collision_monitor/motion/speed_scale.h"
#include "geometry/constants.h"
#include "motion/closing.h"
#include "pipeline/cycle/judge_pairs.h"
#include "pipeline/cycle/near_bodies.h"
#include "pipeline/look_ahead/find_closings.h"
#include "pipeline/refine/measure_fully.h"

namespace collision_monitor {
namespace {

/// What a pair says, this far apart and closing this fast. A speed that is not known tells no time.
LeastOfPairs whatIsSaid(const CycleSetup& setup, const Limits& limits, double distance,
                        double closing_speed) noexcept {
  const StopRule& rule = setup.ahead.stop;
  const bool is_known = !std::isnan(closing_speed);
  LeastOfPairs said;
  said.distance = distance;
  said.time = timeToContact(distance - limits.contact_distance, is_known ? closing_speed : 0.0,
                            setup.ahead.horizon);
  said.scale = is_known ? scaleForPair(distance, closing_speed, rule)
                        : scaleForUnknownSpeed(distance, limits.warning_distance, rule);
  return said;
}

void lower(const LeastOfPairs& said, LeastOfPairs& least) noexcept {
  least.distance = std::min(least.distance, said.distance);
  least.warned = std::min(least.warned, said.warned);
  least.time = std::min(least.time, said.time);  // not a number: stays
  least.scale = std::min(least.scale, said.scale);
}

bool isBelow(const LeastOfPairs& said, const LeastOfPairs& least) noexcept {
  return said.distance < least.distance || said.warned < least.warned ||
         !(said.time >= least.time) || said.scale < least.scale;
}

bool isBetween(double threshold, double least, double most) noexcept {
  return least <= threshold && threshold < most;
}

/// Decides whose distance is told. Of a pair with a shortfall, and of skipped elements, the nearest
/// points are not known: such a pair is taken to close as fast as its links can.
class ToldPairs {
 public:
  ToldPairs(const CycleSetup& setup, const LinkPoses& poses, CycleBuffers& buffers) noexcept
      : setup_(setup),
        buffers_(buffers),
        near_(nearBodies(setup, poses, buffers)),
        least_(buffers.robots.least) {
    std::fill(least_.begin(), least_.end(), LeastOfPairs());
  }

  /// Whether only a lower bound is known of elements, and not because they wait for the budget:
  /// mostly, others of their links are nearer.
  bool isSkipped(const PairDistance& pair) const noexcept {
    const ElementPairIndex elements = setup_.element_pair_of[index(pair.pair)];
    return pair.quality == Quality::lower_bound && !pair.is_refined && !(pair.shortfall > 0.0) &&
           buffers_.refine.task_of[elements] != kNone &&
           buffers_.memory.starved_cycles[elements] == 0;
  }

  /// Notes the distance, time and scale that a pair is proven not to exceed. While somebody
  /// listens, a pair that does not close need not be noted.
  void add(const PairDistance& pair) noexcept {
    if (isSkipped(pair) || (buffers_.refine.tells_all && !isMoving(pair))) {
      return;
    }
    const LinkPairIndex links = linksOf(pair);
    LeastOfPairs said;
    said.distance = farthest(pair);
    said.warned = warnedAt(links, said.distance);
    if (!(pair.shortfall > 0.0)) {
      const LeastOfPairs moving =
          whatIsSaid(setup_, limitsOf(setup_, links), said.distance, pair.closing_speed);
      said.time = moving.time;
      said.scale = moving.scale;
    }
    lower(said, leastOf(setup_.checked[links].a));
    lower(said, leastOf(setup_.checked[links].b));
  }

  bool isTold(const PairDistance& pair) const noexcept {
    return isSkipped(pair) ? maySlow(pair) : pair.shortfall > 0.0 && maySayLess(pair);
  }

 private:
  /// Of a pair with a shortfall: whether it may say less than others, or its verdict may change.
  bool maySayLess(const PairDistance& pair) const noexcept {
    const LinkPairIndex links = linksOf(pair);
    const Limits& limits = limitsOf(setup_, links);
    LeastOfPairs said = whatIsSaid(setup_, limits, pair.measured.distance, fastestOf(links));
    said.warned = warnedAt(links, pair.measured.distance);
    return said.distance < buffers_.refine.told_below[links] ||
           isBelow(said, leastOf(setup_.checked[links].a)) ||
           isBelow(said, leastOf(setup_.checked[links].b)) ||
           mayChange(links, said, farthest(pair)) || mayStop(links, limits, pair, farthest(pair));
  }

  /// Whether skipped elements may touch sooner, ask for a smaller scale or change a verdict, if
  /// they close as fast as their links can.
  bool maySlow(const PairDistance& pair) const noexcept {
    const LinkPairIndex links = linksOf(pair);
    const Limits& limits = limitsOf(setup_, links);
    LeastOfPairs said = whatIsSaid(setup_, limits, pair.measured.distance, fastestOf(pair));
    said.distance = kInfinity;
    const double nearest = buffers_.refine.nearest[links];
    const Verdict reported = buffers_.memory.reported[links];
    return isBelow(said, leastOf(setup_.checked[links].a)) ||
           isBelow(said, leastOf(setup_.checked[links].b)) ||
           verdictFor(nearest, said.time, limits, reported) !=
               verdictFor(nearest, kInfinity, limits, reported) ||
           mayStop(links, limits, pair, kInfinity);
  }

  /// Whether a pair has a time to contact or asks for a scale.
  bool isMoving(const PairDistance& pair) const noexcept {
    return !(pair.closing_speed <= setup_.ahead.stop.rest_speed) ||
           !(pair.time_to_contact == kInfinity);
  }
  static double farthest(const PairDistance& pair) noexcept {
    return pair.measured.distance + pair.shortfall;
  }
  /// [m] The distance, if the pair is a warning: the nearest warning may be named.
  double warnedAt(LinkPairIndex links, double distance) const noexcept {
    return buffers_.memory.reported[links] == Verdict::warning ? distance : kInfinity;
  }
  LinkPairIndex linksOf(const PairDistance& pair) const noexcept {
    return setup_.link_pair_of[index(pair.pair)];
  }
  LeastOfPairs& leastOf(LinkId link) const noexcept {
    return least_[buffers_.robots.robot_of_link[index(link)]];
  }

  /// [m/s] A bound of the closing speed.
  double fastestOf(LinkPairIndex links) const noexcept {
    return buffers_.activation.speed[buffers_.activation.place_of[links]];
  }

  /// [m/s] A bound of the closing speed of a skipped pair: that of its links, or of its own balls.
  double fastestOf(const PairDistance& pair) const noexcept {
    const double of_links = fastestOf(linksOf(pair));
    const double distance = pair.measured.distance;
    if (!areLone(near_.cache, setup_.table[pair.pair]) || !(distance > 0.0)) {
      return of_links;
    }
    const ElementsPlace place = near_.placeOf(pair.pair);
    return std::min(of_links, near_.closingSpeed(place, near_.closingOf(place)));
  }

  /// Whether the verdict may differ from the one reported.
  bool mayChange(LinkPairIndex links, const LeastOfPairs& said, double farthest) const noexcept {
    const Limits& limits = limitsOf(setup_, links);
    const Verdict reported = buffers_.memory.reported[links];
    return verdictFor(said.distance, said.time, limits, reported) != reported ||
           verdictFor(farthest, kInfinity, limits, reported) != reported;
  }

  /// Whether the speed scale needs the exact distance: the bounds do not tell on which side of the
  /// stop distance the pair is, or the pair is within it and moves. An overlap needs none: the
  /// scale remembers it as stopped in any case.
  bool mayStop(LinkPairIndex links, const Limits& limits, const PairDistance& pair,
               double farthest) const noexcept {
    const double stop = setup_.ahead.stop.stop_distance;
    const bool is_within = pair.measured.distance <= stop && pair.quality != Quality::estimate;
    return (is_within && !(fastestOf(links) <= setup_.ahead.stop.rest_speed)) ||
           isBetween(stop, pair.measured.distance, farthest) ||
           (buffers_.memory.speed.stopped[links] != 0 &&
            isBetween(stop + limits.hysteresis, pair.measured.distance, farthest));
  }

  const CycleSetup& setup_;
  const CycleBuffers& buffers_;
  NearBodies near_;
  std::vector<LeastOfPairs>& least_;
};

/// Measures pairs with a shortfall.
void measureShortfalls(const CycleSetup& setup, const LinkPoses& poses, CycleBuffers& buffers,
                       ToldPairs& told) noexcept {
  std::vector<PairDistance>& pairs = buffers.distances.pairs;
  const auto measureIfTold = [&](std::uint32_t i) {
    if (pairs[i].shortfall > 0.0 && told.isTold(pairs[i])) {
      measureFully(setup, buffers.body_poses, buffers.memory, i, buffers.refine, buffers.distances);
      findClosing(setup, poses, pairs[i]);
      told.add(pairs[i]);
    }
  };
  // The nearest comes first, so that others need not be measured.
  const auto nearest = std::min_element(pairs.begin(), pairs.end(), comesNearer);
  if (nearest != pairs.end()) {
    measureIfTold(static_cast<std::uint32_t>(nearest - pairs.begin()));
  }
  for (std::uint32_t i = 0; i < pairs.size(); ++i) {
    measureIfTold(i);
  }
}

/// Measures skipped elements at the entry of their nearest bodies, unless the bound that their last
/// measurement leaves proves that they do not matter. Their other entries then do not count.
void measureSkipped(const CycleSetup& setup, const LinkPoses& poses, CycleBuffers& buffers,
                    ToldPairs& told) noexcept {
  PairDistances& distances = buffers.distances;
  RefineWork& work = buffers.refine;
  bool are_placed = false;
  for (std::uint32_t i = 0; i < distances.pairs.size(); ++i) {
    if (!told.isSkipped(distances.pairs[i]) || !told.isTold(distances.pairs[i])) {
      continue;
    }
    if (!std::exchange(are_placed, true)) {
      placeTasks(setup, work, distances);
    }
    const ElementPairIndex elements = setup.element_pair_of[index(distances.pairs[i].pair)];
    if (work.is_passed[elements] != 0) {
      continue;
    }
    const std::uint32_t place = work.tasks[work.task_of[elements]].place;
    PairDistance& nearest = distances.pairs[place];
    raiseByRecall(setup, buffers.body_poses, buffers.memory, place, work, distances);
    const bool is_known =
        !told.isTold(nearest) ||
        measureFully(setup, buffers.body_poses, buffers.memory, place, work, distances);
    findClosing(setup, poses, nearest);
    if (is_known) {
      told.add(nearest);
      work.is_passed[elements] = 1;
    }
  }
  if (are_placed) {
    dropOtherBodies(setup, work, distances);
  }
}

}  // namespace

void measureTold(const CycleSetup& setup, const LinkPoses& poses, CycleBuffers& buffers) noexcept {
  const std::vector<PairDistance>& pairs = buffers.distances.pairs;
  ToldPairs told(setup, poses, buffers);
  // Nothing is noted yet, so isTold is true of every skipped pair that could ask for anything.
  const auto isTold = [&](const PairDistance& pair) { return told.isTold(pair); };
  if (buffers.refine.tells_all && std::none_of(pairs.begin(), pairs.end(), isTold)) {
    return;
  }
  for (const PairDistance& pair : pairs) {
    told.add(pair);
  }
  // While somebody listens, refinePairs has the whole budget for them.
  if (!buffers.refine.tells_all) {
    measureShortfalls(setup, poses, buffers, told);
  }
  measureSkipped(setup, poses, buffers, told);
}

}  // namespace collision_monitor
