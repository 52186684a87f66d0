// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "collision_monitor/pipeline/run_cycle.h"
#include "islands.h"

namespace collision_monitor {
namespace {

/// A verdict is raised at its threshold and left only `hysteresis` beyond it.
Verdict verdictFor(double distance, const Limits& limits, Verdict before) noexcept {
  const double keep_contact = before == Verdict::contact ? limits.hysteresis : 0.0;
  if (distance <= limits.contact_distance + keep_contact) {
    return Verdict::contact;
  }
  const bool was_near = before == Verdict::contact || before == Verdict::warning;
  if (distance <= limits.warning_distance + (was_near ? limits.hysteresis : 0.0)) {
    return Verdict::warning;
  }
  // Also where the distance is NaN, which would be a fault of ours: never "clear".
  return distance > limits.warning_distance ? Verdict::clear : Verdict::unknown;
}

void findClosest(const CycleSetup& setup, const PairDistances& distances,
                 PairEvents& events) noexcept {
  std::fill(events.closest.begin(), events.closest.end(), kNone);
  std::fill(events.passed.begin(), events.passed.end(), kNone);
  events.closest_of_all = kNone;
  const auto& measured = distances.measured;
  const auto is_nearer = [&](std::uint32_t one, std::uint32_t other) {
    return other == kNone || measured[one].measured.distance < measured[other].measured.distance;
  };
  for (std::uint32_t i = 0; i < measured.size(); ++i) {
    std::uint32_t& closest = events.closest[setup.link_pair_of[index(measured[i].pair)]];
    if (is_nearer(i, closest)) {
      closest = i;
    }
    if (is_nearer(i, events.closest_of_all)) {
      events.closest_of_all = i;
    }
  }
  const auto& passed = distances.passed;
  for (std::uint32_t i = 0; i < passed.size(); ++i) {
    std::uint32_t& first = events.passed[setup.link_pair_of[index(passed[i].pair)]];
    if (first == kNone || passed[i].time < passed[first].time) {
      first = i;
    }
  }
}

Verdict judgeLinkPair(const CycleSetup& setup, const BodyPoses& body_poses,
                      const PairDistances& distances, const PairMemory& memory,
                      std::size_t link_pair, std::uint32_t closest) noexcept {
  const CheckedLinkPair& pair = setup.checked[link_pair];
  if (body_poses.link_known[index(pair.a)] == 0 || body_poses.link_known[index(pair.b)] == 0) {
    return Verdict::unknown;
  }
  if (closest == kNone) {
    return Verdict::clear;  // known, and out of reach of every threshold
  }
  const PairDistance& nearest = distances.measured[closest];
  if (nearest.quality == Quality::estimate) {
    return Verdict::contact;  // also where limits allow some depth: it may be deeper than estimated
  }
  return verdictFor(nearest.measured.distance, pair.limits, memory.reported[link_pair]);
}

}  // namespace

void judgePairs(const CycleSetup& setup, const BodyPoses& body_poses,
                const PairDistances& distances, PairMemory& memory, PairEvents& events) noexcept {
  findClosest(setup, distances, events);
  events.changes.clear();
  // A link that stands in no checked pair can be unknown without harm.
  events.overall = Verdict::clear;
  for (std::size_t i = 0; i < setup.checked.size(); ++i) {
    Verdict verdict = judgeLinkPair(setup, body_poses, distances, memory, i, events.closest[i]);
    if (events.passed[i] != kNone) {
      verdict = Verdict::contact;
    }
    events.verdicts[i] = verdict;
    events.overall = std::max(events.overall, verdict);
    Verdict& reported = memory.reported[i];
    const bool is_silent = reported == Verdict::clear && verdict == Verdict::unknown;
    if (verdict != reported && !is_silent) {
      events.changes.push_back({static_cast<LinkPairIndex>(i), reported, verdict});
      reported = verdict;
    }
  }
  findIslands(setup.checked, events);
}

}  // namespace collision_monitor
