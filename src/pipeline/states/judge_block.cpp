// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/lanes/lane_targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/states/judge_block.cpp"
#include "hwy/foreach_target.h"
// The order matters: Highway first includes this file once for each target.
#include "pipeline/states/state_bodies-inl.h"

HWY_BEFORE_NAMESPACE();
namespace collision_monitor {
namespace HWY_NAMESPACE {

struct BlockSearch {
  StateLanes states;
  StateQuestion question;
  JudgedLanes judged;
  Truth is_open;  ///< the search goes on in these states

  template <class CoreA, class CoreB>
  void visit(const PairRange& range);
};

/// [m] A pair that is farther apart cannot change the answer.
HWY_INLINE Number reachOfPair(const BlockSearch& search, const StatePair& pair) {
  return search.question == StateQuestion::contact
             ? number(pair.contact_distance)
             : hn::Max(search.judged.distance, number(pair.warning_distance));
}

HWY_INLINE void judge(std::size_t id, Truth counts, Number distance, BlockSearch& search) {
  const StatePair& pair = search.states.work.pairs[id];
  JudgedLanes& judged = search.judged;
  if (search.question == StateQuestion::nearest) {
    judged.takeNearer(pair, id, distance, counts);
    return;
  }
  const Truth is_contact = hn::And(counts, hn::Le(distance, number(pair.contact_distance)));
  judged.takeWhere(is_contact, id, distance);
  judged.is_contact = hn::Or(judged.is_contact, is_contact);
  judged.is_unknown = hn::Or(judged.is_unknown, hn::AndNot(hn::Eq(distance, distance), counts));
  search.is_open = hn::AndNot(is_contact, search.is_open);
}

template <class CoreA, class CoreB>
void BlockSearch::visit(const PairRange& range) {
  for (std::size_t id = range.first; id < range.last; ++id) {
    const StatePair& pair = states.work.pairs[id];
    if (pair.is_apart) {
      continue;
    }
    Truth counts = is_open;
    const Number distance =
        stateDistanceWithin<CoreA, CoreB>(states, pair, reachOfPair(*this, pair), counts);
    if (hn::AllFalse(Lanes(), counts)) {
      continue;
    }
    judge(id, counts, distance, *this);
    if (hn::AllFalse(Lanes(), is_open)) {
      return;
    }
  }
}

void placeInLanes(const CycleSetup& setup, StatesWork& work) {
  for (std::size_t i = 0; i < work.bodies.size(); ++i) {
    placeBody(setup, i, work);
  }
}

void judgeLanes(const CycleSetup& setup, StateQuestion question, const StatesWork& work,
                StatesBlock& block) {
  for (std::size_t lane = 0; lane < kStateCount; lane += hn::Lanes(Lanes())) {
    BlockSearch search{{setup, work, lane}, question, {}, hn::Eq(zero(), zero())};
    for (const PairRange& range : setup.ranges) {
      visitKinds(range, search);
      if (hn::AllFalse(Lanes(), search.is_open)) {
        break;
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
HWY_EXPORT(placeInLanes);
HWY_EXPORT(judgeLanes);
}  // namespace

void placeBodies(const CycleSetup& setup, StatesWork& work) noexcept {
  HWY_DYNAMIC_DISPATCH(placeInLanes)(setup, work);
}

void placeStates(const CycleSetup& setup, StatesWork& work) noexcept {
  placeFrames(work.plan, work.variables, work.frames);
  placeBodies(setup, work);
}

void judgeBlock(const CycleSetup& setup, StateQuestion question, const StatesWork& work,
                StatesBlock& block) noexcept {
  HWY_DYNAMIC_DISPATCH(judgeLanes)(setup, question, work, block);
}

}  // namespace collision_monitor
#endif
