// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/geometry/shapes.h"
#include "narrow_phase/gjk/convex_pair.h"

/// Convex geometries as searches see them: a core, and the radius that inflates it.
namespace collision_monitor {

struct InflatedCore {
  ConvexCore core;
  double radius{0.0};
};

inline InflatedCore inflatedCoreOf(const Sphere& s) noexcept { return {{}, s.radius}; }
inline InflatedCore inflatedCoreOf(const Capsule& s) noexcept {
  return {{ConvexCore::Kind::box, {0.0, 0.0, s.half_length}}, s.radius};
}
inline InflatedCore inflatedCoreOf(const Box& s) noexcept {
  return {{ConvexCore::Kind::box, s.half_extents}};
}
inline InflatedCore inflatedCoreOf(const RoundedBox& s) noexcept {
  return {{ConvexCore::Kind::box, s.half_extents}, s.radius};
}
/// A cylinder of radius 0 is a segment, which has corners for a search to end on.
inline InflatedCore inflatedCoreOf(const Cylinder& s) noexcept {
  const auto kind = s.radius > 0.0 ? ConvexCore::Kind::cylinder : ConvexCore::Kind::box;
  return {{kind, {s.radius, s.radius, s.half_length}}};
}
inline InflatedCore inflatedCoreOf(const ConvexHull& hull) noexcept {
  return {{ConvexCore::Kind::hull, Eigen::Vector3d::Zero(), &hull}};
}

}  // namespace collision_monitor
