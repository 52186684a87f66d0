// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/lanes/lane_targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "narrow_phase/simd/measure_rows.cpp"
#include "hwy/foreach_target.h"
// The order matters: Highway first includes this file once for each target.
#include <algorithm>

#include "narrow_phase/simd/lanes_box_box-inl.h"
#include "narrow_phase/simd/lanes_points-inl.h"
#include "narrow_phase/simd/lanes_segment_box-inl.h"
#include "narrow_phase/simd/plain_twin.h"

HWY_BEFORE_NAMESPACE();
namespace collision_monitor {
namespace HWY_NAMESPACE {

void storeVector(const Vector3& v, std::size_t first, std::size_t row,
                 Columns<answer::count>& answers) {
  hn::Store(v.x, Lanes(), &answers.at[first][row]);
  hn::Store(v.y, Lanes(), &answers.at[first + 1][row]);
  hn::Store(v.z, Lanes(), &answers.at[first + 2][row]);
}

/// @return true if every row is sure.
template <class CoreA, class CoreB>
bool measureCores(std::size_t count, PairRows& rows) {
  bool is_sure = true;
  for (std::size_t row = 0; row < count; row += hn::Lanes(Lanes())) {
    const CoreA a(ShapeLanes{&rows.a.at[0][row], kRowCount});
    const CoreB b(ShapeLanes{&rows.b.at[0][row], kRowCount});
    const CoreAnswer cores = coreDistance(a, b);
    is_sure &= isSureEverywhere(cores);
    const Number distance = hn::Sub(hn::Sub(cores.distance, a.radius), b.radius);
    const Vector3 on_a = along(cores.point_on_a, a.radius, cores.normal);
    hn::Store(distance, Lanes(), &rows.answers.at[answer::distance][row]);
    storeVector(on_a, answer::point_on_a, row, rows.answers);
    storeVector(along(on_a, distance, cores.normal), answer::point_on_b, row, rows.answers);
    storeVector(cores.normal, answer::normal, row, rows.answers);
  }
  return is_sure;
}

bool measureLanes(CoreKind a, CoreKind b, std::size_t count, PairRows& rows) {
  if (a == CoreKind::box) {
    return measureCores<BoxCore, BoxCore>(count, rows);
  }
  if (a == CoreKind::segment) {
    return b == CoreKind::box ? measureCores<SegmentCore, BoxCore>(count, rows)
                              : measureCores<SegmentCore, SegmentCore>(count, rows);
  }
  if (b == CoreKind::box) {
    return measureCores<PointCore, BoxCore>(count, rows);
  }
  return b == CoreKind::segment ? measureCores<PointCore, SegmentCore>(count, rows)
                                : measureCores<PointCore, PointCore>(count, rows);
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace collision_monitor
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace collision_monitor {
namespace {

HWY_EXPORT(measureLanes);

/// Repeats the last row in the rows after it that share its vector and are read too.
void repeatLastRow(CoreKind kind, std::size_t count, ShapeRows& rows) noexcept {
  constexpr std::size_t kMostLanes = 8;
  const std::size_t end = (count + kMostLanes - 1) / kMostLanes * kMostLanes;
  if (end == count) {
    return;
  }
  for (std::size_t c = 0; c < columnCountOf(kind); ++c) {
    std::fill(rows.at[c].begin() + count, rows.at[c].begin() + end, rows.at[c][count - 1]);
  }
}

}  // namespace

void measureRows(CoreKind a, CoreKind b, std::size_t count, PairRows& rows) noexcept {
  if (count == 0) {
    return;
  }
  repeatLastRow(a, count, rows.a);
  repeatLastRow(b, count, rows.b);
  if (!HWY_DYNAMIC_DISPATCH(measureLanes)(a, b, count, rows)) {
    finishRows(a, b, count, rows);
  }
}

}  // namespace collision_monitor
#endif
