// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <type_traits>

#include "collision_monitor/narrow_phase/convex_distance.h"
#include "geometry/bvh/visit_held.h"
#include "narrow_phase/closed_form/core_distance.h"
#include "narrow_phase/convex/distance_half_space.h"
#include "narrow_phase/convex/search_cores.h"
#include "narrow_phase/distance.h"
#include "narrow_phase/gjk/convex_core.h"
#include "narrow_phase/gjk/flat_contact.h"
#include "narrow_phase/warm_start/distance_from_warm_start.h"

namespace collision_monitor {
namespace {

/// True for geometries with the closed forms of distance.h.
template <class Geometry>
constexpr bool kHasClosedForms = std::is_convertible_v<const Geometry&, Shape>;

template <class Geometry>
constexpr bool kIsHalfSpace = std::is_same_v<Geometry, HalfSpace>;

template <class Geometry>
constexpr bool kIsBox = std::is_same_v<Geometry, Box> || std::is_same_v<Geometry, RoundedBox>;

template <class Geometry>
struct Posed {
  const Geometry& geometry;
  const Pose& world_from_body;
};

template <class A, class B>
bool areFinite(const Posed<A>& a, const Posed<B>& b) noexcept {
  return isFinite(a.world_from_body) && isFinite(b.world_from_body);
}

template <class A>
SignedDistance toHalfSpace(const Posed<A>& a, const Pose& world_from_half_space) noexcept {
  const InflatedCore inflated_a = inflatedCoreOf(a.geometry);
  return inflated(distanceToHalfSpace(inflated_a.core, a.world_from_body, world_from_half_space),
                  inflated_a.radius, 0.0);
}

// Returns true if the warm start proves the new answer.
template <class A, class B>
bool tryWarmStart(const Posed<A>& a, const Posed<B>& b, const ConvexSearch& search,
                  SignedDistance& measured) noexcept {
  ConvexWarmStart& warm = search.warm;
  const InflatedCore inflated_a = inflatedCoreOf(a.geometry);
  const InflatedCore inflated_b = inflatedCoreOf(b.geometry);
  const PlacedCore core_a{inflated_a.core, a.world_from_body, warm.vertex_of_a};
  const PlacedCore core_b{inflated_b.core, b.world_from_body, warm.vertex_of_b};
  auto confirmed = distanceFromWarmStart(core_a, core_b, warm);
  if (!confirmed) {
    return false;
  }
  if (confirmed->is_level && !search.stands_alone) {
    centerOnPatch(core_a, core_b, confirmed->cores);
  }
  measured = inflated(confirmed->cores, inflated_a.radius, inflated_b.radius);
  return true;
}

template <class A, class B>
ConvexDistance byCores(const Posed<A>& a, const Posed<B>& b, ConvexSearch& search) noexcept {
  ConvexWarmStart& warm = search.warm;
  ConvexDistance confirmed{SignedDistance{}, Quality::exact};
  if (tryWarmStart(a, b, search, confirmed.measured)) {
    return confirmed;
  }
  if (!areFinite(a, b)) {
    return {};
  }
  const InflatedCore inflated_a = inflatedCoreOf(a.geometry);
  const InflatedCore inflated_b = inflatedCoreOf(b.geometry);
  ConvexPair pair =
      makeConvexPair(inflated_a.core, a.world_from_body, inflated_b.core, b.world_from_body);
  if (search.stands_alone && pair.isSmooth()) {
    forget(warm);  // along a cylinder, other points are a bad start
  }
  ConvexSearch of_cores{search.workspace, warm,
                        search.cutoff + inflated_a.radius + inflated_b.radius, search.stands_alone};
  const ConvexDistance found = searchCores(pair, of_cores);
  return {inflated(placed(a.world_from_body, found.measured), inflated_a.radius, inflated_b.radius),
          found.quality};
}

// Every pair of kinds ends here, in byCores or in ofBoxes, or does not compile.
template <class A, class B>
ConvexDistance inClosedForm(const Posed<A>& a, const Posed<B>& b) noexcept {
  if (!areFinite(a, b)) {
    return {};
  }
  if constexpr (kIsHalfSpace<A> && kIsHalfSpace<B>) {
    return {};  // they overlap without end, or rounding alone keeps them apart
  } else if constexpr (kIsHalfSpace<B>) {
    return {toHalfSpace(a, b.world_from_body), Quality::exact};
  } else if constexpr (kIsHalfSpace<A>) {
    return {swapped(toHalfSpace(b, a.world_from_body)), Quality::exact};
  } else {
    return {distanceBetween(a.geometry, a.world_from_body, b.geometry, b.world_from_body),
            Quality::exact};
  }
}

// Keeps the facing corners for a proof in the next search. Cores that touch have no such proof and
// keep none.
template <class A, class B>
void keepFacing(const Posed<A>& a, const Posed<B>& b, const SignedDistance& measured,
                ConvexWarmStart& warm) noexcept {
  const InflatedCore inflated_a = inflatedCoreOf(a.geometry);
  const InflatedCore inflated_b = inflatedCoreOf(b.geometry);
  const PlacedCore core_a{inflated_a.core, a.world_from_body, warm.vertex_of_a};
  const PlacedCore core_b{inflated_b.core, b.world_from_body, warm.vertex_of_b};
  const PlacedPair pair = makePlacedPair(core_a, core_b);
  const double distance = measured.distance + inflated_a.radius + inflated_b.radius;
  const bool is_apart = distance > touchingDistance(pair.size);
  warm.size = is_apart ? 1 : 0;
  if (is_apart) {
    warm.ends[0] = cornersOf(pair, {measured.normal_a_to_b, distance, false});
  }
}

// Tries a proof first: the closed form of two boxes takes three times as long.
template <class A, class B>
ConvexDistance ofBoxes(const Posed<A>& a, const Posed<B>& b, ConvexSearch& search) noexcept {
  ConvexDistance found{SignedDistance{}, Quality::exact};
  if (tryWarmStart(a, b, search, found.measured)) {
    return found;
  }
  found = inClosedForm(a, b);
  if (found.quality == Quality::exact) {
    keepFacing(a, b, found.measured, search.warm);
  }
  return found;
}

template <class A, class B>
ConvexDistance measure(const Posed<A>& a, const Posed<B>& b, ConvexSearch& search) noexcept {
  if constexpr (!kIsHalfSpace<A> && !kIsHalfSpace<B> &&
                !(kHasClosedForms<A> && kHasClosedForms<B>)) {
    return byCores(a, b, search);
  } else if constexpr (kIsBox<A> && kIsBox<B>) {
    return ofBoxes(a, b, search);
  } else {
    return inClosedForm(a, b);
  }
}

}  // namespace

ConvexDistance signedDistanceBetween(const ConvexGeometry& a, const Pose& world_from_a,
                                     const ConvexGeometry& b, const Pose& world_from_b,
                                     ConvexSearch& search) noexcept {
  const auto with_a = [&](const auto& geometry_a) noexcept {
    const auto with_b = [&](const auto& geometry_b) noexcept {
      using A = std::decay_t<decltype(geometry_a)>;
      using B = std::decay_t<decltype(geometry_b)>;
      return measure(Posed<A>{geometry_a, world_from_a}, Posed<B>{geometry_b, world_from_b},
                     search);
    };
    return visitHeld(with_b, b);
  };
  return visitHeld(with_a, a);
}

}  // namespace collision_monitor
