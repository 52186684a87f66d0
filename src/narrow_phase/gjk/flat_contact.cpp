// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/gjk/flat_contact.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "narrow_phase/closed_form/core_distance.h"
#include "narrow_phase/contact/hull_patch.h"
#include "narrow_phase/contact/manifold_points.h"
#include "narrow_phase/contact/patch.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

ContactPatch patchOf(const PlacedCore& placed, const Vector3d& direction) noexcept {
  const ConvexCore& core = placed.core;
  const Pose& pose = placed.world_from_core;
  switch (core.kind) {
    case ConvexCore::Kind::box:
      return extremePatch(Box{core.half_extents}, pose, direction, kLevelSine);
    case ConvexCore::Kind::cylinder:
      return extremePatch(Cylinder{core.half_extents.z(), core.half_extents.x()}, pose, direction,
                          kLevelSine);
    case ConvexCore::Kind::hull:
      return patchAt(placed.vertex, *core.hull, pose, direction, kLevelSine);
    case ConvexCore::Kind::triangle:
    case ConvexCore::Kind::part:
      return {};
  }
  return {};
}

// From A's witness point to the middle, in the plane of the contact.
Vector3d toMiddle(const ManifoldPoints& shared, const SignedDistance& cores) noexcept {
  const Vector3d across = perpendicularTo(cores.normal_a_to_b);
  const Vector3d up = cores.normal_a_to_b.cross(across);
  std::array<Eigen::Vector2d, kMaxClipped> corners;
  for (std::size_t i = 0; i < shared.size; ++i) {
    const Vector3d delta = shared.points[i].point_on_a - cores.point_on_a;
    corners[i] = {across.dot(delta), up.dot(delta)};
  }
  const Eigen::Vector2d middle = centroidOf(corners.data(), shared.size);
  return middle.x() * across + middle.y() * up;
}

}  // namespace

bool centerOnPatch(const PlacedPair& pair, const SupportPlanes& planes,
                   SignedDistance& cores) noexcept {
  if (!planes.may_be_level || !areLevel(pair, planes)) {
    return false;
  }
  const Vector3d& normal = cores.normal_a_to_b;
  // A curved core has a less accurate normal, so an edge may count as level while the face beside
  // it does not. Such edges do not face each other.
  const EdgeSlack slack{kLevelSine, kLevelSine * pair.size};
  const ManifoldPoints shared =
      facingPoints(patchOf(pair.a, normal), patchOf(pair.b, -normal), normal, slack);
  if (shared.size == 0) {
    return false;
  }
  cores.point_on_a += toMiddle(shared, cores);
  cores.point_on_b = cores.point_on_a + cores.distance * normal;
  return true;
}

void centerOnPatch(const PlacedCore& a, const PlacedCore& b, SignedDistance& cores) noexcept {
  const PlacedPair pair = makePlacedPair(a, b);
  centerOnPatch(pair, supportPlanes(pair, cores.normal_a_to_b), cores);
}

}  // namespace collision_monitor
