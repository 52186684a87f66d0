// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause

// Shapes of one kind, one per lane, read from columns.
#if defined(COLLISION_MONITOR_SHAPE_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COLLISION_MONITOR_SHAPE_LANES_INL_H_
#undef COLLISION_MONITOR_SHAPE_LANES_INL_H_
#else
#define COLLISION_MONITOR_SHAPE_LANES_INL_H_
#endif

#include <cstddef>
#include <limits>

#include "collision_monitor/narrow_phase/pair_rows.h"
#include "geometry/lanes/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace collision_monitor {
namespace HWY_NAMESPACE {

/// Consecutive shapes, one per lane: column c of the first is at first[c * stride].
struct ShapeLanes {
  const double* first;
  std::size_t stride;

  HWY_INLINE Number at(std::size_t c) const { return hn::LoadU(Lanes(), first + c * stride); }
};

/// The same shape in every lane.
struct OneShape {
  const double* first;
  std::size_t stride;

  HWY_INLINE Number at(std::size_t c) const { return number(first[c * stride]); }
};

template <class Source>
HWY_INLINE Vector3 vectorAt(const Source& source, std::size_t c) {
  return {source.at(c), source.at(c + 1), source.at(c + 2)};
}

struct PointCore {
  static constexpr CoreKind kKind = CoreKind::point;
  Vector3 center;
  Number radius;

  template <class Source>
  HWY_INLINE explicit PointCore(const Source& source)
      : center(vectorAt(source, column::center)), radius(source.at(column::radius)) {}
};

struct SegmentCore {
  static constexpr CoreKind kKind = CoreKind::segment;
  Vector3 center;
  Number radius;
  Vector3 direction;
  Number half_length;

  template <class Source>
  HWY_INLINE explicit SegmentCore(const Source& source)
      : center(vectorAt(source, column::center)),
        radius(source.at(column::radius)),
        direction(vectorAt(source, column::axis_z)),
        half_length(source.at(column::half_z)) {}
};

struct BoxCore {
  static constexpr CoreKind kKind = CoreKind::box;
  Vector3 center;
  Number radius;
  Axes axes;
  Vector3 half_extents;

  template <class Source>
  HWY_INLINE explicit BoxCore(const Source& source)
      : center(vectorAt(source, column::center)),
        radius(source.at(column::radius)),
        axes{vectorAt(source, column::axis_x), vectorAt(source, column::axis_y),
             vectorAt(source, column::axis_z)},
        half_extents{source.at(column::half_x), source.at(column::half_y),
                     source.at(column::half_z)} {}
};

/// The answer for two bare cores: SignedDistance without the second point, which follows from the
/// rest. It is sure unless the distance is NaN: then the plain twin must decide.
struct CoreAnswer {
  Number distance;
  Vector3 point_on_a;
  Vector3 normal;
};

/// The distance of coreDistance for callers that need no points; correct in the lanes that count.
/// Lanes beyond `reach` need not count, and no longer do if that is seen early.
template <class CoreA, class CoreB>
HWY_INLINE Number separationWithin(const CoreA& a, const CoreB& b, Number, Truth&) {
  return coreDistance(a, b).distance;
}

/// The signed distance of the shapes, in either order: separationWithin less the radii.
template <class CoreA, class CoreB>
HWY_INLINE Number distanceWithin(const CoreA& a, const CoreB& b, Number reach, Truth& counts) {
  if constexpr (CoreA::kKind > CoreB::kKind) {
    return distanceWithin(b, a, reach, counts);
  } else {
    const Number of_cores = hn::Add(hn::Add(reach, a.radius), b.radius);
    return hn::Sub(hn::Sub(separationWithin(a, b, of_cores, counts), a.radius), b.radius);
  }
}

HWY_INLINE Number sureWhere(Truth is_sure, Number distance) {
  return hn::IfThenElse(is_sure, distance, number(std::numeric_limits<double>::quiet_NaN()));
}

HWY_INLINE bool isSureEverywhere(const CoreAnswer& answer) {
  return hn::AllTrue(Lanes(), hn::Eq(answer.distance, answer.distance));
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace collision_monitor
HWY_AFTER_NAMESPACE();

#endif
