// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/fitting/posed_shape.h"

namespace collision_monitor {

/// The smallest sphere that holds all points.
///
/// Error: the radius exceeds the least one only by rounding (1e-12 of it). It holds every point up
/// to rounding.
/// Limits: coincident, collinear and coplanar points are legal.
/// Source: Gaertner, "Fast and Robust Smallest Enclosing Balls" (1999): the farthest point enters
/// the support set of the ball. Departs from it: tries all subsets of the at most five candidates,
/// which needs no order of pivots and no recursion.
/// @pre at least one point; all finite.
PosedShape fitSphere(const Points& points);

}  // namespace collision_monitor
