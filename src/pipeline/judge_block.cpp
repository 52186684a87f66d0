// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/geometry/lane_targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/judge_block.cpp"
#include "hwy/foreach_target.h"
// The order matters: Highway first includes this file once for each target.
#include "model/state_lanes-inl.h"
#include "narrow_phase/lanes_box_box-inl.h"
#include "narrow_phase/lanes_points-inl.h"
#include "narrow_phase/lanes_segment_box-inl.h"
#include "pipeline/states_block.h"

HWY_BEFORE_NAMESPACE();
namespace collision_monitor {
namespace HWY_NAMESPACE {

/// A body in several states, as the cores of shape_lanes-inl.h read it.
struct BodyInStates {
  const StatePose& pose;
  const Core& core;
  std::size_t lane;

  HWY_INLINE Number at(std::size_t c) const {
    switch (c) {
      case column::radius:
        return number(core.radius);
      case column::half_x:
        return number(core.half_extents[0]);
      case column::half_y:
        return number(core.half_extents[1]);
      case column::half_z:
        return number(core.half_extents[2]);
      default:
        break;
    }
    const StateNumber* columns[] = {pose.translation, pose.axis_z, pose.axis_x, pose.axis_y};
    return load(columns[c / 4][c % 4], lane);
  }
};

/// What is known so far of the states in the lanes.
struct JudgedLanes {
  Number distance, pair;
  Truth is_contact, is_warning, is_unknown;
  Truth is_open;  ///< still to be searched
};

struct BlockSearch {
  const CycleSetup& setup;
  const StatesWork& work;
  StateQuestion question;
  std::size_t lane;
};

/// [m] A pair that is farther apart does not change the answer.
HWY_INLINE Number reachOfPair(const BlockSearch& search, const StatePair& pair,
                              const JudgedLanes& judged) {
  return search.question == StateQuestion::contact
             ? number(pair.contact_distance)
             : hn::Max(judged.distance, number(pair.warning_distance));
}

/// Where bounding spheres leave a pair a chance to be within `reach`.
HWY_INLINE Truth spheresMeet(const BlockSearch& search, const StatePair& pair, Number reach) {
  const Vector3 between = load(search.work.bodies[pair.b].translation, search.lane) -
                          load(search.work.bodies[pair.a].translation, search.lane);
  const Number allowed = hn::Add(number(pair.bounding_radii), reach);
  return hn::Not(hn::Gt(dot(between, between), hn::Mul(allowed, allowed)));
}

/// Has the plain twin measure the lanes whose distance is NaN.
HWY_NOINLINE Number finished(const BlockSearch& search, const StatePair& pair, Number distance) {
  HWY_ALIGN double distances[hn::MaxLanes(Lanes())];
  hn::Store(distance, Lanes(), distances);
  for (std::size_t i = 0; i < hn::Lanes(Lanes()); ++i) {
    if (!(distances[i] == distances[i])) {
      distances[i] = plainStateDistance(search.setup, search.work, pair, search.lane + i);
    }
  }
  return hn::Load(Lanes(), distances);
}

HWY_INLINE void judge(const BlockSearch& search, std::size_t id, Truth counts, Number distance,
                      JudgedLanes& judged) {
  const StatePair& pair = search.work.pairs[id];
  const Truth is_contact = hn::And(counts, hn::Le(distance, number(pair.contact_distance)));
  const Truth is_taken = search.question == StateQuestion::contact
                             ? is_contact
                             : hn::And(counts, hn::Lt(distance, judged.distance));
  judged.distance = hn::IfThenElse(is_taken, distance, judged.distance);
  judged.pair = hn::IfThenElse(is_taken, number(static_cast<double>(id)), judged.pair);
  judged.is_contact = hn::Or(judged.is_contact, is_contact);
  judged.is_unknown = hn::Or(judged.is_unknown, hn::AndNot(hn::Eq(distance, distance), counts));
  if (search.question == StateQuestion::nearest) {
    judged.is_warning =
        hn::Or(judged.is_warning, hn::And(counts, hn::Le(distance, number(pair.warning_distance))));
  } else {
    judged.is_open = hn::AndNot(is_contact, judged.is_open);
  }
}

template <class CoreA, class CoreB>
void judgeRange(const BlockSearch& search, const PairRange& range, JudgedLanes& judged) {
  const StatesWork& work = search.work;
  const std::vector<Core>& cores = search.setup.cores;
  for (std::size_t id = range.first; id < range.last; ++id) {
    const StatePair& pair = work.pairs[id];
    const Number reach = reachOfPair(search, pair, judged);
    Truth counts = hn::And(judged.is_open, spheresMeet(search, pair, reach));
    if (hn::AllFalse(Lanes(), counts)) {
      continue;
    }
    const CoreA a(BodyInStates{work.bodies[pair.a], cores[pair.a], search.lane});
    const CoreB b(BodyInStates{work.bodies[pair.b], cores[pair.b], search.lane});
    counts = hn::And(counts, mayBeWithin(a, b, reach));
    if (hn::AllFalse(Lanes(), counts)) {
      continue;
    }
    Number distance = coreDistance(a, b).distance;
    distance = hn::Sub(hn::Sub(distance, a.radius), b.radius);
    if (HWY_UNLIKELY(!hn::AllFalse(Lanes(), hn::AndNot(hn::Eq(distance, distance), counts)))) {
      distance = finished(search, pair, distance);
    }
    judge(search, id, counts, distance, judged);
    if (hn::AllFalse(Lanes(), judged.is_open)) {
      return;
    }
  }
}

void judgeKinds(const BlockSearch& search, const PairRange& range, JudgedLanes& judged) {
  if (range.a == CoreKind::box) {
    judgeRange<BoxCore, BoxCore>(search, range, judged);
  } else if (range.a == CoreKind::segment) {
    range.b == CoreKind::box ? judgeRange<SegmentCore, BoxCore>(search, range, judged)
                             : judgeRange<SegmentCore, SegmentCore>(search, range, judged);
  } else if (range.b == CoreKind::box) {
    judgeRange<PointCore, BoxCore>(search, range, judged);
  } else {
    range.b == CoreKind::segment ? judgeRange<PointCore, SegmentCore>(search, range, judged)
                                 : judgeRange<PointCore, PointCore>(search, range, judged);
  }
}

void placeBody(const LinkPlace& place, const Core& core, std::size_t lane, const StatePose& frame,
               StatePose& body) {
  const PoseLanes world_from_frame = load(frame, lane);
  const Pose& local = place.frame_from_link;
  const auto axis = [&](Eigen::Index i) HWY_ATTR {
    return out(world_from_frame.axes, everywhere(Eigen::Vector3d(local.rotation.col(i))));
  };
  store(world_from_frame * everywhere(local.translation), lane, body.translation);
  if (core.kind != CoreKind::point) {
    store(axis(2), lane, body.axis_z);
  }
  if (core.kind == CoreKind::box) {
    store(axis(0), lane, body.axis_x);
    store(axis(1), lane, body.axis_y);
  }
}

void placeInLanes(const CycleSetup& setup, StatesWork& work) {
  for (std::size_t i = 0; i < work.bodies.size(); ++i) {
    const LinkPlace& place = work.body_places[i];
    if (place.frame != MovingFrame::kWorld) {
      for (std::size_t lane = 0; lane < kStateCount; lane += hn::Lanes(Lanes())) {
        placeBody(place, setup.cores[i], lane, work.frames[place.frame], work.bodies[i]);
      }
    }
  }
}

HWY_INLINE void storeTruth(Truth truth, std::size_t lane, StateNumber& to) {
  hn::Store(hn::IfThenElseZero(truth, number(1.0)), Lanes(), to.of + lane);
}

void judgeLanes(const CycleSetup& setup, StateQuestion question, const StatesWork& work,
                StatesBlock& block) {
  for (std::size_t lane = 0; lane < kStateCount; lane += hn::Lanes(Lanes())) {
    const Truth none = hn::Ne(zero(), zero());
    JudgedLanes judged{
        number(std::numeric_limits<double>::infinity()), zero(), none, none, none, hn::Not(none)};
    for (const PairRange& range : setup.ranges) {
      judgeKinds({setup, work, question, lane}, range, judged);
      if (hn::AllFalse(Lanes(), judged.is_open)) {
        break;
      }
    }
    hn::Store(judged.distance, Lanes(), block.distance.of + lane);
    hn::Store(judged.pair, Lanes(), block.pair.of + lane);
    storeTruth(judged.is_contact, lane, block.is_contact);
    storeTruth(judged.is_warning, lane, block.is_warning);
    storeTruth(judged.is_unknown, lane, block.is_unknown);
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

void placeStates(const CycleSetup& setup, StatesWork& work) noexcept {
  placeFrames(work.plan, work.variables, work.frames);
  HWY_DYNAMIC_DISPATCH(placeInLanes)(setup, work);
}

void judgeBlock(const CycleSetup& setup, StateQuestion question, const StatesWork& work,
                StatesBlock& block) noexcept {
  HWY_DYNAMIC_DISPATCH(judgeLanes)(setup, question, work, block);
}

}  // namespace collision_monitor
#endif
