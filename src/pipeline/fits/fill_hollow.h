// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/fitting/fit_parts.h"
#include "collision_monitor/geometry/geometry.h"

namespace collision_monitor {

/// Fills the hollow of an open mesh with one more shape. Several shapes may lie along an open
/// surface as along a thin wall, and what is between them would meet none. The proof of the other
/// shapes stays valid. Adds no shape to closed meshes or where there is no hollow. Also stores the
/// openness of the mesh in the fit, which needs the same hierarchy.
/// Error: hollows narrower than 1/20 of the mesh may stay.
void fillHollow(const Geometry& geometry, const ShapeKinds& kinds, Fit& fit);

}  // namespace collision_monitor
