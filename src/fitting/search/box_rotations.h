// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "fitting/search/core_descent.h"

namespace collision_monitor {

/// The box with these axes (columns) that holds all points, in closed form: a core of radius 0.
TurnedCore boxWithAxes(const Eigen::Matrix3d& axes, const Points& points);

/// Rotations of small boxes, distinct and locally least, best first.
/// @pre the points are normalised; `count` >= 1.
std::vector<Eigen::Matrix3d> smallBoxRotations(const Points& points, std::size_t count);

/// One such rotation at a tenth of the cost. Its box has a side flush with an edge or face.
Eigen::Matrix3d roughBoxRotation(const Points& points);

/// The nearest locally least box.
Eigen::Matrix3d refineBoxRotation(const Eigen::Matrix3d& axes, const Points& points);

}  // namespace collision_monitor
