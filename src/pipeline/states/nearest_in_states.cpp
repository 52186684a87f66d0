// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/lanes/lane_targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/states/nearest_in_states.cpp"
#include "hwy/foreach_target.h"
// The order matters: Highway first includes this file once for each target.
#include "geometry/constants.h"
#include "pipeline/states/element_bodies-inl.h"
#include "pipeline/states/state_elements.h"

HWY_BEFORE_NAMESPACE();
namespace collision_monitor {
namespace HWY_NAMESPACE {

/// Keeps the nearest pair of bodies in each asked state, and the worst verdict.
struct NearestSearch {
  ElementBodies bodies;
  Truth is_asked;
  bool does_nearest_decide;  ///< the verdict, as with one threshold for all pairs
  JudgedLanes judged{};

  /// [m] A pair that is farther apart changes nothing.
  Number reachOf(double warning_distance) const {
    return does_nearest_decide ? judged.distance
                               : hn::Max(judged.distance, number(warning_distance));
  }

  Truth ballsMeet(const StateElementPair& elements) const {
    const Number reach = reachOf(elements.warning_distance);
    return hn::And(is_asked, bodies.ballsMeet(elements, elements.body_radii, reach));
  }

  /// Not inlined: the loop over all pairs stays short.
  HWY_NOINLINE void measureElements(const StateElementPair& elements, Truth may_be_near) {
    for (std::uint32_t i = elements.first; i < elements.last; ++i) {
      const std::uint32_t id = bodies.work.refinement.body_pairs[i];
      const StatePair& pair = bodies.work.pairs[id];
      Truth counts = may_be_near;
      const Number measured = bodies.measure(pair, reachOf(elements.warning_distance), counts);
      if (!hn::AllFalse(Lanes(), counts)) {
        judged.takeNearer(pair, id, measured, counts);
      }
    }
  }
};

void judgeNearestInLanes(const CycleSetup& setup, const StateNumber& asked, StatesWork& work,
                         StatesBlock& block) {
  const bool does_nearest_decide =
      setup.own_limits.empty() && !(setup.limits.contact_distance < 0.0);  // see contactOfBodies
  for (std::size_t lane = 0; lane < kStateCount; lane += hn::Lanes(Lanes())) {
    const Truth is_asked = hn::Gt(hn::Load(Lanes(), asked.of + lane), number(kNotAsked));
    NearestSearch search{{{setup, work, lane}, work}, is_asked, does_nearest_decide};
    for (const OrderedPair& pair : work.refinement.nearest_order) {
      const StateElementPair& elements = work.refinement.element_pairs[pair.elements];
      const Truth may_be_near = search.ballsMeet(elements);
      if (!hn::AllFalse(Lanes(), may_be_near)) {
        search.measureElements(elements, may_be_near);
      }
    }
    search.judged.store(lane, block);
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
  // Mostly one of these is the nearest again. The sooner it is measured, the fewer are.
  for (std::size_t lane = 0; lane < kStateCount; ++lane) {
    if (asked.of[lane] != kNotAsked && block.distance.of[lane] < kInfinity) {
      const auto pair = static_cast<std::size_t>(block.pair.of[lane]);
      putFirst(setup.element_pair_of[pair], work.refinement.nearest_order);
    }
  }
}

}  // namespace collision_monitor
#endif
