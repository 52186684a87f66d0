// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/confirm_cylinder.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "narrow_phase/extreme_feature.h"
#include "narrow_phase/nearest_on_cylinder.h"
#include "narrow_phase/simplex.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

// A cylinder and the core that is followed, in the frame of the cylinder.
struct CylinderPair {
  const ConvexCore& cylinder;
  const ConvexCore& other;
  Pose cylinder_from_other;
  double size;  // [m] see ConvexPair::size
};

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

// By a support plane: less than its gap are only points off their cores. False too where the
// features are level, and the points might be others.
bool isProven(const CylinderPair& pair, const NearestPair& found, std::uint32_t& vertex) noexcept {
  const Eigen::Matrix3d& turn = pair.cylinder_from_other.rotation;
  const ExtremeFeature of_cylinder = extremeOf(pair.cylinder, found.normal, 0);
  const ExtremeFeature of_other = extremeOf(pair.other, -(turn.transpose() * found.normal), vertex);
  vertex = of_other.vertex;
  const double gap =
      found.normal.dot(pair.cylinder_from_other.translation) - of_cylinder.reach - of_other.reach;
  return found.distance > touchingDistance(pair.size) &&
         std::abs(found.distance - gap) <= smoothTolerance(pair.size) &&
         !areLevel(of_cylinder, Eigen::Matrix3d::Identity(), of_other, turn);
}

// The rim's point that is farthest towards a face, if it lies over it.
bool nearestToFace(const Corners& corners, const CylinderPair& pair, NearestPair& found) noexcept {
  std::array<Vector3d, 4> points;
  for (std::size_t i = 0; i < 3; ++i) {
    points[i] = pair.cylinder_from_other * corners.points[i];
  }
  Vector3d normal = (points[1] - points[0]).cross(points[2] - points[0]).normalized();
  normal = normal.dot(points[0]) < 0.0 ? Vector3d(-normal) : normal;
  std::uint32_t none = 0;
  const Vector3d rim_point = supportPoint(pair.cylinder, normal, none);
  for (Vector3d& point : points) {
    point -= rim_point;
  }
  NearestPoint nearest;
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
  const Vector3d from = pair.cylinder_from_other * corners.points[0];
  const Vector3d& half_extents = pair.cylinder.half_extents;
  if (corners.size == 1) {
    found = nearestPairOf(footOf(from, half_extents));
    return true;
  }
  const Vector3d edge = pair.cylinder_from_other.rotation * (corners.points[1] - corners.points[0]);
  share = std::max(0.0, std::min(1.0, edge.dot(start - from) / edge.squaredNorm()));
  found = nearestPairOf(footOfEdge(from, edge, half_extents, share));
  return true;
}

// From the corners of the last search to those a plane shows to be farther towards the cylinder.
bool followCorners(const CylinderPair& pair, Corners& corners, Vector3d start,
                   std::uint32_t& vertex, NearestPair& found) noexcept {
  constexpr int kMaxTries = 4;
  for (int i = 0; i < kMaxTries; ++i) {
    double share = 0.0;
    if (!nearestTo(corners, pair, start, share, found)) {
      return false;
    }
    if (isProven(pair, found, vertex)) {
      if (corners.size == 2 && (share <= 0.0 || share >= 1.0)) {
        corners.keep(share < 0.5 ? 0 : 1);
      }
      return true;
    }
    const Vector3d in_other = pair.cylinder_from_other.rotation.transpose() * -found.normal;
    const Vector3d next = supportPoint(pair.other, in_other, vertex);
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
  const Vector3d& half_extents = pair.other.half_extents;
  const Pose& from_other = pair.cylinder_from_other;
  const double height = std::copysign(half_extents.z(), on_other.z());
  const Rim rim{from_other * Vector3d(0.0, 0.0, height),
                half_extents.x() * from_other.rotation.leftCols<2>()};
  Eigen::Vector2d turn = on_other.head<2>().normalized();
  found = nearestPairOf(footOfRim(rim, pair.cylinder.half_extents, turn));
  on_other << half_extents.x() * turn, height;
  std::uint32_t none = 0;
  return isProven(pair, found, none);
}

// Side against side: the other's axis is followed, its radius taken off.
bool followAxis(const CylinderPair& pair, Vector3d& on_other, NearestPair& found) noexcept {
  const Vector3d& half_extents = pair.other.half_extents;
  const Pose& from_other = pair.cylinder_from_other;
  const Vector3d half_axis = half_extents.z() * from_other.rotation.col(2);
  double share = 0.5 + 0.5 * on_other.z() / half_extents.z();
  found = nearestPairOf(footOfEdge(from_other.translation - half_axis, 2.0 * half_axis,
                                   pair.cylinder.half_extents, share));
  found.distance -= half_extents.x();
  on_other = from_other.rotation.transpose() *
             (found.on_cylinder + found.distance * found.normal - from_other.translation);
  std::uint32_t none = 0;
  return isProven(pair, found, none);
}

// Which of the two is taken for the cylinder, and which is followed.
struct Roles {
  const PlacedCore& cylinder;
  const PlacedCore& other;
  Vector3d ConvexWarmStart::Ends::*on_cylinder;
  Vector3d ConvexWarmStart::Ends::*on_other;
  std::uint32_t ConvexWarmStart::*vertex_of_other;
  bool is_swapped;  // the cylinder is B
};

// Of two cylinders the one that is met at its rim is followed.
Roles castRoles(const PlacedCore& a, const PlacedCore& b, const ConvexWarmStart& warm) noexcept {
  using Warm = ConvexWarmStart;
  const bool follows_b =
      isSmooth(a.core) && (!isSmooth(b.core) || isOnRim(warm.ends[0].on_b, b.core.half_extents));
  if (follows_b) {
    return {a, b, &Warm::Ends::on_a, &Warm::Ends::on_b, &Warm::vertex_of_b, false};
  }
  return {b, a, &Warm::Ends::on_b, &Warm::Ends::on_a, &Warm::vertex_of_a, true};
}

bool follow(const Roles& roles, const CylinderPair& pair, ConvexWarmStart& warm,
            NearestPair& found) noexcept {
  if (isSmooth(pair.other)) {
    Vector3d on_other = warm.ends[0].*roles.on_other;
    const bool is_proven = isOnRim(on_other, pair.other.half_extents)
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
  if (!followCorners(pair, corners, start, warm.*roles.vertex_of_other, found)) {
    return false;
  }
  warm.size = static_cast<std::uint32_t>(corners.size);
  for (std::size_t i = 0; i < corners.size; ++i) {
    warm.ends[i].*roles.on_other = corners.points[i];
  }
  return true;
}

}  // namespace

bool confirmCylinder(const PlacedCore& a, const PlacedCore& b, ConvexWarmStart& warm,
                     SignedDistance& cores) noexcept {
  const Roles roles = castRoles(a, b, warm);
  const Pose& world_from_cylinder = roles.cylinder.world_from_core;
  const Pose cylinder_from_other = relativePose(world_from_cylinder, roles.other.world_from_core);
  const double size = reachOf(a.core) + reachOf(b.core) + cylinder_from_other.translation.norm();
  const CylinderPair pair{roles.cylinder.core, roles.other.core, cylinder_from_other, size};
  NearestPair found;
  if (!follow(roles, pair, warm, found)) {
    return false;
  }
  for (std::size_t i = 0; i < warm.size; ++i) {
    warm.ends[i].*roles.on_cylinder = found.on_cylinder;
  }
  const Vector3d on_cylinder = world_from_cylinder * found.on_cylinder;
  const Vector3d away = world_from_cylinder.rotation * found.normal;
  const Vector3d on_other = on_cylinder + found.distance * away;
  cores = {found.distance, on_cylinder, on_other, away};
  cores = roles.is_swapped ? swapped(cores) : cores;
  return true;
}

}  // namespace collision_monitor
