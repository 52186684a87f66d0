// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <variant>

#include "narrow_phase/closed_form/core_distance.h"
#include "narrow_phase/distance.h"

namespace collision_monitor {
namespace {

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

// Calls `use` with the shape as a sphere, capsule or rounded box. Not std::visit, which may throw.
template <class Use>
SignedDistance withInflated(const Shape& shape, const Use& use) noexcept {
  static_assert(std::variant_size_v<Shape> == 4, "every kind of shape stands below");
  if (const auto* sphere = std::get_if<Sphere>(&shape)) {
    return use(*sphere);
  }
  if (const auto* capsule = std::get_if<Capsule>(&shape)) {
    return use(*capsule);
  }
  if (const auto* box = std::get_if<Box>(&shape)) {
    return use(RoundedBox{box->half_extents, 0.0});
  }
  return use(*std::get_if<RoundedBox>(&shape));
}

}  // namespace

SignedDistance distanceBetween(const Shape& a, const Pose& world_from_a, const Shape& b,
                               const Pose& world_from_b) noexcept {
  return withInflated(a, [&](const auto& inflated_a) noexcept {
    return withInflated(b, [&](const auto& inflated_b) noexcept {
      return inCanonicalOrder(inflated_a, world_from_a, inflated_b, world_from_b);
    });
  });
}

}  // namespace collision_monitor
