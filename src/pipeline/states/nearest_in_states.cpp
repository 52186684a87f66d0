// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/lanes/lane_targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/states/nearest_in_states.cpp"
#include "hwy/foreach_target.h"
// The order matters: Highway first includes this file once for each target.
#include "pipeline/states/element_bodies-inl.h"

HWY_BEFORE_NAMESPACE();
namespace collision_monitor {
namespace HWY_NAMESPACE {

/// Keeps the nearest pair of bodies in each asked state, and the worst verdict.
struct NearestSearch {
  ElementBodies bodies;
  Truth is_asked;
  Number distance, pair;
  Truth is_contact, is_warning, is_unknown;

  /// [m] A pair that is farther apart changes nothing.
  Number reachOf(double warning_distance) const {
    return hn::Max(distance, number(warning_distance));
  }

  /// Of equal distances the first pair of the table wins.
  void take(std::uint32_t id, Number measured, Truth counts) {
    const Number its_id = number(static_cast<double>(id));
    const Truth is_first = hn::And(hn::Eq(measured, distance), hn::Lt(its_id, pair));
    const Truth is_taken = hn::And(counts, hn::Or(hn::Lt(measured, distance), is_first));
    distance = hn::IfThenElse(is_taken, measured, distance);
    pair = hn::IfThenElse(is_taken, its_id, pair);
    const StatePair& limits = bodies.work.pairs[id];
    const auto isWithin = [&](double limit)
                              HWY_ATTR { return hn::And(counts, hn::Le(measured, number(limit))); };
    is_contact = hn::Or(is_contact, isWithin(limits.contact_distance));
    is_warning = hn::Or(is_warning, isWithin(limits.warning_distance));
    is_unknown = hn::Or(is_unknown, hn::AndNot(hn::Eq(measured, measured), counts));
  }

  /// Not inlined: the loop over all pairs stays short.
  HWY_NOINLINE void measureElements(const StateElementPair& elements, Truth may_be_near) {
    for (std::uint32_t i = elements.first; i < elements.last; ++i) {
      const std::uint32_t id = bodies.work.refinement.body_pairs[i];
      Truth counts = may_be_near;
      const Number measured =
          bodies.measure(bodies.work.pairs[id], reachOf(elements.warning_distance), counts);
      if (!hn::AllFalse(Lanes(), counts)) {
        take(id, measured, counts);
      }
    }
  }
};

void judgeNearestInLanes(const CycleSetup& setup, const StateNumber& asked, StatesWork& work,
                         StatesBlock& block) {
  for (std::size_t lane = 0; lane < kStateCount; lane += hn::Lanes(Lanes())) {
    const Truth none = hn::Ne(zero(), zero());
    const Number far = number(std::numeric_limits<double>::infinity());
    const Truth is_asked = hn::Gt(hn::Load(Lanes(), asked.of + lane), number(kNotAsked));
    NearestSearch search{{{setup, work, lane}, work}, is_asked, far, zero(), none, none, none};
    for (const ElementPairIndex i : work.refinement.order) {
      const StateElementPair& elements = work.refinement.element_pairs[i];
      const Number reach = search.reachOf(elements.warning_distance);
      const Truth may_be_near =
          hn::And(is_asked, search.bodies.ballsMeet(elements, elements.body_radii, reach));
      if (!hn::AllFalse(Lanes(), may_be_near)) {
        search.measureElements(elements, may_be_near);
      }
    }
    hn::Store(search.distance, Lanes(), block.distance.of + lane);
    hn::Store(search.pair, Lanes(), block.pair.of + lane);
    storeTruth(search.is_contact, lane, block.is_contact);
    storeTruth(search.is_warning, lane, block.is_warning);
    storeTruth(search.is_unknown, lane, block.is_unknown);
  }
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace collision_monitor
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace collision_monitor {
namespace {
HWY_EXPORT(judgeNearestInLanes);
}  // namespace

void judgeNearest(const CycleSetup& setup, const StateNumber& asked, StatesWork& work,
                  StatesBlock& block) noexcept {
  HWY_DYNAMIC_DISPATCH(judgeNearestInLanes)(setup, asked, work, block);
}

}  // namespace collision_monitor
#endif
