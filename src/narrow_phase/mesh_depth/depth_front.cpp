// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/mesh_depth/depth_front.h"

#include <algorithm>
#include <limits>
#include <tuple>

#include "collision_monitor/geometry/ids.h"

namespace collision_monitor {
namespace {

constexpr KeptDepth::Place kWholeMesh{0, kNone, std::numeric_limits<double>::infinity()};

std::uint32_t roomIn(const KeptDepth::Side& side) noexcept {
  return KeptDepth::kCapacity - side.passed_over - side.open_count;
}

}  // namespace

void restart(bool is_deep_anywhere, KeptDepth::Side& side) noexcept {
  side.passed_over = side.open_count = 0;
  side.is_whole = true;
  side.highest = -std::numeric_limits<double>::infinity();
  if (is_deep_anywhere) {
    putFirst(kWholeMesh, side);
  }
}

void recall(double least, KeptDepth::Side& side) noexcept {
  if (!(side.highest > least)) {
    return;
  }
  const std::uint32_t others = side.open_count;
  side.highest = -std::numeric_limits<double>::infinity();
  for (std::uint32_t i = 0; i < side.passed_over;) {
    const KeptDepth::Place place = side.places[i];
    if (place.limit > least) {
      side.places[i] = side.places[--side.passed_over];
      putFirst(place, side);
    } else {
      side.highest = std::max(side.highest, place.limit);
      ++i;
    }
  }
  std::sort(side.places.end() - side.open_count, side.places.end() - others,
            [](const KeptDepth::Place& one, const KeptDepth::Place& other) {
              return std::tie(one.limit, other.bound) > std::tie(other.limit, one.bound);
            });
}

KeptDepth::Place takeNext(KeptDepth::Side& side) noexcept {
  return side.places[KeptDepth::kCapacity - side.open_count--];
}

void putFirst(const KeptDepth::Place& place, KeptDepth::Side& side) noexcept {
  side.places[KeptDepth::kCapacity - ++side.open_count] = place;
}

void makeRoom(std::uint32_t count, KeptDepth::Side& side) noexcept {
  if (roomIn(side) < count) {
    side.passed_over = 0;
    side.is_whole = false;
  }
  if (roomIn(side) < count) {
    side.open_count = 0;
    putFirst(kWholeMesh, side);
  }
}

void passOver(const KeptDepth::Place& place, KeptDepth::Side& side) noexcept {
  if (roomIn(side) > 0) {
    side.places[side.passed_over++] = place;
    side.highest = std::max(side.highest, place.limit);
  } else {
    side.is_whole = false;
  }
}

}  // namespace collision_monitor
