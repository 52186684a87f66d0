// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/fitting/enclose.h"
#include "collision_monitor/fitting/posed_shape.h"
#include "collision_monitor/geometry/triangle_bvh.h"
#include "fitting/proofs/distance_grid.h"

namespace collision_monitor {

/// @throws std::invalid_argument when no kind is allowed.
void checkKinds(const ShapeKinds& kinds);

/// The measure by which candidates are compared. Units: metres.
double coarseness(const Overshoot& overshoot) noexcept;

/// The least coarse candidate. If several are nearly equal, the one with the cheapest distances.
/// @pre one candidate is of an allowed kind.
Enclosure chooseTightest(const std::vector<Enclosure>& candidates, const ShapeKinds& kinds);

inline PosedShape posedShapeOf(const Enclosure& enclosure) {
  return {enclosure.shape, enclosure.geometry_from_body};
}

/// The candidates, at most one of each kind, proven and measured.
std::vector<Enclosure> encloseCapsule(const Capsule& capsule);
std::vector<Enclosure> encloseCylinder(const Cylinder& cylinder);
/// Only allowed kinds, without those that are much coarser than the best.
std::vector<Enclosure> encloseMesh(const TriangleMesh& mesh, const ShapeKinds& kinds);
std::vector<Enclosure> encloseMesh(const TriangleMesh& mesh, const TriangleBvh& bvh,
                                   const DistanceGrid& grid, const ShapeKinds& kinds);

}  // namespace collision_monitor
