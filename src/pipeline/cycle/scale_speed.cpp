// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/cycle/scale_speed.h"

#include <algorithm>
#include <cmath>

#include "collision_monitor/geometry/ids.h"
namespace collision_monitor {
namespace {

/// What is seen of a link pair at its stop distance, as bits of SpeedScale::stopped. kWasStopped
/// and kMayTouch are remembered from cycle to cycle.
constexpr unsigned char kWasStopped = 1;
constexpr unsigned char kCloses = 2;
constexpr unsigned char kRests = 4;
constexpr unsigned char kMayTouch = 8;  ///< by a lower bound; remembered until it is exact

/// What all pairs ask for.
struct Demand {
  double scale{1.0};
  bool is_free{true};  ///< nothing closes, nothing near rests, and nothing is unknown
};

void ask(double scale, Demand& demand) noexcept {
  demand.scale = std::min(demand.scale, scale);
  demand.is_free = false;
}

void askForMeasured(const StopRule& rule, const Limits& limits, const PairDistance& distance,
                    Demand& demand, unsigned char& seen) noexcept {
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
}

}  // namespace

void scaleSpeed(const CycleSetup& setup, std::int64_t stamp_ns, const PairDistances& distances,
                const PairEvents& events, SpeedScale& speed) noexcept {
  const StopRule& rule = setup.ahead.stop;
  Demand demand;
  for (const PairDistance& distance : distances.pairs) {
    const std::uint32_t link_pair = setup.link_pair_of[index(distance.pair)];
    askForMeasured(rule, limitsOf(setup, link_pair), distance, demand, speed.stopped[link_pair]);
  }
  if (events.unknown > 0) {
    ask(0.0, demand);
  }
  for (const LinkPairIndex i : events.active) {
    const unsigned char seen = speed.stopped[i];
    const std::uint32_t closest = events.closest[i];
    const bool is_seen = closest != kNone && distances.pairs[closest].quality == Quality::exact;
    const unsigned char stops = seen & (is_seen ? kWasStopped : kWasStopped | kMayTouch);
    const bool rests = (seen & kRests) != 0 && stops != 0;
    const bool closes = (seen & kCloses) != 0;
    if (rests && !closes) {
      ask(rule.creep_scale, demand);
    }
    if (events.passed[i] != kNone) {
      ask(0.0, demand);
    }
    speed.stopped[i] = closes ? kWasStopped : rests ? stops : 0;
  }
  const double duration = 1e-9 * static_cast<double>(stamp_ns - speed.stamp_ns);
  speed.scale =
      demand.is_free ? demand.scale : releasedScale(speed.scale, demand.scale, duration, rule);
  speed.stamp_ns = stamp_ns;
}

}  // namespace collision_monitor
