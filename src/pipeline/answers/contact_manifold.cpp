// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/answers/contact_manifold.h"

#include <type_traits>

#include "geometry/bvh/visit_held.h"
#include "narrow_phase/contact/hull_patch.h"
#include "narrow_phase/contact/manifold_points.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

/// @param direction unit normal that points away from the element.
std::optional<ContactPatch> patchOf(const Element& element, const Pose& world_from_element,
                                    const Vector3d& direction) noexcept {
  if (!element.convex) {
    return std::nullopt;
  }
  const auto find = [&](const auto& geometry) noexcept -> std::optional<ContactPatch> {
    if constexpr (std::is_convertible_v<decltype(geometry), Shape>) {
      return extremePatch(Shape(geometry), world_from_element, direction);
    } else if constexpr (!std::is_same_v<decltype(geometry), const HalfSpace&>) {
      return extremePatch(geometry, world_from_element, direction);
    } else {
      return std::nullopt;
    }
  };
  std::optional<ContactPatch> patch = visitHeld(find, *element.convex);
  for (std::size_t i = 0; patch && i < patch->size; ++i) {
    patch->corners[i] += element.padding * direction;
  }
  return patch;
}

}  // namespace

std::optional<ContactManifold> contactManifold(const CycleSetup& setup, const BodyPoses& body_poses,
                                               const PairDistance& distance) noexcept {
  const BodyPair& pair = setup.table[distance.pair];
  const Body& a = setup.bodies[index(pair.a)];
  const Body& b = setup.bodies[index(pair.b)];
  if (!distance.is_refined) {
    return manifoldBetween(a.shape, body_poses.world_from_body[index(pair.a)], b.shape,
                           body_poses.world_from_body[index(pair.b)], distance.measured);
  }
  const Vector3d& normal = distance.measured.normal_a_to_b;
  const auto patch_a = patchOf(setup.elements[index(a.element)],
                               body_poses.world_from_element[index(a.element)], normal);
  const auto patch_b = patchOf(setup.elements[index(b.element)],
                               body_poses.world_from_element[index(b.element)], -normal);
  return patch_a && patch_b ? std::optional(manifoldOf(*patch_a, *patch_b, distance.measured))
                            : std::nullopt;
}

}  // namespace collision_monitor
