// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/search/pattern_lanes.h"

#include "geometry/lanes/lane_targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "fitting/search/pattern_lanes.cpp"
#include "hwy/foreach_target.h"
// The order matters: Highway first includes this file once for each target.
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace collision_monitor {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Floats = hn::CappedTag<float, 16>;
using Ints = hn::RebindToSigned<Floats>;
using FloatLanes = hn::Vec<Floats>;
using IntLanes = hn::Vec<Ints>;

FloatLanes placesAlong(const PatternRows& rows, const PatternFrame& frame, std::size_t axis,
                       std::size_t first) {
  const Floats tag;
  FloatLanes place = hn::Set(tag, frame.center[axis]);
  for (std::size_t k = 0; k < 3; ++k) {
    const FloatLanes fraction = hn::Load(tag, rows.fraction[k] + first);
    const FloatLanes outward = hn::Load(tag, rows.outward[k] + first);
    const FloatLanes in_core = hn::Mul(hn::Set(tag, frame.of_fraction[k][axis]), fraction);
    const FloatLanes around = hn::Mul(hn::Set(tag, frame.of_outward[k][axis]), outward);
    place = hn::Add(place, hn::Add(in_core, around));
  }
  return place;
}

FloatLanes between(FloatLanes low, FloatLanes high, FloatLanes share) {
  return hn::Add(low, hn::Mul(share, hn::Sub(high, low)));
}

/// Interpolates between the node at `node` and the next one along x.
FloatLanes alongX(const GridRows& grid, IntLanes node, FloatLanes share) {
  const Floats tag;
  return between(hn::GatherIndex(tag, grid.distance, node),
                 hn::GatherIndex(tag, grid.distance + 1, node), share);
}

FloatLanes distancesAt(const GridRows& grid, const FloatLanes* place) {
  const Floats tag;
  const Ints ints;
  FloatLanes share[3];
  FloatLanes squared[3];
  IntLanes cell[3];
  for (std::size_t k = 0; k < 3; ++k) {
    const FloatLanes at = hn::Min(hn::Max(place[k], hn::Zero(tag)), hn::Set(tag, grid.last[k]));
    const FloatLanes beyond = hn::Sub(place[k], at);
    cell[k] = hn::ConvertTo(ints, at);
    share[k] = hn::Sub(at, hn::ConvertTo(tag, cell[k]));
    squared[k] = hn::Mul(beyond, beyond);
  }
  const IntLanes next_y = hn::Set(ints, grid.size_x);
  const IntLanes next_z = hn::Set(ints, grid.size_xy);
  const IntLanes node =
      hn::Add(cell[0], hn::Add(hn::Mul(cell[1], next_y), hn::Mul(cell[2], next_z)));
  const IntLanes above = hn::Add(node, next_z);
  const FloatLanes near = between(alongX(grid, node, share[0]),
                                  alongX(grid, hn::Add(node, next_y), share[0]), share[1]);
  const FloatLanes far = between(alongX(grid, above, share[0]),
                                 alongX(grid, hn::Add(above, next_y), share[0]), share[1]);
  const FloatLanes inner = between(near, far, share[2]);
  const FloatLanes outside = hn::Add(hn::Add(squared[0], squared[2]), squared[1]);
  return hn::Add(inner, hn::Sqrt(outside));
}

void placeInLanes(const PatternRows& rows, const PatternFrame& frame, const GridRows& grid,
                  PatternPlaces& places) {
  const Floats tag;
  for (std::size_t first = 0; first < rows.count; first += hn::Lanes(tag)) {
    FloatLanes place[3];
    for (std::size_t k = 0; k < 3; ++k) {
      place[k] = placesAlong(rows, frame, k, first);
      hn::Store(place[k], tag, places.place[k] + first);
    }
    hn::Store(distancesAt(grid, place), tag, places.distance + first);
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
}  // namespace

void placePattern(const PatternRows& rows, const PatternFrame& frame, const GridRows& grid,
                  PatternPlaces& places) noexcept {
  HWY_DYNAMIC_DISPATCH(placeInLanes)(rows, frame, grid, places);
}

}  // namespace collision_monitor
#endif
