// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/outputs/pair_view.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "model/number_text.h"
#include "model/object_links.h"
#include "pipeline/answers/pair_reason.h"
#include "ros_edge/outputs/sentences.h"

namespace collision_monitor {
namespace {

/// Names limits of a pair with the rules that set them.
class LimitNames {
 public:
  LimitNames(const CycleSetup& setup, LinkPairIndex link_pair)
      : limits_(limitsOf(setup, link_pair)) {
    const CheckedLinkPair& pair = setup.checked[link_pair];
    places_ = limitPlaces(setup, setup.link_pairs[findLinkPair(setup, pair.a, pair.b)]);
  }

  /// "warning_distance, 0.05 m (rules.yaml line 3, rule 2)"
  std::string operator()(double Limits::*limit) const {
    std::size_t i = 0;
    while (kLimitFields[i].value != limit) {
      ++i;
    }
    return std::string(kLimitFields[i].name) + ", " + shortText(limits_.*limit) +
           kLimitFields[i].unit + (places_[i].empty() ? "" : " (" + places_[i] + ")");
  }

 private:
  const Limits& limits_;
  std::vector<std::string> places_;
};

/// Which threshold holds a verdict up: the one of a new verdict, or with hysteresis of an old one.
std::string distanceReason(double distance, const Limits& limits, double Limits::*threshold,
                           const LimitNames& names) {
  if (distance <= limits.*threshold) {
    return "the distance is at most " + names(threshold);
  }
  if (distance <= limits.*threshold + limits.hysteresis) {
    return "it was within " + names(threshold) + ", and is not yet beyond it by " +
           names(&Limits::hysteresis);
  }
  return "";
}

std::string timeReason(double time, const Limits& limits, double Limits::*threshold,
                       const LimitNames& names) {
  if (!(limits.*threshold > 0.0) || std::isnan(time) ||
      time > limits.*threshold + limits.time_hysteresis) {
    return "";
  }
  return "the time to contact, " + secondsText(time) + ", is at most " + names(threshold) +
         (time > limits.*threshold ? ", with " + names(&Limits::time_hysteresis) : "");
}

/// Of a pair that was measured near enough.
std::string nearReason(const Watch& watch, LinkPairIndex link_pair, Verdict verdict) {
  const Limits& limits = limitsOf(watch.setup(), link_pair);
  const LimitNames names(watch.setup(), link_pair);
  const PairEvents& events = watch.buffers.events;
  const auto& pairs = watch.buffers.distances.pairs;
  const double distance = pairs[events.closest[link_pair]].measured.distance;
  const std::uint32_t soonest = events.soonest[link_pair];
  const double time = soonest == kNone ? kUnknown : pairs[soonest].time_to_contact;
  const bool is_contact = verdict == Verdict::contact;
  const std::string by_distance = distanceReason(
      distance, limits, is_contact ? &Limits::contact_distance : &Limits::warning_distance, names);
  const std::string by_time =
      timeReason(time, limits, is_contact ? &Limits::contact_time : &Limits::warning_time, names);
  return by_distance + (by_distance.empty() || by_time.empty() ? "" : "; ") + by_time;
}

std::string unknownReason(const Watch& watch, const CheckedLinkPair& pair) {
  std::vector<std::string> texts;
  for (const LinkId link : {pair.a, pair.b}) {
    const LinkStatus status = statusInWorld(watch.poses, link);
    if (status != LinkStatus::known) {
      texts.push_back("the pose of " + nameInText(watch.setup().model, link) + " is " +
                      statusText(status));
    }
  }
  return texts.empty() ? "the links have no known relative pose" : join(texts);
}

std::string clearReason(const Watch& watch, LinkPairIndex link_pair) {
  const std::uint32_t closest = watch.buffers.events.closest[link_pair];
  return closest == kNone ? "they are farther apart than every threshold"
                          : "the distance is more than " +
                                LimitNames(watch.setup(), link_pair)(&Limits::warning_distance) +
                                ", and contact is not near";
}

}  // namespace

const char* verdictName(Verdict verdict) noexcept {
  switch (verdict) {
    case Verdict::clear:
      return "OK";
    case Verdict::warning:
      return "WARNING";
    case Verdict::unknown:
      return "UNKNOWN";
    case Verdict::contact:
      return "CONTACT";
  }
  return "";
}

std::string verdictReason(const Watch& watch, LinkPairIndex link_pair) {
  const PairEvents& events = watch.buffers.events;
  const Verdict verdict = events.verdicts[link_pair];
  if (verdict == Verdict::unknown) {
    return unknownReason(watch, watch.setup().checked[link_pair]);
  }
  if (verdict == Verdict::clear) {
    return clearReason(watch, link_pair);
  }
  std::string reason;
  if (verdict == Verdict::contact && events.passed[link_pair] != kNone) {
    reason = "they touched between the last two cycles";
  } else if (verdict == Verdict::contact && events.estimated[link_pair] != kNone) {
    reason = "their geometries overlap";
  } else if (events.closest[link_pair] != kNone) {
    reason = nearReason(watch, link_pair, verdict);
  }
  const std::uint32_t speaker = speakerOf(watch.setup(), watch.buffers, link_pair);
  const std::string measured =
      speaker == kNone ? ""
                       : distanceSentence(watch.setup(), watch.buffers.distances.pairs[speaker]);
  return measured + (measured.empty() || reason.empty() ? "" : ": ") + reason;
}

PairView viewOf(const Watch& watch, const std::string& a, const std::string& b) {
  PairView view;
  const std::vector<CheckedLinkPair>& checked = watch.setup().checked;
  const RobotModel& model = watch.setup().model;
  for (LinkPairIndex i = 0; i < checked.size(); ++i) {
    const std::string& one = model.link(checked[i].a).name;
    const std::string& other = model.link(checked[i].b).name;
    if ((one == a && other == b) || (one == b && other == a)) {
      view.is_checked = true;
      view.verdict = watch.buffers.events.verdicts[i];
      view.why = verdictReason(watch, i);
      view.nearest = watch.nearest.of(i);
      view.positions = watch.nearest.positionsOf(i);
    }
  }
  return view;
}

}  // namespace collision_monitor
