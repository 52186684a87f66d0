// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/fitting/overshoot.h"
#include "fitting/proofs/distance_grid.h"

namespace collision_monitor {

/// A point of a shape's surface in the geometry's frame, with its distance from the mesh.
struct MeasuredSample {
  Eigen::Vector3d point;
  double distance{0.0};  ///< [m] 0 inside the mesh
  double area{0.0};      ///< [m^2]
};

/// @param grid tells what lies inside; nullptr: nothing does.
std::vector<MeasuredSample> measureSamples(const PosedShape& fit, const TriangleBvh& mesh,
                                           const DistanceGrid* grid,
                                           const OvershootSampling& sampling);

/// The overshoot of one of several shapes, over its surface points that no other shape holds.
OvershootSum sumOutsideOthers(const std::vector<MeasuredSample>& samples, std::size_t own,
                              const std::vector<PosedShape>& shapes);

}  // namespace collision_monitor
