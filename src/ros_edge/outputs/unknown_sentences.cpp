// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/outputs/sentences.h"

namespace collision_monitor {

std::string floatingSentence(const Watch& watch, const FloatingPart& part) {
  const bool has_one = part.own_pairs == 1;
  return floatingText(watch.setup().model, part, reasonSentence(watch, part.top)) + "; its " +
         std::to_string(part.own_pairs) + (has_one ? " own pair is" : " own pairs are") +
         " checked, " + std::to_string(part.other_pairs) +
         (part.other_pairs == 1 ? " pair with others is" : " pairs with others are") + " unknown";
}

std::string reasonSentence(const Watch& watch, LinkId link) {
  return watch.clock.fault == ClockFault::none ? watch.reader.explain(link)
                                               : clockSentence(watch.clock);
}

std::string unknownSentence(const Watch& watch, LinkId link) {
  return unknownText(watch.setup().model, link, reasonSentence(watch, link));
}

std::string clockSentence(const ClockState& clock) {
  if (clock.fault == ClockFault::not_started) {
    return "no time on /clock yet";
  }
  const std::string stands =
      "the clock has stood still for " + fixedText(clock.stood_for, 1) + " s";
  return clock.fault == ClockFault::silent
             ? stands + ": nothing comes on /clock (use_sim_time is set), and no pose grows old"
             : stands + ", but transforms or joint states of later times come";
}

std::string blindReason(const Watch& watch, const CycleFacts& facts) {
  if (facts.now.isZero()) {
    return clockSentence({ClockFault::not_started, 0.0});
  }
  if (watch.clock.fault != ClockFault::none) {
    return clockSentence(watch.clock);
  }
  return watch.setup().checked.empty() ? "no pair of links is checked, so nothing can be said" : "";
}

const char* statusText(LinkStatus status) noexcept {
  switch (status) {
    case LinkStatus::known:
      return "known";
    case LinkStatus::stale:
      return "stale";
    case LinkStatus::missing:
      return "missing";
    case LinkStatus::not_finite:
      return "not finite";
    case LinkStatus::contradicted:
      return "contradicted";
  }
  return "unknown";
}

}  // namespace collision_monitor
