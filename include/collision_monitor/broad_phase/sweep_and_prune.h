// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "collision_monitor/broad_phase/body_bounds.h"
#include "collision_monitor/broad_phase/pair_table.h"

namespace collision_monitor {

/// Sweep and prune on three axes. The end points of every axis stay sorted from
/// one call to the next and are re-sorted by insertion, which is near linear
/// while motion is coherent; the axis with the fewest overlapping intervals is
/// then swept with a list of active intervals, and each meeting is confirmed on
/// the other axes.
///
/// Source: Cohen, Lin, Manocha, Ponamgi, "I-COLLIDE" (1995), section 4. Departs from it in
/// sweeping one axis anew instead of keeping overlap flags of all pairs: the
/// pair table is small and the sweep needs no memory per pair.
class SweepAndPrune {
 public:
  explicit SweepAndPrune(std::size_t body_count);

  /// As findCandidates of broad_phase.h.
  void findCandidates(const BodyBounds& bounds, const PairTable& table,
                      std::vector<PairId>& candidates) noexcept;

 private:
  struct EndPoint {
    double position;
    std::uint32_t body;
    bool is_min;
  };
  using Axis = std::vector<EndPoint>;

  void refresh(const BodyBounds& bounds) noexcept;
  std::size_t leastCrowdedAxis() const noexcept;

  Axis axes_[3];
  std::vector<std::uint32_t> active_;
};

}  // namespace collision_monitor
