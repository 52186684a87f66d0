// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <type_traits>

#include "collision_monitor/narrow_phase/distance.h"
#include "narrow_phase/core_distance.h"

namespace collision_monitor {
namespace {

const Sphere& asSwept(const Sphere& shape) noexcept { return shape; }
const Capsule& asSwept(const Capsule& shape) noexcept { return shape; }
RoundedBox asSwept(const Box& shape) noexcept { return {shape.half_extents, 0.0}; }
const RoundedBox& asSwept(const RoundedBox& shape) noexcept { return shape; }

constexpr int rankOf(const Sphere*) noexcept { return 0; }
constexpr int rankOf(const Capsule*) noexcept { return 1; }
constexpr int rankOf(const RoundedBox*) noexcept { return 2; }

template <class A, class B>
SignedDistance inCanonicalOrder(const A& a, const Pose& world_from_a, const B& b,
                                const Pose& world_from_b) noexcept {
  if constexpr (rankOf(static_cast<const A*>(nullptr)) <= rankOf(static_cast<const B*>(nullptr))) {
    return distanceBetween(a, world_from_a, b, world_from_b);
  } else {
    return swapped(distanceBetween(b, world_from_b, a, world_from_a));
  }
}

}  // namespace

SignedDistance distanceBetween(const Shape& a, const Pose& world_from_a, const Shape& b,
                               const Pose& world_from_b) noexcept {
  return std::visit(
      [&](const auto& shape_a, const auto& shape_b) noexcept {
        return inCanonicalOrder(asSwept(shape_a), world_from_a, asSwept(shape_b), world_from_b);
      },
      a, b);
}

}  // namespace collision_monitor
