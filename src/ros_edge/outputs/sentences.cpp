// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/outputs/sentences.h"

#include <array>
#include <charconv>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <string_view>

#include "model/object_links.h"
#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/data/activation_distance.h"
#include "ros_edge/outputs/conversions.h"
#include "ros_edge/outputs/pair_counts.h"
#include "ros_edge/robots/missing.h"

namespace collision_monitor {
namespace {

/// [m] Smaller values print as 0.
constexpr double kTouching = 0.5e-4;

/// [m/s] Smaller speeds print as 0.
constexpr double kResting = 0.005;

std::string nameOf(const CycleSetup& setup, BodyId body) {
  return nameInText(setup.model, setup.bodies[index(body)].link);
}

/// Joins texts with one allocation, because this runs in every cycle.
std::string concatenate(std::initializer_list<std::string_view> parts) {
  std::size_t size = 0;
  for (const std::string_view part : parts) {
    size += part.size();
  }
  std::string text;
  text.reserve(size);
  for (const std::string_view part : parts) {
    text += part;
  }
  return text;
}

std::string placeText(const CycleSetup& setup, const PairDistance& distance) {
  const BodyPair& pair = setup.table[distance.pair];
  const std::string a = nameOf(setup, pair.a);
  const std::string b = nameOf(setup, pair.b);
  const double value = distance.measured.distance;
  const bool is_bound = distance.quality == Quality::lower_bound;
  const char* of_shapes = is_bound ? " (enclosing shapes)" : "";
  const bool is_estimate = distance.quality == Quality::estimate;
  if (std::abs(value) < kTouching && is_estimate) {
    return concatenate({a, " overlaps ", b});
  }
  if (value > 0.0 && value < kTouching) {
    return concatenate({a, " is less than 0.1 mm from ", b, of_shapes});
  }
  if (std::abs(value) < kTouching) {
    return concatenate({a, " touches ", b, of_shapes});
  }
  if (value < 0.0) {
    const char* by = is_estimate ? " by at least " : " by ";
    return concatenate({a, " overlaps ", b, by, lengthText(value), of_shapes});
  }
  const char* is = is_bound ? " is at least " : " is ";
  return concatenate({a, is, lengthText(value), " from ", b});
}

/// ", closing at 0.20 m/s, contact in 0.06 s"; empty if the pair rests or its motion is unknown.
std::string motionText(const PairDistance& distance) {
  const double closing = distance.closing_speed;
  if (!(std::abs(closing) >= kResting)) {
    return "";
  }
  const std::string speed = fixedText(std::abs(closing), 2);
  if (closing < 0.0) {
    return concatenate({", moving apart at ", speed, " m/s"});
  }
  if (distance.measured.distance <= 0.0) {
    return concatenate({", going deeper at ", speed, " m/s"});
  }
  const double time = distance.time_to_contact;
  if (!(std::isfinite(time) && time > 0.0)) {
    return concatenate({", closing at ", speed, " m/s"});
  }
  const bool is_bound = distance.quality == Quality::lower_bound;
  return concatenate({", closing at ", speed, " m/s, contact in ", fixedText(time, 2),
                      is_bound ? " s at the earliest" : " s"});
}

std::string passedSentence(const Watch& watch, const PassedContact& passed) {
  const CycleSetup& setup = watch.setup();
  const BodyPair& pair = setup.table[passed.distance.pair];
  const bool is_bound = passed.distance.quality == Quality::lower_bound;
  return nameOf(setup, pair.a) + " touched " + nameOf(setup, pair.b) +
         (is_bound ? " (enclosing shapes)" : "") + " between two cycles, " +
         fixedText(1e3 * passed.time * watch.buffers.sweep.elapsed, 1) +
         " ms after the poses of the last one";
}

std::string pairsWith(Verdict verdict, const Watch& watch) {
  Speaker speaker;
  for (const LinkPairIndex i : watch.buffers.events.active) {
    if (watch.buffers.events.verdicts[i] == verdict) {
      speaker.add(watch, i);
    }
  }
  return pairsSentence(watch, speaker);
}

std::string unknownLinksSentence(const Watch& watch) {
  const std::vector<FloatingPart>& parts = watch.unknown().parts();
  const std::vector<LinkId>& links = watch.unknown().loneLinks();
  if (parts.empty() && links.empty()) {
    return "the pose of a link is not rigid";
  }
  std::vector<std::string> texts;
  if (!parts.empty()) {
    texts.push_back(floatingSentence(watch, parts.front()) + andMore(parts.size(), "part"));
  }
  if (!links.empty()) {
    texts.push_back(unknownSentence(watch, links.front()) + andMore(links.size(), "link"));
  }
  return join(texts);
}

/// Of the closest pair; empty if nothing was measured.
std::string closestSentence(const Watch& watch) {
  const std::uint32_t closest = watch.buffers.events.closest_of_all;
  return closest == kNone ? ""
                          : distanceSentence(watch.setup(), watch.buffers.distances.pairs[closest]);
}

std::string verdictSentence(const Watch& watch, const CycleFacts& facts) {
  std::string blind = blindReason(watch, facts);
  if (!blind.empty()) {
    return blind;
  }
  switch (watch.buffers.events.overall) {
    case Verdict::contact:
    case Verdict::warning:
      return pairsWith(watch.buffers.events.overall, watch);
    case Verdict::unknown:
      return unknownLinksSentence(watch);
    case Verdict::clear:
      break;
  }
  return clearText(closestSentence(watch));
}

}  // namespace

std::string clearText(const std::string& closest) {
  return closest.empty() ? "clear" : "clear; " + closest;
}

std::string andMore(std::size_t count, const char* what) {
  return count < 2 ? ""
                   : concatenate({" (and ", std::to_string(count - 1), " more ", what,
                                  count == 2 ? ")" : "s)"});
}

std::string pairSentence(const Watch& watch, LinkPairIndex link_pair) {
  const PassedContact* passed = passedOf(watch, link_pair);
  return passed != nullptr
             ? passedSentence(watch, *passed)
             : distanceSentence(watch.setup(),
                                watch.buffers.distances
                                    .pairs[speakerOf(watch.setup(), watch.buffers, link_pair)]);
}

void Speaker::add(const Watch& watch, LinkPairIndex link_pair) {
  ++count;
  const std::uint32_t place = speakerOf(watch.setup(), watch.buffers, link_pair);
  if (place == kNone) {
    return;
  }
  const double of_pair = watch.buffers.distances.pairs[place].measured.distance;
  if (pair == kNone || of_pair < distance) {
    pair = link_pair;
    distance = of_pair;
  }
}

std::string pairsSentence(const Watch& watch, const Speaker& speaker) {
  return speaker.pair == kNone
             ? std::to_string(speaker.count) + " pairs of links are near each other"
             : pairSentence(watch, speaker.pair) + andMore(speaker.count, "pair");
}

std::string fixedText(double value, int decimals) {
  // The largest number has 309 digits before the point.
  std::array<char, 400> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                 std::chars_format::fixed, decimals);
  return {text.data(), end.ptr};
}

std::string lengthText(double length) {
  const double size = std::abs(length);
  if (size < 0.00995) {
    return fixedText(1000.0 * size, 1) + " mm";
  }
  return size < 0.9995 ? fixedText(1000.0 * size, 0) + " mm" : fixedText(size, 2) + " m";
}

std::string secondsText(double time) { return fixedText(time, 3) + " s"; }

std::string join(const std::vector<std::string>& texts) {
  std::string joined;
  for (const std::string& text : texts) {
    joined += (joined.empty() ? "" : "; ") + text;
  }
  return joined;
}

std::string distanceSentence(const CycleSetup& setup, const PairDistance& distance) {
  return placeText(setup, distance) + motionText(distance);
}

std::uint32_t speakerOf(const CycleSetup& setup, const CycleBuffers& buffers,
                        LinkPairIndex link_pair) {
  const Limits& limits = limitsOf(setup, link_pair);
  const std::uint32_t closest = buffers.events.closest[link_pair];
  const std::uint32_t soonest = buffers.events.soonest[link_pair];
  const bool is_near = closest != kNone && buffers.distances.pairs[closest].measured.distance <=
                                               limits.warning_distance + limits.hysteresis;
  return is_near || soonest == kNone ? closest : soonest;
}

std::string changeSentence(const Watch& watch, const VerdictChange& change) {
  const CycleSetup& setup = watch.setup();
  const CheckedLinkPair& pair = setup.checked[change.link_pair];
  if (change.after == Verdict::unknown) {
    const LinkId unknown = watch.unknown().unknownOf(pair);
    const LinkId other = unknown == pair.a ? pair.b : pair.a;
    return unknownSentence(watch, unknown) + ", near " + nameInText(setup.model, other) + " before";
  }
  const std::uint32_t speaker = speakerOf(setup, watch.buffers, change.link_pair);
  if (speaker == kNone) {
    return nameInText(setup.model, pair.a) + " is clear of " + nameInText(setup.model, pair.b) +
           " by more than " + lengthText(activationDistanceOf(limitsOf(setup, pair)));
  }
  const std::string measured = pairSentence(watch, change.link_pair);
  return change.after == Verdict::clear ? measured + ", clear again" : measured;
}

std::string stateSentence(const Watch& watch, const CycleFacts& facts) {
  const std::string missing = missingSentence(*watch.fixed);
  const bool is_contact = levelOf(watch, facts) == State::CONTACT;
  const bool is_clear =
      blindReason(watch, facts).empty() && watch.buffers.events.overall == Verdict::clear;
  const std::string verdict =
      is_clear && !missing.empty() ? closestSentence(watch) : verdictSentence(watch, facts);
  const std::string judged = missing.empty() ? verdict
                             : is_contact    ? verdict + "; " + missing
                                             : missing + (verdict.empty() ? "" : "; ") + verdict;
  return offText(facts) + judged + muteText(watch.pairs_muted, facts.muted_for);
}

std::string offText(const CycleFacts& facts) {
  return facts.is_enabled
             ? ""
             : "switched off for another " + fixedText(facts.enabled_again_in, 0) + " s; ";
}

}  // namespace collision_monitor
