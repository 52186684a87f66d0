// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Measures pairs of bodies in several states at once.
#if defined(COLLISION_MONITOR_STATE_BODIES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef COLLISION_MONITOR_STATE_BODIES_INL_H
#undef COLLISION_MONITOR_STATE_BODIES_INL_H
#else
#define COLLISION_MONITOR_STATE_BODIES_INL_H
#endif

#include "model/kinematics/state_lanes-inl.h"
#include "narrow_phase/simd/lanes_box_box-inl.h"
#include "narrow_phase/simd/lanes_points-inl.h"
#include "narrow_phase/simd/lanes_segment_box-inl.h"
#include "pipeline/states/states_block.h"

HWY_BEFORE_NAMESPACE();
namespace collision_monitor {
namespace HWY_NAMESPACE {

/// The states of a block in one vector, from `lane` on.
struct StateLanes {
  const CycleSetup& setup;
  const StatesWork& work;
  std::size_t lane;
};

HWY_INLINE void storeTruth(Truth truth, std::size_t lane, StateNumber& to) {
  hn::Store(hn::IfThenElseZero(truth, number(1.0)), Lanes(), to.of + lane);
}

/// What is known of the states in the lanes: a StatesBlock.
struct JudgedLanes {
  Number distance{number(std::numeric_limits<double>::infinity())};
  Number pair{zero()};
  Truth is_contact{none()};
  Truth is_warning{none()};
  Truth is_unknown{none()};

  static HWY_INLINE Truth none() { return hn::Ne(zero(), zero()); }

  HWY_INLINE void takeWhere(Truth is_taken, std::size_t id, Number measured) {
    distance = hn::IfThenElse(is_taken, measured, distance);
    pair = hn::IfThenElse(is_taken, number(static_cast<double>(id)), pair);
  }

  /// Of equal distances the first pair of the table wins.
  HWY_INLINE void takeNearer(const StatePair& limits, std::size_t id, Number measured,
                             Truth counts) {
    const Truth is_first =
        hn::And(hn::Eq(measured, distance), hn::Lt(number(static_cast<double>(id)), pair));
    takeWhere(hn::And(counts, hn::Or(hn::Lt(measured, distance), is_first)), id, measured);
    const auto isWithin = [&](double limit)
                              HWY_ATTR { return hn::And(counts, hn::Le(measured, number(limit))); };
    is_contact = hn::Or(is_contact, isWithin(limits.contact_distance));
    is_warning = hn::Or(is_warning, isWithin(limits.warning_distance));
    is_unknown = hn::Or(is_unknown, hn::AndNot(hn::Eq(measured, measured), counts));
  }

  void store(std::size_t lane, StatesBlock& block) const {
    hn::Store(distance, Lanes(), block.distance.of + lane);
    hn::Store(pair, Lanes(), block.pair.of + lane);
    storeTruth(is_contact, lane, block.is_contact);
    storeTruth(is_warning, lane, block.is_warning);
    storeTruth(is_unknown, lane, block.is_unknown);
  }
};

/// A body in several states, in the form that the cores of shape_lanes-inl.h read.
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

HWY_INLINE void placeInVector(const LinkPlace& place, const Core& core, std::size_t lane,
                              const StatePose& frame, StatePose& body) {
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

/// Places a core in all states of the block. What no joint moves stands where it is.
/// @pre frames are placed.
inline void placeCore(const LinkPlace& place, const Core& core, const StatesWork& work,
                      StatePose& pose) {
  if (place.frame == MovingFrame::kWorld) {
    return;
  }
  for (std::size_t lane = 0; lane < kStateCount; lane += hn::Lanes(Lanes())) {
    placeInVector(place, core, lane, work.frames[place.frame], pose);
  }
}

inline void placeBody(const CycleSetup& setup, std::size_t body, StatesWork& work) {
  placeCore(work.body_places[body], setup.cores[body], work, work.bodies[body]);
}

/// Whether bounding spheres allow a pair to be within `reach`.
HWY_INLINE Truth spheresMeet(const StateLanes& states, const StatePair& pair, Number reach) {
  const Vector3 between = load(states.work.bodies[pair.b].translation, states.lane) -
                          load(states.work.bodies[pair.a].translation, states.lane);
  const Number allowed = hn::Add(number(pair.bounding_radii), reach);
  return hn::Not(hn::Gt(dot(between, between), hn::Mul(allowed, allowed)));
}

/// Whether a point is within `reach` of a box. Near a long or flat box this is far less than near
/// its bounding sphere.
HWY_INLINE Truth isNearBox(const Vector3& point, const BoxCore& box, Number reach) {
  const Vector3 gaps = absolute(into(box.axes, point - box.center)) - box.half_extents;
  return hn::Not(isBeyond(gaps, hn::Add(reach, box.radius)));
}

/// Measures the lanes whose distance is NaN by the plain twin.
inline HWY_NOINLINE Number finished(const StateLanes& states, const StatePair& pair,
                                    Number distance) {
  HWY_ALIGN double distances[hn::MaxLanes(Lanes())];
  hn::Store(distance, Lanes(), distances);
  for (std::size_t i = 0; i < hn::Lanes(Lanes()); ++i) {
    if (!(distances[i] == distances[i])) {
      distances[i] = plainStateDistance(states.setup, states.work, pair, states.lane + i);
    }
  }
  return hn::Load(Lanes(), distances);
}

/// The signed distance of a pair, by distanceWithin of its cores in the states that count.
template <class CoreA, class CoreB, bool kBoundOnly = false>
HWY_INLINE Number stateDistanceWithin(const StateLanes& states, const StatePair& pair, Number reach,
                                      Truth& counts) {
  counts = hn::And(counts, spheresMeet(states, pair, reach));
  if (hn::AllFalse(Lanes(), counts)) {
    return zero();
  }
  const std::vector<Core>& cores = states.setup.cores;
  const CoreA a(BodyInStates{states.work.bodies[pair.a], cores[pair.a], states.lane});
  const CoreB b(BodyInStates{states.work.bodies[pair.b], cores[pair.b], states.lane});
  if constexpr (CoreA::kKind == CoreKind::box) {
    const double radius = states.setup.bodies[pair.a].bounding_radius;
    counts = hn::And(counts, isNearBox(a.center, b, hn::Add(reach, number(radius))));
    if (hn::AllFalse(Lanes(), counts)) {
      return zero();
    }
  }
  if constexpr (kBoundOnly && CoreA::kKind == CoreKind::box) {
    return boundWithin(a, b, reach, counts);
  }
  const Number distance = distanceWithin(a, b, reach, counts);
  const bool is_sure = hn::AllFalse(Lanes(), hn::AndNot(hn::Eq(distance, distance), counts));
  return HWY_LIKELY(is_sure) ? distance : finished(states, pair, distance);
}

/// Calls visitor.visit with the kinds of core of a range.
template <class Visitor>
void visitKinds(const PairRange& range, Visitor& visitor) {
  if (range.a == CoreKind::box) {
    visitor.template visit<BoxCore, BoxCore>(range);
  } else if (range.a == CoreKind::segment) {
    range.b == CoreKind::box ? visitor.template visit<SegmentCore, BoxCore>(range)
                             : visitor.template visit<SegmentCore, SegmentCore>(range);
  } else if (range.b == CoreKind::box) {
    visitor.template visit<PointCore, BoxCore>(range);
  } else {
    range.b == CoreKind::segment ? visitor.template visit<PointCore, SegmentCore>(range)
                                 : visitor.template visit<PointCore, PointCore>(range);
  }
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace collision_monitor
HWY_AFTER_NAMESPACE();

#endif
