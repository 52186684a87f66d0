// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <type_traits>

#include "collision_monitor/geometry/visit_held.h"
#include "collision_monitor/narrow_phase/convex_distance.h"
#include "collision_monitor/narrow_phase/distance.h"
#include "narrow_phase/core_distance.h"
#include "narrow_phase/distance_half_space.h"
#include "narrow_phase/search_cores.h"

namespace collision_monitor {
namespace {

using Kind = ConvexCore::Kind;

ConvexCore coreOf(const Sphere&) noexcept { return {}; }
ConvexCore coreOf(const Capsule& s) noexcept { return {Kind::box, {0.0, 0.0, s.half_length}}; }
ConvexCore coreOf(const Box& s) noexcept { return {Kind::box, s.half_extents}; }
ConvexCore coreOf(const RoundedBox& s) noexcept { return {Kind::box, s.half_extents}; }
// Without width it is a segment, which has corners to end a search on.
ConvexCore coreOf(const Cylinder& s) noexcept {
  return {s.radius > 0.0 ? Kind::cylinder : Kind::box, {s.radius, s.radius, s.half_length}};
}
ConvexCore coreOf(const ConvexHull& hull) noexcept {
  return {Kind::hull, Eigen::Vector3d::Zero(), &hull};
}

double sweepOf(const Sphere& s) noexcept { return s.radius; }
double sweepOf(const Capsule& s) noexcept { return s.radius; }
double sweepOf(const Box&) noexcept { return 0.0; }
double sweepOf(const RoundedBox& s) noexcept { return s.radius; }
double sweepOf(const Cylinder&) noexcept { return 0.0; }
double sweepOf(const ConvexHull&) noexcept { return 0.0; }

/// Measured by the closed forms of distance.h.
template <class Geometry>
constexpr bool kHasClosedForms = std::is_convertible_v<const Geometry&, Shape>;

template <class Geometry>
constexpr bool kIsHalfSpace = std::is_same_v<Geometry, HalfSpace>;

template <class Geometry>
struct Posed {
  const Geometry& geometry;
  const Pose& world_from_body;
};

template <class A>
SignedDistance toHalfSpace(const Posed<A>& a, const Pose& world_from_half_space) noexcept {
  return swept(distanceToHalfSpace(coreOf(a.geometry), a.world_from_body, world_from_half_space),
               sweepOf(a.geometry), 0.0);
}

template <class A, class B>
ConvexDistance byCores(const Posed<A>& a, const Posed<B>& b, ConvexSearch& search) noexcept {
  const double radius_a = sweepOf(a.geometry);
  const double radius_b = sweepOf(b.geometry);
  ConvexPair pair =
      makeConvexPair(coreOf(a.geometry), a.world_from_body, coreOf(b.geometry), b.world_from_body);
  ConvexSearch of_cores{search.workspace, search.warm, search.enough + radius_a + radius_b};
  ConvexDistance found = searchCores(pair, of_cores);
  found.measured = swept(placed(a.world_from_body, found.measured), radius_a, radius_b);
  return found;
}

// Every pair of kinds ends in one of these, or does not compile.
template <class A, class B>
ConvexDistance measure(const Posed<A>& a, const Posed<B>& b, ConvexSearch& search) noexcept {
  if constexpr (kIsHalfSpace<A> && kIsHalfSpace<B>) {
    return {};  // they overlap without end, or are apart by rounding alone
  } else if constexpr (kIsHalfSpace<B>) {
    return {toHalfSpace(a, b.world_from_body), DistanceQuality::exact};
  } else if constexpr (kIsHalfSpace<A>) {
    return {swapped(toHalfSpace(b, a.world_from_body)), DistanceQuality::exact};
  } else if constexpr (kHasClosedForms<A> && kHasClosedForms<B>) {
    return {distanceBetween(a.geometry, a.world_from_body, b.geometry, b.world_from_body),
            DistanceQuality::exact};
  } else {
    return byCores(a, b, search);
  }
}

}  // namespace

ConvexDistance signedDistanceBetween(const ConvexGeometry& a, const Pose& world_from_a,
                                     const ConvexGeometry& b, const Pose& world_from_b,
                                     ConvexSearch& search) noexcept {
  if (!isFinite(world_from_a) || !isFinite(world_from_b)) {
    return {};
  }
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
