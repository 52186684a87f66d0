// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/broad_phase/sweep_and_prune.h"

#include <algorithm>
#include <limits>

namespace collision_monitor {

SweepAndPrune::SweepAndPrune(std::size_t body_count) : slot_in_active_(body_count, 0) {
  active_.reserve(body_count);
  for (EndPoints& axis : axes_) {
    axis.reserve(2 * body_count);
    for (std::uint32_t body = 0; body < body_count; ++body) {
      axis.push_back({0.0, body, false});
      axis.push_back({0.0, body, true});
    }
  }
}

void SweepAndPrune::findCandidates(const BodyBounds& bounds, const PairTable& table,
                                   std::vector<PairId>& candidates) noexcept {
  moveEndPoints(bounds);
  sortEndPoints();
  candidates.clear();
  active_.clear();
  for (const EndPoint& end : axes_[leastCrowdedAxis()]) {
    if (bounds.known[end.body] == 0) {
      break;  // unknown bodies stand at the end of every axis
    }
    if (end.is_max) {
      deactivate(end.body);
      continue;
    }
    for (const std::uint32_t other : active_) {
      PairId pair{};
      if (meets(bounds.boxes[end.body], bounds.boxes[other]) &&
          table.find(BodyId{end.body}, BodyId{other}, pair)) {
        candidates.push_back(pair);
      }
    }
    activate(end.body);
  }
  std::sort(candidates.begin(), candidates.end());
}

/// At one position an interval opens before another closes, so that touching ones overlap;
/// the body decides what is left, so that the order is total.
bool SweepAndPrune::standsBefore(const EndPoint& one, const EndPoint& other) noexcept {
  if (one.position != other.position) {
    return one.position < other.position;
  }
  if (one.is_max != other.is_max) {
    return other.is_max;
  }
  return one.body < other.body;
}

void SweepAndPrune::moveEndPoints(const BodyBounds& bounds) noexcept {
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    for (EndPoint& end : axes_[static_cast<std::size_t>(axis)]) {
      const Aabb& box = bounds.boxes[end.body];
      const double position = end.is_max ? box.max[axis] : box.min[axis];
      end.position =
          bounds.known[end.body] != 0 ? position : std::numeric_limits<double>::infinity();
    }
  }
}

void SweepAndPrune::sortEndPoints() noexcept {
  for (EndPoints& axis : axes_) {
    for (std::size_t i = 1; i < axis.size(); ++i) {
      const EndPoint moved = axis[i];
      std::size_t gap = i;
      for (; gap > 0 && standsBefore(moved, axis[gap - 1]); --gap) {
        axis[gap] = axis[gap - 1];
      }
      axis[gap] = moved;
    }
  }
}

/// The number of overlapping intervals of an axis is the sum, over its openings, of the
/// intervals open at that moment.
std::size_t SweepAndPrune::leastCrowdedAxis() const noexcept {
  std::size_t best_axis = 0;
  std::size_t fewest = std::numeric_limits<std::size_t>::max();
  for (std::size_t axis = 0; axis < axes_.size(); ++axis) {
    std::size_t overlaps = 0;
    std::size_t open = 0;
    for (const EndPoint& end : axes_[axis]) {
      if (end.is_max) {
        --open;
      } else {
        overlaps += open++;
      }
    }
    if (overlaps < fewest) {
      fewest = overlaps;
      best_axis = axis;
    }
  }
  return best_axis;
}

void SweepAndPrune::activate(std::uint32_t body) noexcept {
  slot_in_active_[body] = static_cast<std::uint32_t>(active_.size());
  active_.push_back(body);
}

void SweepAndPrune::deactivate(std::uint32_t body) noexcept {
  const std::uint32_t slot = slot_in_active_[body];
  active_[slot] = active_.back();
  slot_in_active_[active_[slot]] = slot;
  active_.pop_back();
}

}  // namespace collision_monitor
