// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/fitting/fit_parts.h"
#include "collision_monitor/geometry/geometry.h"

namespace collision_monitor {

/// Several shapes about an open surface may lie along it as about a thin wall, and what is in the
/// hollow between them would meet none. Then one more shape fills it; the proof of the others
/// stays. No shape for closed meshes, and none where there is no hollow.
/// Notes the openness of the mesh in the fit, too, which asks the same hierarchy.
/// Error: hollows narrower than 1/20 of the mesh may be left.
void fillHollow(const Geometry& geometry, const ShapeKinds& kinds, Fit& fit);

}  // namespace collision_monitor
