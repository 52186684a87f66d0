// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/narrow_phase/mesh_distance.h"

namespace collision_monitor {

/// The largest height of a mesh's corners along a unit direction. World frame.
double extentAlong(const PlacedMesh& mesh, const Eigen::Vector3d& direction) noexcept;

}  // namespace collision_monitor
