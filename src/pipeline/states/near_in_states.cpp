// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/lanes/lane_targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/states/near_in_states.cpp"
#include "hwy/foreach_target.h"
// The order matters: Highway first includes this file once for each target.
#include "pipeline/states/element_bodies-inl.h"
#include "pipeline/states/state_elements.h"

HWY_BEFORE_NAMESPACE();
namespace collision_monitor {
namespace HWY_NAMESPACE {

/// Lists pairs of bodies that are near in some states.
struct NearSearch {
  ElementBodies bodies;
  const NearQuery& query;
  Number asked;
  Truth have_near{JudgedLanes::none()};

  StatesRefinement& refinement() const { return bodies.work.refinement; }

  Number reachOf(double contact_distance) const { return hn::Max(asked, number(contact_distance)); }

  /// A bound is enough if the geometries are measured afterwards: the bodies then only say which
  /// pairs are near, and in what order to measure them.
  Number distanceOf(std::uint32_t id, const StatePair& pair, Number reach, Truth& counts) {
    const CycleSetup& setup = bodies.states.setup;
    return areMeasured(setup, setup.element_pair_of[id]) ? bodies.measure<true>(pair, reach, counts)
                                                         : bodies.measure(pair, reach, counts);
  }

  /// @return in which states the bodies are near
  Truth measureBodies(std::uint32_t id, Truth counts) {
    const StatePair& pair = bodies.work.pairs[id];
    const Number reach = reachOf(pair.contact_distance);
    const Number distance = distanceOf(id, pair, reach, counts);
    // NaN counts as near.
    counts = hn::AndNot(hn::Gt(distance, reach), counts);
    if (!hn::AllFalse(Lanes(), counts)) {
      NearInStates& found = refinement().near.emplace_back();
      found.pair = id;
      const Number far = number(std::numeric_limits<double>::infinity());
      hn::StoreU(hn::IfThenElse(counts, distance, far), Lanes(), found.distance.data());
      have_near = hn::Or(have_near, counts);
    }
    return counts;
  }

  /// Whether the balls of two elements do not allow them to be within the activation distance.
  template <bool kContactsOnly>
  HWY_INLINE Truth ballsPart(const OrderedPair& ordered) const {
    if constexpr (kContactsOnly) {
      return hn::Gt(bodies.squaredDistance(ordered.a, ordered.b), number(ordered.squared_contact));
    }
    const StateElementPair& pair = refinement().element_pairs[ordered.elements];
    return hn::Not(bodies.ballsMeet(pair, pair.radii, reachOf(pair.contact_distance)));
  }

  template <bool kContactsOnly>
  HWY_INLINE void run() {
    const Truth is_asked = hn::Gt(asked, number(kNotAsked));
    const OrderedPair* const order = refinement().order.data();
    for (std::size_t i = query.first; i < query.last; ++i) {
      const Truth may_be_near = hn::AndNot(ballsPart<kContactsOnly>(order[i]), is_asked);
      if (!hn::AllFalse(Lanes(), may_be_near)) {
        measureElements(order[i].elements, may_be_near);
      }
    }
  }

  /// Not inlined: the loop over all pairs stays short.
  HWY_NOINLINE void measureElements(ElementPairIndex elements, Truth counts) {
    const StateElementPair& pair = refinement().element_pairs[elements];
    if (query.is_convex_only && !pair.are_convex) {
      return;
    }
    counts = bodies.boxesMeet(pair, reachOf(pair.contact_distance), counts);
    if (hn::AllFalse(Lanes(), counts)) {
      return;
    }
    const bool is_one_enough = query.asks_any && isExact(bodies.states.setup, elements);
    for (std::uint32_t i = pair.first; i < pair.last && !hn::AllFalse(Lanes(), counts); ++i) {
      const Truth is_near = measureBodies(refinement().body_pairs[i], counts);
      counts = is_one_enough ? hn::AndNot(is_near, counts) : counts;
    }
  }
};

std::size_t listNearInLanes(const CycleSetup& setup, const NearQuery& query, std::size_t lane,
                            StatesWork& work) {
  StatesRefinement& refinement = work.refinement;
  refinement.near.clear();
  NearSearch search{{{setup, work, lane}, work}, query, hn::LoadU(Lanes(), query.asked.of + lane)};
  if (hn::AllTrue(Lanes(), hn::Le(search.asked, number(kContactsAsked)))) {
    search.run<true>();
  } else {
    search.run<false>();
  }
  hn::StoreMaskBits(Lanes(), search.have_near, &refinement.have_near);
  return hn::Lanes(Lanes());
}

void placeCentersInLanes(StatesWork& work) {
  StatesRefinement& refinement = work.refinement;
  ++refinement.block;
  for (std::size_t i = 0; i < refinement.places.size(); ++i) {
    const LinkPlace& place = refinement.places[i];
    if (place.frame == MovingFrame::kWorld) {
      continue;
    }
    const Vector3 center = everywhere(place.frame_from_link * refinement.balls[i].center);
    for (std::size_t lane = 0; lane < kStateCount; lane += hn::Lanes(Lanes())) {
      store(load(work.frames[place.frame], lane) * center, lane, refinement.centers[i].of);
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
HWY_EXPORT(listNearInLanes);
HWY_EXPORT(placeCentersInLanes);
}  // namespace

std::size_t listNear(const CycleSetup& setup, const NearQuery& query, std::size_t lane,
                     StatesWork& work) noexcept {
  return HWY_DYNAMIC_DISPATCH(listNearInLanes)(setup, query, lane, work);
}

void placeCenters(StatesWork& work) noexcept { HWY_DYNAMIC_DISPATCH(placeCentersInLanes)(work); }

}  // namespace collision_monitor
#endif
