// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "narrow_phase/mesh/mesh_distance.h"

namespace collision_monitor {

/// Finds the corner of a mesh that is farthest along a unit direction. Frames: world.
Eigen::Vector3d farthestAlong(const PlacedMesh& mesh, const Eigen::Vector3d& direction) noexcept;

}  // namespace collision_monitor
