// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/world/order_objects.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace collision_monitor {
namespace {

constexpr int kBits = 10;  // of each axis

/// The bits of a number, each followed by two zeros.
std::uint32_t spread(std::uint32_t number) noexcept {
  std::uint32_t bits = 0;
  for (int i = 0; i < kBits; ++i) {
    bits |= (number >> i & 1U) << (3 * i);
  }
  return bits;
}

}  // namespace

void orderByPlace(std::vector<const WorldObject*>& objects) {
  constexpr std::size_t kMany = 64;
  if (objects.size() < kMany) {
    return;
  }
  Eigen::Vector3d least = objects.front()->frame_from_object.translation;
  Eigen::Vector3d most = least;
  for (const WorldObject* object : objects) {
    least = least.cwiseMin(object->frame_from_object.translation);
    most = most.cwiseMax(object->frame_from_object.translation);
  }
  constexpr double kCells = (1U << kBits) - 1U;
  const double cell = std::max((most - least).maxCoeff(), 1e-9) / kCells;
  std::vector<std::pair<std::uint32_t, const WorldObject*>> places;
  for (const WorldObject* object : objects) {
    const Eigen::Vector3d place = (object->frame_from_object.translation - least) / cell;
    std::uint32_t code = 0;
    for (int axis = 0; axis < 3; ++axis) {
      code |= spread(static_cast<std::uint32_t>(place[axis])) << axis;
    }
    places.emplace_back(code, object);
  }
  std::stable_sort(places.begin(), places.end(),
                   [](const auto& one, const auto& other) { return one.first < other.first; });
  std::transform(places.begin(), places.end(), objects.begin(),
                 [](const auto& place) { return place.second; });
}

}  // namespace collision_monitor
