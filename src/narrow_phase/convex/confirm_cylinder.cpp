// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/convex/confirm_cylinder.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "narrow_phase/convex/nearest_on_cylinder.h"
#include "narrow_phase/convex/simplex.h"
#include "narrow_phase/core_distance.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

// A cylinder, which is A here, and the core that is followed, in the frame of the cylinder.
using CylinderPair = PlacedPair;

struct NearestPair {
  Vector3d on_cylinder;
  Vector3d normal;  // unit, away from the cylinder
  double distance;
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

NearestPair nearestPairOf(const CylinderFoot& foot) noexcept {
  const double distance = foot.away.norm();
  return {foot.on_cylinder, foot.away / distance, distance};
}

bool isProven(const CylinderPair& pair, const NearestPair& found) noexcept {
  return found.distance > touchingDistance(pair.size) &&
         isProven(pair, supportPlanes(pair, found.normal), found.distance,
                  smoothTolerance(pair.size));
}

// The rim's point that is farthest towards a face, if it lies over it.
bool nearestToFace(const Corners& corners, const CylinderPair& pair, NearestPair& found) noexcept {
  std::array<Vector3d, 4> points;
  for (std::size_t i = 0; i < 3; ++i) {
    points[i] = pair.b.world_from_core * corners.points[i];
  }
  Vector3d normal = (points[1] - points[0]).cross(points[2] - points[0]).normalized();
  normal = normal.dot(points[0]) < 0.0 ? Vector3d(-normal) : normal;
  std::uint32_t none = 0;
  const Vector3d rim_point = supportPoint(pair.a.core, normal, none);
  for (std::size_t i = 0; i < 3; ++i) {
    points[i] -= rim_point;
  }
  NearestOnSimplex nearest;
  if (!nearestInside(points, 3, nearest)) {
    return false;
  }
  found = {rim_point, normal, normal.dot(points[0])};
  return true;
}

bool nearestTo(const Corners& corners, const CylinderPair& pair, const Vector3d& start,
               double& share, NearestPair& found) noexcept {
  if (corners.size == 3) {
    return nearestToFace(corners, pair, found);
  }
  const Vector3d from = pair.b.world_from_core * corners.points[0];
  const Vector3d& half_extents = pair.a.core.half_extents;
  if (corners.size == 1) {
    found = nearestPairOf(footOf(from, half_extents));
    return true;
  }
  const Vector3d edge = pair.b.world_from_core.rotation * (corners.points[1] - corners.points[0]);
  share = std::max(0.0, std::min(1.0, edge.dot(start - from) / edge.squaredNorm()));
  found = nearestPairOf(footOfEdge(from, edge, half_extents, share));
  return true;
}

// From the corners of the last search to those a plane shows to be farther towards the cylinder.
bool followCorners(const CylinderPair& pair, Corners& corners, Vector3d start,
                   NearestPair& found) noexcept {
  constexpr int kMaxTries = 4;
  for (int i = 0; i < kMaxTries; ++i) {
    double share = 0.0;
    if (!nearestTo(corners, pair, start, share, found)) {
      return false;
    }
    if (isProven(pair, found)) {
      if (corners.size == 2 && (share <= 0.0 || share >= 1.0)) {
        corners.keep(share < 0.5 ? 0 : 1);
      }
      return true;
    }
    const Vector3d in_other = pair.b.world_from_core.rotation.transpose() * -found.normal;
    const Vector3d next = supportPoint(pair.b.core, in_other, pair.b.vertex);
    if (corners.size == 3 || corners.has(next)) {
      return false;
    }
    corners.keep(share < 0.5 ? 0 : 1);
    corners.add(next);
    start = found.on_cylinder;
  }
  return false;
}

bool isOnRim(const Vector3d& point, const Vector3d& half_extents) noexcept {
  constexpr double kNearly = 1.0 - 1e-9;
  return std::abs(point.z()) >= kNearly * half_extents.z() &&
         point.head<2>().norm() >= kNearly * half_extents.x();
}

// `on_other`: where the last search ended, and where this one does, in the frame of the other.
bool followRim(const CylinderPair& pair, Vector3d& on_other, NearestPair& found) noexcept {
  const Vector3d& half_extents = pair.b.core.half_extents;
  const Pose& from_other = pair.b.world_from_core;
  const double height = std::copysign(half_extents.z(), on_other.z());
  const Rim rim{from_other * Vector3d(0.0, 0.0, height),
                half_extents.x() * from_other.rotation.leftCols<2>()};
  Eigen::Vector2d turn = on_other.head<2>().normalized();
  found = nearestPairOf(footOfRim(rim, pair.a.core.half_extents, turn));
  on_other << half_extents.x() * turn, height;
  return isProven(pair, found);
}

// Side against side: the other's axis is followed, its radius taken off.
bool followAxis(const CylinderPair& pair, Vector3d& on_other, NearestPair& found) noexcept {
  const Vector3d& half_extents = pair.b.core.half_extents;
  const Pose& from_other = pair.b.world_from_core;
  const Vector3d half_axis = half_extents.z() * from_other.rotation.col(2);
  double share = 0.5 + 0.5 * on_other.z() / half_extents.z();
  found = nearestPairOf(footOfEdge(from_other.translation - half_axis, 2.0 * half_axis,
                                   pair.a.core.half_extents, share));
  found.distance -= half_extents.x();
  on_other = from_other.rotation.transpose() *
             (found.on_cylinder + found.distance * found.normal - from_other.translation);
  return isProven(pair, found);
}

// Which of the two is taken for the cylinder, and which is followed.
struct Roles {
  const PlacedCore& cylinder;
  const PlacedCore& other;
  Vector3d ConvexWarmStart::Ends::*on_cylinder;
  Vector3d ConvexWarmStart::Ends::*on_other;
  bool is_swapped;  // the cylinder is B
};

// Of two cylinders the one that is met at its rim is followed.
Roles castRoles(const PlacedCore& a, const PlacedCore& b, const ConvexWarmStart& warm) noexcept {
  using Warm = ConvexWarmStart;
  const bool follows_b =
      isSmooth(a.core) && (!isSmooth(b.core) || isOnRim(warm.ends[0].on_b, b.core.half_extents));
  if (follows_b) {
    return {a, b, &Warm::Ends::on_a, &Warm::Ends::on_b, false};
  }
  return {b, a, &Warm::Ends::on_b, &Warm::Ends::on_a, true};
}

bool follow(const Roles& roles, const CylinderPair& pair, ConvexWarmStart& warm,
            NearestPair& found) noexcept {
  if (isSmooth(pair.b.core)) {
    Vector3d on_other = warm.ends[0].*roles.on_other;
    const bool is_proven = isOnRim(on_other, pair.b.core.half_extents)
                               ? followRim(pair, on_other, found)
                               : followAxis(pair, on_other, found);
    if (is_proven) {
      warm.size = 1;
      warm.ends[0].*roles.on_other = on_other;
    }
    return is_proven;
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

}  // namespace

std::optional<ConfirmedDistance> confirmCylinder(const PlacedCore& a, const PlacedCore& b,
                                                 ConvexWarmStart& warm) noexcept {
  const Roles roles = castRoles(a, b, warm);
  const Pose& world_from_cylinder = roles.cylinder.world_from_core;
  const Pose cylinder_from_other = relativePose(world_from_cylinder, roles.other.world_from_core);
  const Pose origin;
  const PlacedCore cylinder{roles.cylinder.core, origin, roles.cylinder.vertex};
  const PlacedCore other{roles.other.core, cylinder_from_other, roles.other.vertex};
  const CylinderPair pair = makePlacedPair(cylinder, other);
  NearestPair found;
  if (!follow(roles, pair, warm, found)) {
    return std::nullopt;
  }
  for (std::size_t i = 0; i < warm.size; ++i) {
    warm.ends[i].*roles.on_cylinder = found.on_cylinder;
  }
  const Vector3d on_cylinder = world_from_cylinder * found.on_cylinder;
  const Vector3d away = world_from_cylinder.rotation * found.normal;
  const Vector3d on_other = on_cylinder + found.distance * away;
  const SignedDistance cores{found.distance, on_cylinder, on_other, away};
  return ConfirmedDistance{roles.is_swapped ? swapped(cores) : cores, false};
}

}  // namespace collision_monitor
