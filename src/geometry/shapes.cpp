// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/geometry/shapes.h"

#include <algorithm>
#include <cmath>

#include "geometry/bvh/visit_held.h"
#include "geometry/constants.h"

namespace collision_monitor {
namespace {

double signOf(double value) noexcept { return value < 0.0 ? -1.0 : 1.0; }

}  // namespace

Eigen::Vector3d coreHalfExtents(const Shape& shape) noexcept {
  struct {
    Eigen::Vector3d operator()(const Sphere&) const { return Eigen::Vector3d::Zero(); }
    Eigen::Vector3d operator()(const Capsule& s) const { return {0.0, 0.0, s.half_length}; }
    Eigen::Vector3d operator()(const Box& s) const { return s.half_extents; }
    Eigen::Vector3d operator()(const RoundedBox& s) const { return s.half_extents; }
  } half_extents;
  return visitHeld(half_extents, shape);
}

double radiusOf(const Shape& shape) noexcept {
  struct {
    double operator()(const Sphere& s) const { return s.radius; }
    double operator()(const Capsule& s) const { return s.radius; }
    double operator()(const Box&) const { return 0.0; }
    double operator()(const RoundedBox& s) const { return s.radius; }
  } radius;
  return visitHeld(radius, shape);
}

CoreKind coreKindOf(const Shape& shape) noexcept {
  struct {
    CoreKind operator()(const Sphere&) const { return CoreKind::point; }
    CoreKind operator()(const Capsule&) const { return CoreKind::segment; }
    CoreKind operator()(const Box&) const { return CoreKind::box; }
    CoreKind operator()(const RoundedBox&) const { return CoreKind::box; }
  } kind;
  return visitHeld(kind, shape);
}

const char* kindName(const Shape& shape) noexcept {
  struct {
    const char* operator()(const Sphere&) const { return "sphere"; }
    const char* operator()(const Capsule&) const { return "capsule"; }
    const char* operator()(const Box&) const { return "box"; }
    const char* operator()(const RoundedBox&) const { return "rounded_box"; }
  } name;
  return visitHeld(name, shape);
}

double volumeOf(const Shape& shape) noexcept {
  // Steiner's formula for a box inflated by a radius: V + S r + (pi / 4) E r^2 + (4/3) pi r^3,
  // where E is the total length of the twelve edges. Zero extents give the other shapes.
  const Eigen::Vector3d size = 2.0 * coreHalfExtents(shape);
  const double r = radiusOf(shape);
  const double surface = 2.0 * (size.x() * size.y() + size.y() * size.z() + size.z() * size.x());
  return size.prod() + surface * r + kPi * size.sum() * r * r + 4.0 / 3.0 * kPi * r * r * r;
}

Eigen::Vector3d supportPoint(const Shape& shape, const Eigen::Vector3d& direction) noexcept {
  const Eigen::Vector3d half_extents = coreHalfExtents(shape);
  Eigen::Vector3d point(signOf(direction.x()) * half_extents.x(),
                        signOf(direction.y()) * half_extents.y(),
                        signOf(direction.z()) * half_extents.z());
  const double length = direction.norm();
  if (length > 0.0) {
    point += radiusOf(shape) / length * direction;
  }
  return point;
}

double signedDistanceTo(const Shape& shape, const Eigen::Vector3d& point) noexcept {
  const Eigen::Vector3d beyond = point.cwiseAbs() - coreHalfExtents(shape);
  const double outside = beyond.cwiseMax(0.0).norm();
  const double inside = std::min(beyond.maxCoeff(), 0.0);
  return outside + inside - radiusOf(shape);
}

}  // namespace collision_monitor
