// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/mesh_depth/mesh_way_out.h"

#include "narrow_phase/closed_form/core_distance.h"
#include "narrow_phase/mesh_depth/mesh_support.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

void tryWayOut(const PlacedMesh& a, const PlacedMesh& b, const Vector3d& direction,
               WayOut& shortest) noexcept {
  const double length = direction.dot(farthestAlong(a, direction) - farthestAlong(b, -direction));
  if (length < shortest.length) {
    shortest = {length, direction};
  }
}

}  // namespace

WayOut wayOut(const PlacedMesh& a, const PlacedMesh& b, const Vector3d& direction) noexcept {
  WayOut shortest;
  if (!isFinite(a.world_from_mesh) || !isFinite(b.world_from_mesh)) {
    return shortest;
  }
  const Vector3d between =
      b.world_from_mesh * b.tree.center() - a.world_from_mesh * a.tree.center();
  if (between.norm() > kNear) {
    tryWayOut(a, b, between.normalized(), shortest);
  }
  tryWayOut(a, b, direction, shortest);
  for (const Eigen::Matrix3d& axes : {a.world_from_mesh.rotation, b.world_from_mesh.rotation}) {
    for (Eigen::Index k = 0; k < 3; ++k) {
      tryWayOut(a, b, axes.col(k), shortest);
      tryWayOut(a, b, -axes.col(k), shortest);
    }
  }
  return shortest;
}

}  // namespace collision_monitor
