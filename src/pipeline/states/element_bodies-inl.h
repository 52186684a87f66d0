// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Measures the bodies of pairs of elements in several states at once.
#if defined(COLLISION_MONITOR_ELEMENT_BODIES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef COLLISION_MONITOR_ELEMENT_BODIES_INL_H
#undef COLLISION_MONITOR_ELEMENT_BODIES_INL_H
#else
#define COLLISION_MONITOR_ELEMENT_BODIES_INL_H
#endif

#include "pipeline/states/state_bodies-inl.h"

HWY_BEFORE_NAMESPACE();
namespace collision_monitor {
namespace HWY_NAMESPACE {

/// The bodies of a block of states. Each is placed when it is first needed.
/// @pre balls are placed.
struct ElementBodies {
  StateLanes states;
  StatesWork& work;

  void place(std::uint32_t body) {
    std::uint64_t& placed_in = work.refinement.body_placed_in[body];
    if (placed_in != work.refinement.block) {
      placed_in = work.refinement.block;
      placeBody(states.setup, body, work);
    }
  }

  /// A box of StatesRefinement::box_of.
  HWY_INLINE BoxCore placedBox(std::uint32_t id) {
    if (id < work.bodies.size()) {
      place(id);
      return BoxCore(BodyInStates{work.bodies[id], states.setup.cores[id], states.lane});
    }
    OuterBox& box = work.refinement.outer_boxes[id - work.bodies.size()];
    if (box.placed_in != work.refinement.block) {
      box.placed_in = work.refinement.block;
      placeCore(box.place, box.core, work, box.pose);
    }
    return BoxCore(BodyInStates{box.pose, box.core, states.lane});
  }

  /// Whether the box around one element and the ball of the other allow them to be within `reach`;
  /// of elements with several bodies, whether the boxes around both do. A ball fills a long or flat
  /// element badly.
  HWY_INLINE Truth boxesMeet(const StateElementPair& pair, Number reach, Truth counts) {
    if (pair.box == kNone) {
      return counts;
    }
    const StatesRefinement& refinement = work.refinement;
    const BoxCore box = placedBox(pair.box);
    const Number radius = number(refinement.balls[pair.ball].radius);
    const Vector3 center = load(refinement.centers[pair.ball].of, states.lane);
    counts = hn::And(counts, isNearBox(center, box, hn::Add(radius, reach)));
    if (pair.has_many && !hn::AllFalse(Lanes(), counts)) {
      counts = hn::And(counts, mayBeWithin(box, placedBox(pair.ball_box), reach));
    }
    return counts;
  }

  template <class CoreA, class CoreB, bool kBoundOnly = false>
  HWY_NOINLINE Number measureKinds(const StatePair& pair, Number reach, Truth& counts) {
    place(pair.a);
    place(pair.b);
    return stateDistanceWithin<CoreA, CoreB, kBoundOnly>(states, pair, reach, counts);
  }

  /// As stateDistanceWithin, of a pair of any kind.
  template <bool kBoundOnly = false>
  Number measure(const StatePair& pair, Number reach, Truth& counts) {
    const CoreKind a = states.setup.cores[pair.a].kind;
    const CoreKind b = states.setup.cores[pair.b].kind;
    if (a == CoreKind::box) {
      return measureKinds<BoxCore, BoxCore, kBoundOnly>(pair, reach, counts);
    }
    if (a == CoreKind::segment) {
      return b == CoreKind::box ? measureKinds<SegmentCore, BoxCore>(pair, reach, counts)
                                : measureKinds<SegmentCore, SegmentCore>(pair, reach, counts);
    }
    if (b == CoreKind::box) {
      return measureKinds<PointCore, BoxCore>(pair, reach, counts);
    }
    return b == CoreKind::segment ? measureKinds<PointCore, SegmentCore>(pair, reach, counts)
                                  : measureKinds<PointCore, PointCore>(pair, reach, counts);
  }

  /// Of the centers of two elements. @return [m^2]
  HWY_INLINE Number squaredDistance(std::uint32_t a, std::uint32_t b) const {
    const StatePoint* const centers = work.refinement.centers.data();
    const Vector3 between = load(centers[b].of, states.lane) - load(centers[a].of, states.lane);
    return dot(between, between);
  }

  /// Whether balls around the centers of two elements allow them to be within `reach`.
  /// @param radii [m] sum of both
  HWY_INLINE Truth ballsMeet(const StateElementPair& pair, double radii, Number reach) const {
    const Number allowed = hn::Add(number(radii), reach);
    return hn::Not(hn::Gt(squaredDistance(pair.a, pair.b), hn::Mul(allowed, allowed)));
  }
};

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace collision_monitor
HWY_AFTER_NAMESPACE();

#endif
