// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "collision_monitor/broad_phase/body_bounds.h"
#include "collision_monitor/broad_phase/pair_table.h"

namespace collision_monitor {

/// Sweep and prune on three axes. The end points of every axis stay sorted from one call to the
/// next and are sorted again by insertion, near linear while motion is coherent. The axis on
/// which the fewest intervals overlap is then swept with a list of active intervals, and
/// each meeting is confirmed on the other axes.
///
/// Source: Cohen, Lin, Manocha, Ponamgi, "I-COLLIDE: an interactive and exact collision
/// detection system for large-scale environments" (1995), section 4. Departs from it in sweeping
/// one axis anew instead of keeping an overlap flag for each pair and axis: what one call answers
/// then never depends on an earlier one.
class SweepAndPrune {
 public:
  explicit SweepAndPrune(std::size_t body_count);

  /// As findCandidates of broad_phase.h.
  /// @pre bounds hold as many bodies as the constructor was told.
  void findCandidates(const BodyBounds& bounds, const PairTable& table,
                      std::vector<PairId>& candidates) noexcept;

 private:
  struct EndPoint {
    double position;
    std::uint32_t body;
    bool is_max;
  };
  using EndPoints = std::vector<EndPoint>;

  static bool standsBefore(const EndPoint& one, const EndPoint& other) noexcept;
  void moveEndPoints(const BodyBounds& bounds) noexcept;
  void sortEndPoints() noexcept;
  std::size_t leastCrowdedAxis() const noexcept;
  void activate(std::uint32_t body) noexcept;
  void deactivate(std::uint32_t body) noexcept;

  std::array<EndPoints, 3> axes_;
  std::vector<std::uint32_t> active_;          ///< bodies whose interval is open
  std::vector<std::uint32_t> slot_in_active_;  ///< by body
};

}  // namespace collision_monitor
