// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/warm_start/cylinder_from_warm_start.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "narrow_phase/closed_form/core_distance.h"
#include "narrow_phase/warm_start/follow_feature.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

// A closest point on A, the cylinder, that is proven.
struct ProvenClosest {
  ClosestOnCylinder closest;
  ClosestProof proof;
};

// Corners of the other core, in its frame.
struct Corners {
  std::array<Vector3d, 3> points;
  std::size_t size{0};

  void add(const Vector3d& point) noexcept {
    if (!has(point)) {
      points[size++] = point;
    }
  }
  void keep(std::size_t index) noexcept {
    points[0] = points[index];
    size = 1;
  }
  bool has(const Vector3d& point) const noexcept {
    return std::find(points.begin(), points.begin() + size, point) != points.begin() + size;
  }
};

// Which of the two cores counts as the cylinder, and which is followed.
struct Roles {
  const PlacedCore& cylinder;
  const PlacedCore& other;
  Vector3d ConvexWarmStart::Ends::*on_cylinder;
  Vector3d ConvexWarmStart::Ends::*on_other;
  bool is_swapped;  // the cylinder is B
};

// Of two cylinders, follows one that is nearest at its rim.
Roles castRoles(const PlacedCore& a, const PlacedCore& b, const ConvexWarmStart& warm) noexcept {
  using Warm = ConvexWarmStart;
  const bool follows_b =
      isSmooth(a.core) && (!isSmooth(b.core) || isOnRim(warm.ends[0].on_b, b.core.half_extents));
  if (follows_b) {
    return {a, b, &Warm::Ends::on_a, &Warm::Ends::on_b, false};
  }
  return {b, a, &Warm::Ends::on_b, &Warm::Ends::on_a, true};
}

bool findClosest(const Corners& corners, const PlacedPair& pair, const Vector3d& start,
                 double& share, ClosestOnCylinder& closest) noexcept {
  const auto& points = corners.points;
  share = 0.0;
  if (corners.size == 3) {
    return closestToFace(pair, points, closest);
  }
  closest = corners.size == 2 ? closestToEdge(pair, {points[0], points[1], start}, share)
                              : closestToCorner(pair, points[0]);
  return true;
}

// Goes from the corners of the last search to corners that a plane shows to be nearer.
bool followCorners(const PlacedPair& pair, Corners& corners, Vector3d start,
                   ProvenClosest& found) noexcept {
  constexpr int kMaxTries = 4;
  for (int i = 0; i < kMaxTries; ++i) {
    double share = 0.0;
    if (!findClosest(corners, pair, start, share, found.closest)) {
      return false;
    }
    found.proof = proveClosest(pair, found.closest);
    const bool is_at_end = corners.size == 2 && (share <= 0.0 || share >= 1.0);
    if (found.proof.is_proven) {
      if (is_at_end) {
        corners.keep(share < 0.5 ? 0 : 1);
      }
      return true;
    }
    if (!found.proof.is_apart) {
      return false;
    }
    const Vector3d next = cornerOf(pair.b, -directionIn(pair.b, found.proof.normal));
    if (corners.size == 3 || corners.has(next)) {
      return false;
    }
    corners.keep(share < 0.5 ? 0 : 1);
    corners.add(next);
    start = found.closest.on_cylinder;
  }
  return false;
}

// Side against side: follows the other's axis and subtracts its radius.
bool followAxis(const PlacedPair& pair, Vector3d& on_other, ProvenClosest& found) noexcept {
  const Vector3d& half_extents = pair.b.core.half_extents;
  double share = 0.5 + 0.5 * on_other.z() / half_extents.z();
  found.closest = closestToAxis(pair, share);
  found.proof = proveClosest(pair, found.closest, half_extents.x());
  const Vector3d toward = directionIn(pair.b, found.proof.normal);
  on_other = (2.0 * share - 1.0) * half_extents.z() * Vector3d::UnitZ() - half_extents.x() * toward;
  return found.proof.is_proven;
}

// The other core is a cylinder, too. Its last point tells rim from side.
bool followRound(const PlacedPair& pair, Vector3d& on_other, ProvenClosest& found) noexcept {
  if (!isOnRim(on_other, pair.b.core.half_extents)) {
    return followAxis(pair, on_other, found);
  }
  found.closest = closestToRim(pair, on_other);
  found.proof = proveClosest(pair, found.closest);
  return found.proof.is_proven;
}

bool follow(const Roles& roles, const PlacedPair& pair, ConvexWarmStart& warm,
            ProvenClosest& found) noexcept {
  if (isSmooth(pair.b.core)) {
    Vector3d on_other = warm.ends[0].*roles.on_other;
    if (!followRound(pair, on_other, found)) {
      return false;
    }
    warm.size = 1;
    warm.ends[0].*roles.on_other = on_other;
    return true;
  }
  Corners corners;
  for (std::size_t i = 0; i < warm.size; ++i) {
    corners.add(warm.ends[i].*roles.on_other);
  }
  const Vector3d start = warm.ends[0].*roles.on_cylinder;
  if (!followCorners(pair, corners, start, found)) {
    return false;
  }
  warm.size = static_cast<std::uint32_t>(corners.size);
  for (std::size_t i = 0; i < corners.size; ++i) {
    warm.ends[i].*roles.on_other = corners.points[i];
  }
  return true;
}

// The core of a sphere needs no search: outside of the cylinder its closest point is the answer.
bool findPoint(const PlacedPair& pair, ProvenClosest& found) noexcept {
  found.closest = closestToCorner(pair, Vector3d::Zero());
  found.proof = proveClosest(pair, found.closest);
  return found.proof.is_proven;
}

WarmStartDistance answer(const Roles& roles, const ProvenClosest& found) noexcept {
  const Pose& world_from_cylinder = roles.cylinder.world_from_core;
  const double distance = found.proof.distance;
  const Vector3d point = world_from_cylinder.translation +
                         turned(world_from_cylinder.rotation, found.closest.on_cylinder);
  const SignedDistance cores{distance, point, point + distance * found.proof.normal,
                             found.proof.normal};
  return {roles.is_swapped ? swapped(cores) : cores, false};
}

}  // namespace

bool isOnRim(const Vector3d& point, const Vector3d& half_extents) noexcept {
  constexpr double kNearly = 1.0 - 1e-9;
  return std::abs(point.z()) >= kNearly * half_extents.z() &&
         point.head<2>().norm() >= kNearly * half_extents.x();
}

std::optional<WarmStartDistance> cylinderFromWarmStart(const PlacedCore& a, const PlacedCore& b,
                                                       ConvexWarmStart& warm) noexcept {
  const Roles roles = castRoles(a, b, warm);
  const PlacedPair pair = makePlacedPair(roles.cylinder, roles.other);
  ProvenClosest found;
  if (isPoint(roles.other.core)) {
    return findPoint(pair, found) ? std::make_optional(answer(roles, found)) : std::nullopt;
  }
  if (warm.size == 0 || warm.size > 3 || !follow(roles, pair, warm, found)) {
    return std::nullopt;
  }
  for (std::size_t i = 0; i < warm.size; ++i) {
    warm.ends[i].*roles.on_cylinder = found.closest.on_cylinder;
  }
  return answer(roles, found);
}

}  // namespace collision_monitor
