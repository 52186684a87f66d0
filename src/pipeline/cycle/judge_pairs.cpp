// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/cycle/judge_pairs.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "collision_monitor/geometry/ids.h"
#include "geometry/constants.h"
#include "pipeline/answers/islands.h"

namespace collision_monitor {
namespace {

/// False if the time is unknown or the threshold is off.
bool isSoon(double time, double threshold, double hysteresis) noexcept {
  return threshold > 0.0 && time <= threshold + hysteresis;
}

/// Sorts pairs, which are marked. Of many pairs the marks are read in order: that is faster.
void sortMarked(std::vector<unsigned char>& marks, std::vector<LinkPairIndex>& pairs) noexcept {
  constexpr std::size_t kSparse = 64;
  if (pairs.size() < marks.size() / kSparse) {
    std::sort(pairs.begin(), pairs.end());
  } else {
    LinkPairIndex next = 0;
    for (std::size_t sorted = 0; sorted < pairs.size(); ++next) {
      pairs[sorted] = next;
      sorted += marks[next];
    }
  }
  for (const LinkPairIndex pair : pairs) {
    marks[pair] = 0;
  }
}

/// Fills the pairs to look at, and forgets what the last cycle told of pairs.
void listActive(const CycleSetup& setup, const PairDistances& distances, const PairMemory& memory,
                PairEvents& events) noexcept {
  forgetTold(events);
  std::vector<LinkPairIndex>& active = events.active;
  if (memory.judges_all) {
    active.resize(setup.checked.size());
    std::iota(active.begin(), active.end(), 0U);
    ++events.complete_judgements;
    return;
  }
  const auto add = [&](LinkPairIndex pair) {
    if (events.is_active[pair] == 0) {
      events.is_active[pair] = 1;
      active.push_back(pair);
    }
  };
  std::for_each(memory.lively.begin(), memory.lively.end(), add);
  for (const PairDistance& distance : distances.pairs) {
    add(setup.link_pair_of[index(distance.pair)]);
  }
  for (const PassedContact& passed : distances.passed) {
    add(setup.link_pair_of[index(passed.distance.pair)]);
  }
  sortMarked(events.is_active, active);
}

/// Fills, for each link pair, the closest pair, the pair that touches first and the deepest
/// estimate; for all link pairs the closest and the least time. Ignores unknown times.
/// @return whether any time is unknown.
bool findClosestAndSoonest(const CycleSetup& setup, const PairDistances& distances,
                           PairEvents& events) noexcept {
  events.closest_of_all = kNone;
  events.time_to_contact = kInfinity;
  bool has_unknown = false;
  const auto& measured = distances.pairs;
  const auto is_nearer = [&](std::uint32_t one, std::uint32_t other) {
    return other == kNone || measured[one].measured.distance < measured[other].measured.distance;
  };
  for (std::uint32_t i = 0; i < measured.size(); ++i) {
    const std::uint32_t link_pair = setup.link_pair_of[index(measured[i].pair)];
    if (is_nearer(i, events.closest[link_pair])) {
      events.closest[link_pair] = i;
    }
    if (is_nearer(i, events.closest_of_all)) {
      events.closest_of_all = i;
    }
    if (measured[i].quality == Quality::estimate && is_nearer(i, events.estimated[link_pair])) {
      events.estimated[link_pair] = i;
    }
    const double time = measured[i].time_to_contact;
    std::uint32_t& soonest = events.soonest[link_pair];
    if (time < (soonest == kNone ? kInfinity : measured[soonest].time_to_contact)) {
      soonest = i;
      events.time_to_contact = std::min(events.time_to_contact, time);
    }
    has_unknown = has_unknown || std::isnan(time);
  }
  return has_unknown;
}

/// Searches again if an estimate has replaced the closest pair.
void findClosestOfAll(const CycleSetup& setup, const PairDistances& distances,
                      PairEvents& events) noexcept {
  std::uint32_t& nearest = events.closest_of_all;
  const auto& measured = distances.pairs;
  if (nearest == kNone ||
      events.closest[setup.link_pair_of[index(measured[nearest].pair)]] == nearest) {
    return;
  }
  nearest = kNone;
  for (const LinkPairIndex pair : events.active) {
    const std::uint32_t closest = events.closest[pair];
    if (closest != kNone && (nearest == kNone || measured[closest].measured.distance <
                                                     measured[nearest].measured.distance)) {
      nearest = closest;
    }
  }
}

void findPassed(const CycleSetup& setup, const PairDistances& distances,
                PairEvents& events) noexcept {
  const auto& passed = distances.passed;
  for (std::uint32_t i = 0; i < passed.size(); ++i) {
    std::uint32_t& first = events.passed[setup.link_pair_of[index(passed[i].distance.pair)]];
    if (first == kNone || passed[i].time < passed[first].time) {
      first = i;
    }
  }
}

/// Whether all links of checked pairs have a known velocity. If not, a time to contact is unknown
/// at any distance.
bool areMotionsKnown(const CycleSetup& setup, const BodyPoses& body_poses,
                     const LinkVelocities& velocities, const PairEvents& events) noexcept {
  bool are_known = true;
  forIndices(body_poses.moved.links, [&](std::size_t link) noexcept {
    are_known &= velocities.known[link] != 0 || events.is_checked[link] == 0;
  });
  for (const CarriedObjects& objects : setup.carried) {
    are_known &= velocities.known[objects.first_link] != 0 || !objects.is_checked;
  }
  return are_known;
}

/// The finest detail that shows a contact of the link pair. A pair that is apart now shows nothing
/// of a passed contact.
Detail contactDetailOf(const CycleSetup& setup, const PairDistances& distances,
                       const PairEvents& events, std::size_t link_pair) noexcept {
  const std::uint32_t passed = events.passed[link_pair];
  const std::uint32_t closest = events.closest[link_pair];
  Detail detail = events.estimated[link_pair] != kNone ? Detail::geometries : Detail::shapes;
  if (passed != kNone) {
    detail = std::max(detail, detailOf(distances.passed[passed].distance));
  }
  if (closest == kNone) {
    return detail;
  }
  const PairDistance& nearest = distances.pairs[closest];
  const bool is_shown =
      passed == kNone || nearest.measured.distance <= limitsOf(setup, link_pair).contact_distance;
  return is_shown ? std::max(detail, detailOf(nearest)) : detail;
}

/// The verdict that hysteresis starts from. A contact shown only by bounds, as when the budget
/// starves a pair, ends as soon as a finer distance shows the pair apart, however near it is.
Verdict heldVerdict(const PairMemory& memory, std::size_t link_pair,
                    const PairDistance& nearest) noexcept {
  const Verdict before = memory.reported[link_pair];
  const bool is_refuted = detailOf(nearest) > memory.contact_detail[link_pair];
  return before == Verdict::contact && is_refuted ? Verdict::warning : before;
}

/// @pre both links are known beside each other
Verdict judgeLinkPair(const CycleSetup& setup, const PairDistances& distances,
                      const PairEvents& events, std::size_t link_pair,
                      const PairMemory& memory) noexcept {
  const std::uint32_t closest = events.closest[link_pair];
  // An estimate is a contact even if the closest pair is deeper and within the limits.
  if (events.passed[link_pair] != kNone || events.estimated[link_pair] != kNone) {
    return Verdict::contact;
  }
  const Verdict least = events.is_settled[link_pair] != 0 ? Verdict::warning : Verdict::clear;
  if (closest == kNone) {
    return least;
  }
  const PairDistance& nearest = distances.pairs[closest];
  const std::uint32_t soonest = events.soonest[link_pair];
  const double time = soonest == kNone ? kInfinity : distances.pairs[soonest].time_to_contact;
  return std::max(least, verdictFor(nearest.measured.distance, time, limitsOf(setup, link_pair),
                                    heldVerdict(memory, link_pair, nearest)));
}

/// Whether nothing was measured of a warning that stays one.
bool isPassedOver(const PairEvents& events, LinkPairIndex pair) noexcept {
  return events.is_settled[pair] != 0 && events.closest[pair] == kNone &&
         events.passed[pair] == kNone && events.verdicts[pair] == Verdict::warning;
}

/// Stores a verdict, and lists it if it differs from the one that listeners have.
void report(LinkPairIndex pair, Verdict verdict, PairMemory& memory, PairEvents& events) noexcept {
  Verdict& reported = memory.reported[pair];
  events.verdicts[pair] = verdict;
  const bool is_silent = reported == Verdict::clear && verdict == Verdict::unknown;
  if (verdict != reported && !is_silent) {
    events.changes.push_back({pair, reported, verdict});
    reported = verdict;
  }
}

}  // namespace

Verdict verdictFor(double distance, double time, const Limits& limits, Verdict before) noexcept {
  const bool was_touching = before == Verdict::contact;
  if (distance <= limits.contact_distance + (was_touching ? limits.hysteresis : 0.0) ||
      isSoon(time, limits.contact_time, was_touching ? limits.time_hysteresis : 0.0)) {
    return Verdict::contact;
  }
  const bool was_near = was_touching || before == Verdict::warning;
  if (distance <= limits.warning_distance + (was_near ? limits.hysteresis : 0.0) ||
      isSoon(time, limits.warning_time, was_near ? limits.time_hysteresis : 0.0)) {
    return Verdict::warning;
  }
  // A NaN distance would be our bug; it must not read as clear.
  return distance > limits.warning_distance ? Verdict::clear : Verdict::unknown;
}

void preferEstimate(std::uint32_t estimated, std::vector<PairDistance>& pairs,
                    std::uint32_t& closest) noexcept {
  if (estimated != kNone) {
    closest = pairs[closest].quality == Quality::lower_bound ? estimated : closest;
    pairs[closest].quality = Quality::estimate;
  }
}

void forgetTold(PairEvents& events) noexcept {
  for (const LinkPairIndex pair : events.active) {
    events.closest[pair] = events.soonest[pair] = kNone;
    events.estimated[pair] = events.passed[pair] = kNone;
  }
  events.active.clear();
}

void judgePairs(const CycleSetup& setup, const BodyPoses& body_poses,
                const LinkVelocities& velocities, PairDistances& distances, PairMemory& memory,
                PairEvents& events) noexcept {
  listActive(setup, distances, memory, events);
  bool has_unknown = findClosestAndSoonest(setup, distances, events);
  findPassed(setup, distances, events);
  events.changes.clear();
  events.unjoined = memory.judges_all ? 0 : events.unjoined;
  events.unknown = 0;
  // An unknown link in no checked pair does not matter.
  events.overall = Verdict::clear;
  for (const LinkPairIndex i : events.active) {
    if (isPassedOver(events, i)) {
      events.overall = std::max(events.overall, Verdict::warning);
      continue;
    }
    preferEstimate(events.estimated[i], distances.pairs, events.closest[i]);
    const CheckedLinkPair& pair = setup.checked[i];
    const bool is_joined = isJoined(body_poses, pair.a, pair.b);
    events.unjoined += memory.judges_all && !is_joined ? 1 : 0;
    const Verdict verdict =
        is_joined ? judgeLinkPair(setup, distances, events, i, memory) : Verdict::unknown;
    events.unknown += is_joined && verdict == Verdict::unknown ? 1 : 0;
    const Detail detail = contactDetailOf(setup, distances, events, i);
    memory.contact_detail[i] =
        verdict == Verdict::contact ? std::max(memory.contact_detail[i], detail) : Detail::shapes;
    events.overall = std::max(events.overall, verdict);
    report(i, verdict, memory, events);
  }
  events.unknown += events.unjoined;
  if (events.unknown > 0) {
    events.overall = std::max(events.overall, Verdict::unknown);
  }
  findClosestOfAll(setup, distances, events);
  has_unknown =
      has_unknown || events.unknown > 0 || !areMotionsKnown(setup, body_poses, velocities, events);
  if (has_unknown && events.time_to_contact == kInfinity) {
    events.time_to_contact = kUnknown;
  }
  findIslands(setup.checked, events);
}

void keepLively(const CycleSetup& setup, const PairEvents& events, PairMemory& memory) noexcept {
  constexpr std::size_t kFewPairs = 64;
  // A distance that is not a number makes a pair unknown for this cycle only.
  memory.judges_all = setup.checked.size() <= kFewPairs || events.unknown > events.unjoined;
  memory.lively.clear();
  if (memory.judges_all) {
    return;
  }
  for (const LinkPairIndex pair : events.active) {
    if (isLively(memory, pair)) {
      memory.lively.push_back(pair);
    }
  }
}

}  // namespace collision_monitor
