// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/mesh/part_gap.h"

#include "geometry/bvh/part_support.h"
#include "narrow_phase/gjk/gjk.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

bool isPart(const MeshTree& mesh, Slot slot) noexcept {
  const std::uint32_t child = childOf(mesh, slot);
  return child != kNone && !isTriangle(child) && !mesh.partCorners().of(child).empty();
}

ConvexCore partAt(const MeshTree& mesh, Slot slot) noexcept {
  ConvexCore core;
  core.kind = ConvexCore::Kind::part;
  core.mesh = &mesh;
  core.node = childOf(mesh, slot);
  return core;
}

ConvexPair partsAt(const MeshPair& pair, Slot a, Slot b) noexcept {
  ConvexPair parts;
  parts.a = partAt(pair.a, a);
  parts.b = partAt(pair.b, b);
  parts.a_from_b = pair.a_from_b;
  parts.size = reachOf(parts.a) + reachOf(parts.b) + pair.a_from_b.translation.norm();
  return parts;
}

Vector3d centerAt(const MeshTree& mesh, Slot slot) noexcept {
  return mesh.center() + boundAt(mesh, slot).center.cast<double>();
}

double errorOf(const MeshPair& pair) noexcept {
  return kPartError * (pair.a.radius() + pair.b.radius());
}

}  // namespace

bool areParts(const MeshPair& pair, Slot a, Slot b) noexcept {
  return isPart(pair.a, a) && isPart(pair.b, b);
}

double gapOfParts(const MeshPair& pair, Slot a, Slot b, const Vector3d& direction) noexcept {
  ConvexPair parts = partsAt(pair, a, b);
  return direction.dot(leastAlong(direction, parts).difference) / direction.norm() - errorOf(pair);
}

PartGap searchGapOfParts(const MeshPair& pair, Slot a, Slot b, double goal) noexcept {
  constexpr std::uint32_t kVisits = 4;
  constexpr double kBeyond = 1.02;  // a little more, for directions that are rounded
  ConvexPair parts = partsAt(pair, a, b);
  const double error = errorOf(pair);
  const Vector3d between = pair.a_from_b * centerAt(pair.b, b) - centerAt(pair.a, a);
  const GjkResult found = runGjk(parts, between, {kBeyond * (goal + error), goal + error});
  return {found.lower - error, found.lower_direction, kVisits};
}

}  // namespace collision_monitor
