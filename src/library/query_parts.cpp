// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "library/query_parts.h"

#include <algorithm>
#include <cmath>

#include "model/place.h"
#include "pipeline/blocks/contact_of_pairs.h"

namespace collision_monitor {
namespace {

/// All links known: poses that are not finite count as unknown by themselves.
LinkPoses knownPoses(const CycleSetup& setup) {
  LinkPoses poses = makeLinkPoses(setup.model);
  std::fill(poses.status.begin(), poses.status.end(), LinkStatus::known);
  return poses;
}

}  // namespace

QueryParts::QueryParts(const RobotMonitor& its_monitor)
    : monitor(its_monitor),
      shared(*monitor.parts_),
      setup(shared.setup),
      state(shared.default_state),
      poses(knownPoses(setup)),
      links(makeLinkDistances(setup)),
      nearest_of(setup.element_pairs.size(), kNone),
      verdicts(setup.checked.size(), Verdict::clear),
      none_passed(setup.element_pairs.size(), 0),
      rows(setup, poses) {
  links.refine.limits.tolerance = setup.refine.tolerance;
  near_bodies.reserve(setup.table.size());
  table.pairs.reserve(setup.checked.size());
  contacts.reserve(setup.checked.size());
}

void checkStateSize(const RobotMonitor& monitor, Numbers state) {
  const std::size_t wanted = monitor.model().variable_count;
  if (state.size() != wanted) {
    throw ArgumentError({"the state has " + counted(state.size(), "number") +
                         "; this monitor has " + counted(wanted, "variable")});
  }
}

void readPositions(Numbers numbers, JointPositions& positions) {
  positions.resize(numbers.size());
  std::transform(numbers.begin(), numbers.end(), positions.begin(),
                 [](double number) { return std::abs(number) <= kFarthest ? number : kUnknown; });
}

MeasuredPair measuredPair(const CycleSetup& setup, const PairDistance& distance, Verdict verdict) {
  const BodyPair& bodies = setup.table[distance.pair];
  MeasuredPair answer;
  answer.pair = setup.link_pair_of[index(distance.pair)];
  answer.shape_a = static_cast<std::uint32_t>(index(bodies.a));
  answer.shape_b = static_cast<std::uint32_t>(index(bodies.b));
  answer.quality = distance.quality;
  answer.verdict = verdict;
  answer.is_refined = distance.is_refined;
  answer.measured = distance.measured;
  return answer;
}

MeasuredPair unknownPair(std::uint32_t pair) {
  MeasuredPair answer;
  answer.pair = pair;
  answer.shape_a = answer.shape_b = kNone;
  SignedDistance& measured = answer.measured;
  measured.distance = kUnknown;
  measured.point_on_a.setConstant(kUnknown);
  measured.point_on_b.setConstant(kUnknown);
  measured.normal_a_to_b.setConstant(kUnknown);
  return answer;
}

Verdict verdictOf(const CycleSetup& setup, const PairDistance& distance) noexcept {
  const Limits& limits = limitsOf(setup, setup.link_pair_of[index(distance.pair)]);
  const double contact =
      distance.is_refined ? limits.contact_distance : contactOfBodies(setup, distance.pair);
  return isTouching(distance, contact)                           ? Verdict::contact
         : distance.measured.distance <= limits.warning_distance ? Verdict::warning
                                                                 : Verdict::clear;
}

}  // namespace collision_monitor
