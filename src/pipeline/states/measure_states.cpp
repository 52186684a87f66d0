// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/lanes/lane_targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/states/measure_states.cpp"
#include "hwy/foreach_target.h"
// The order matters: Highway first includes this file once for each target.
#include "pipeline/states/state_bodies-inl.h"

HWY_BEFORE_NAMESPACE();
namespace collision_monitor {
namespace HWY_NAMESPACE {

/// Keeps the least distance of each link pair in the query.
struct LinkPairSearch {
  StateLanes states;
  std::vector<StateNumber>& nearest;

  template <class CoreA, class CoreB>
  void visit(const PairRange& range) {
    for (std::size_t id = range.first; id < range.last; ++id) {
      double* const of_links = nearest[states.setup.link_pair_of[id]].of + states.lane;
      if (of_links[0] == kNotAsked) {
        continue;
      }
      const Number least = hn::Load(Lanes(), of_links);
      Truth counts = hn::Eq(zero(), zero());
      const Number distance =
          stateDistanceWithin<CoreA, CoreB>(states, states.work.pairs[id], least, counts);
      // NaN is kept.
      const Truth is_taken = hn::Or(hn::Lt(distance, least), hn::Not(hn::Eq(distance, distance)));
      hn::Store(hn::IfThenElse(hn::And(counts, is_taken), distance, least), Lanes(), of_links);
    }
  }
};

void measureInLanes(const CycleSetup& setup, const StatesWork& work,
                    std::vector<StateNumber>& nearest) {
  for (std::size_t lane = 0; lane < kStateCount; lane += hn::Lanes(Lanes())) {
    LinkPairSearch search{{setup, work, lane}, nearest};
    for (const PairRange& range : setup.ranges) {
      visitKinds(range, search);
    }
  }
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace collision_monitor
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace collision_monitor {
namespace {
HWY_EXPORT(measureInLanes);
}  // namespace

void measureLinkPairs(const CycleSetup& setup, const StatesWork& work,
                      std::vector<StateNumber>& nearest) noexcept {
  HWY_DYNAMIC_DISPATCH(measureInLanes)(setup, work, nearest);
}

}  // namespace collision_monitor
#endif
