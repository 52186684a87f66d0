// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/cycle/scale_speed.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "collision_monitor/geometry/ids.h"
#include "model/object_links.h"

namespace collision_monitor {
namespace {

/// What is seen of a link pair at its stop distance, as bits of SpeedScale::stopped. kWasStopped
/// and kMayTouch are remembered from cycle to cycle.
constexpr unsigned char kWasStopped = 1;
constexpr unsigned char kCloses = 2;
constexpr unsigned char kRests = 4;
constexpr unsigned char kMayTouch = 8;  ///< by a lower bound; remembered until it is exact

void ask(double scale, SpeedDemand& demand) noexcept {
  demand.scale = std::min(demand.scale, scale);
  demand.is_free = false;
}

void askForMeasured(const StopRule& rule, const Limits& limits, const PairDistance& distance,
                    SpeedDemand& demand, unsigned char& seen) noexcept {
  const double gap = distance.measured.distance;
  const double closing = distance.closing_speed;
  if (std::isnan(closing)) {
    ask(scaleForUnknownSpeed(gap, limits.warning_distance, rule), demand);
  } else if (closing > rule.rest_speed) {
    ask(scaleForPair(gap, closing, rule), demand);
    seen |= gap <= rule.stop_distance ? kCloses : 0;
  } else if (closing >= -rule.rest_speed) {
    // A pair that touches was stopped, or should have been.
    if (isTouching(distance, limits.contact_distance)) {
      seen |= distance.quality == Quality::lower_bound ? kMayTouch : kWasStopped;
    }
    seen |= gap <= rule.stop_distance + limits.hysteresis ? kRests : 0;
    // A near pair may rest because it was slowed down: the scale must not jump to full speed.
    demand.is_free = demand.is_free && gap > limits.warning_distance;
  }
  // A kept depth does not say whether the overlap grows, so it counts as closing.
  const bool is_kept = distance.quality == Quality::estimate && distance.shortfall > 0.0;
  seen |= is_kept ? kCloses : 0;
}

void add(const SpeedDemand& more, SpeedDemand& demand) noexcept {
  demand.scale = std::min(demand.scale, more.scale);
  demand.is_free = demand.is_free && more.is_free;
}

/// What the pairs ask for: all of them, and those of each robot.
class Demands {
 public:
  Demands(const CycleSetup& setup, RobotSpeeds& robots) noexcept : setup_(setup), robots_(robots) {
    std::fill(robots_.demands.begin(), robots_.demands.end(), SpeedDemand());
  }

  void addPair(std::size_t link_pair, const SpeedDemand& demand) noexcept {
    if (!demand.is_free) {
      add(demand, all_);
      add(demand, robots_.demands[robotOf(setup_.checked[link_pair].a)]);
      add(demand, robots_.demands[robotOf(setup_.checked[link_pair].b)]);
    }
  }

  /// Pairs between these robots are unknown. @param are_lost some were near before
  void addUnknown(std::uint32_t a, std::uint32_t b, bool are_lost) noexcept {
    ask(0.0, all_);
    for (const auto& [robot, other] : {std::pair(a, b), std::pair(b, a)}) {
      if (are_lost || countsFor(robots_, robot, other)) {
        ask(0.0, robots_.demands[robot]);
      }
    }
  }

  /// The scales that follow from the last ones. A robot that was slower is free only if all of its
  /// pairs were looked at.
  void release(double duration, double& scale_of_all) noexcept {
    const auto follow = [&](const SpeedDemand& demand, bool sees_all, double& scale) noexcept {
      const bool may_be_free = demand.is_free && scale < demand.scale;
      scale = demand.is_free && (sees_all || !may_be_free)
                  ? demand.scale
                  : releasedScale(scale, demand.scale, duration, setup_.ahead.stop);
      return may_be_free;
    };
    const bool sees_lone = !robots_.passes_lone || robots_.seeks_closing;
    const bool see_all =
        sees_lone && std::all_of(robots_.expected.begin(), robots_.expected.end(), expectsNothing);
    const bool may_all_be_free = follow(all_, see_all, scale_of_all);
    for (std::size_t i = 0; i < robots_.demands.size(); ++i) {
      const bool may_be_free = follow(
          robots_.demands[i], sees_lone && expectsNothing(robots_.expected[i]), robots_.scales[i]);
      robots_.may_be_free[i] = may_be_free || may_all_be_free ? 1 : 0;
    }
  }

 private:
  std::uint32_t robotOf(LinkId link) const noexcept { return robots_.robot_of_link[index(link)]; }

  const CycleSetup& setup_;
  RobotSpeeds& robots_;
  SpeedDemand all_;
};

/// Notes which elements close fastest.
void noteClosing(const CycleSetup& setup, const PairDistances& distances,
                 RobotSpeeds& robots) noexcept {
  double fastest = setup.ahead.stop.rest_speed;
  robots.closing = kNone;
  for (const PairDistance& distance : distances.pairs) {
    if (distance.closing_speed > fastest) {
      fastest = distance.closing_speed;
      robots.closing = setup.element_pair_of[index(distance.pair)];
    }
  }
}

/// Notes between which robots pairs are unknown. Which are changes only where all are judged, or
/// where a distance is not a number.
void noteUnknown(const CycleSetup& setup, const PairEvents& events,
                 const std::vector<Verdict>& reported, RobotSpeeds& robots) noexcept {
  if (robots.noted != events.complete_judgements) {
    robots.noted = events.complete_judgements;
    std::fill(robots.has_unknown.begin(), robots.has_unknown.end(), 0);
  }
  for (const LinkPairIndex i : events.active) {
    if (events.verdicts[i] == Verdict::unknown) {
      const CheckedLinkPair& pair = setup.checked[i];
      unsigned char& bits =
          robots.has_unknown[robots.robot_of_link[index(pair.a)] * robots.scales.size() +
                             robots.robot_of_link[index(pair.b)]];
      const bool is_lost = reported[i] == Verdict::unknown;
      bits = is_lost ? kHasUnknown | kHasLost : bits | kHasUnknown;
    }
  }
}

void addUnknown(const CycleSetup& setup, const PairEvents& events,
                const std::vector<Verdict>& reported, RobotSpeeds& robots,
                Demands& demands) noexcept {
  if (events.unknown == 0) {
    return;
  }
  noteUnknown(setup, events, reported, robots);
  for (std::uint32_t a = 0; a < robots.scales.size(); ++a) {
    for (std::uint32_t b = 0; b < robots.scales.size(); ++b) {
      const unsigned char bits = robots.has_unknown[a * robots.scales.size() + b];
      if (bits != 0) {
        demands.addUnknown(a, b, (bits & kHasLost) != 0);
      }
    }
  }
}

}  // namespace

RobotSpeeds makeRobotSpeeds(const RobotModel& model) {
  RobotSpeeds robots;
  robots.scales.resize(robotCount(model) + 1, 1.0);
  robots.is_excused.resize(robots.scales.size(), 0);
  robots.demands.resize(robots.scales.size());
  robots.least.resize(robots.scales.size());
  robots.expected.resize(robots.scales.size());
  robots.watched.resize(robots.scales.size());
  robots.may_be_free.resize(robots.scales.size(), 0);
  robots.has_unknown.resize(robots.scales.size() * robots.scales.size(), 0);
  robots.robot_of_link = findMovers(model);
  return robots;
}

void scaleSpeed(const CycleSetup& setup, std::int64_t stamp_ns, const PairDistances& distances,
                const PairEvents& events, const std::vector<Verdict>& reported, SpeedScale& speed,
                RobotSpeeds& robots) noexcept {
  const StopRule& rule = setup.ahead.stop;
  Demands demands(setup, robots);
  for (const PairDistance& distance : distances.pairs) {
    const std::uint32_t link_pair = setup.link_pair_of[index(distance.pair)];
    SpeedDemand demand;
    askForMeasured(rule, limitsOf(setup, link_pair), distance, demand, speed.stopped[link_pair]);
    demands.addPair(link_pair, demand);
  }
  addUnknown(setup, events, reported, robots, demands);
  for (const LinkPairIndex i : events.active) {
    const unsigned char seen = speed.stopped[i];
    const std::uint32_t closest = events.closest[i];
    const bool is_seen = closest != kNone && distances.pairs[closest].quality == Quality::exact;
    const unsigned char stops = seen & (is_seen ? kWasStopped : kWasStopped | kMayTouch);
    const bool rests = (seen & kRests) != 0 && stops != 0;
    const bool closes = (seen & kCloses) != 0;
    if (rests) {  // even if its kept depth counts as closing
      demands.addPair(i, {rule.creep_scale, false});
    }
    if (events.passed[i] != kNone) {
      demands.addPair(i, {0.0, false});
    }
    speed.stopped[i] = closes ? kWasStopped : rests ? stops : 0;
  }
  if (robots.seeks_closing) {
    noteClosing(setup, distances, robots);
  }
  demands.release(1e-9 * static_cast<double>(stamp_ns - speed.stamp_ns), speed.scale);
  speed.stamp_ns = stamp_ns;
  if (speed.scale >= 1.0) {
    robots.closing = kNone;
  }
}

}  // namespace collision_monitor
