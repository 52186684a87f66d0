// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/cycle/measure_told.h"

#include <algorithm>
#include <cmath>

#include "collision_monitor/geometry/ids.h"
#include "collision_monitor/motion/speed_scale.h"
#include "geometry/constants.h"
#include "motion/closing.h"
#include "pipeline/cycle/judge_pairs.h"
#include "pipeline/look_ahead/find_closings.h"

namespace collision_monitor {
namespace {

/// What a pair says, this far apart and closing this fast.
LeastOfPairs whatIsSaid(const CycleSetup& setup, const Limits& limits, double distance,
                        double closing_speed) noexcept {
  const StopRule& rule = setup.ahead.stop;
  const double scale = std::isnan(closing_speed)
                           ? scaleForUnknownSpeed(distance, limits.warning_distance, rule)
                           : scaleForPair(distance, closing_speed, rule);
  LeastOfPairs said;
  said.distance = distance;
  said.time = timeToContact(distance - limits.contact_distance, closing_speed, setup.ahead.horizon);
  said.scale = scale;
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

/// Decides whose distance is told. The nearest points of a pair with a shortfall are not known. So
/// it is taken to close as fast as its links can approach each other.
class ToldPairs {
 public:
  ToldPairs(const CycleSetup& setup, CycleBuffers& buffers) noexcept
      : setup_(setup), buffers_(buffers), least_(buffers.robots.least) {
    std::fill(least_.begin(), least_.end(), LeastOfPairs());
  }

  /// Notes the distance, time and scale that a pair is proven not to exceed.
  void add(const PairDistance& pair) noexcept {
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
    const LinkPairIndex links = linksOf(pair);
    const Limits& limits = limitsOf(setup_, links);
    LeastOfPairs said = whatIsSaid(setup_, limits, pair.measured.distance, fastestOf(links));
    said.warned = warnedAt(links, pair.measured.distance);
    return said.distance < buffers_.refine.told_below[links] ||
           isBelow(said, leastOf(setup_.checked[links].a)) ||
           isBelow(said, leastOf(setup_.checked[links].b)) ||
           mayChange(links, said, farthest(pair)) || mayStop(links, limits, pair);
  }

 private:
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
  bool mayStop(LinkPairIndex links, const Limits& limits, const PairDistance& pair) const noexcept {
    const double stop = setup_.ahead.stop.stop_distance;
    const bool is_within = pair.measured.distance <= stop && pair.quality != Quality::estimate;
    return (is_within && !(fastestOf(links) <= setup_.ahead.stop.rest_speed)) ||
           isBetween(stop, pair.measured.distance, farthest(pair)) ||
           (buffers_.memory.speed.stopped[links] != 0 &&
            isBetween(stop + limits.hysteresis, pair.measured.distance, farthest(pair)));
  }

  const CycleSetup& setup_;
  const CycleBuffers& buffers_;
  std::vector<LeastOfPairs>& least_;
};

}  // namespace

void measureTold(const CycleSetup& setup, const LinkPoses& poses, CycleBuffers& buffers) noexcept {
  if (buffers.refine.tells_all) {
    return;
  }
  std::vector<PairDistance>& pairs = buffers.distances.pairs;
  ToldPairs told(setup, buffers);
  for (const PairDistance& pair : pairs) {
    told.add(pair);
  }
  const auto measureIfTold = [&](std::uint32_t i) {
    if (pairs[i].shortfall > 0.0 && told.isTold(pairs[i])) {
      measureFully(setup, buffers.body_poses, buffers.memory, i, buffers.refine, buffers.distances);
      findClosing(setup, poses, pairs[i]);
      told.add(pairs[i]);
    }
  };
  // The deepest comes first, so that others need not be measured.
  const auto nearest = std::min_element(pairs.begin(), pairs.end(), comesNearer);
  if (nearest != pairs.end()) {
    measureIfTold(static_cast<std::uint32_t>(nearest - pairs.begin()));
  }
  for (std::uint32_t i = 0; i < pairs.size(); ++i) {
    measureIfTold(i);
  }
}

}  // namespace collision_monitor
