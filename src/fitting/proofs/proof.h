// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/fitting/posed_shape.h"

namespace collision_monitor {

/// An upper bound, valid in exact arithmetic, of how far any point lies outside the posed shape. A
/// value <= 0 proves that the shape encloses the points, and with them their convex hull.
///
/// The set is { R x + t : x in shape } with R and t exactly as stored. Let u be the unit round-off
/// 2^-53. The computed body coordinates R^T (p - t) err by at most (8 u + e) |p - t|, where e
/// bounds |R^T R - I|: a stored rotation is only orthonormal up to rounding. The signed distance is
/// 1-Lipschitz in these coordinates and computed within 8 u (|x| + |half extents| + radius). The
/// bound adds (32 u + 2 e) times the sum of these magnitudes to the largest computed distance.
/// Source: Higham, "Accuracy and Stability of Numerical Algorithms" (2002), sections 2.2 and 3.1.
///
/// Units: metres. @pre points and fit are finite.
double provenExcess(const PosedShape& fit, const Points& points) noexcept;

/// As above, for a solid cylinder around the body's z axis, centered at the body's origin.
///
/// The points of a cylinder that are farthest from a convex set lie on its rims. A rim point at
/// azimuth phi is beyond a core with half extents (a, b, l) by |(R |cos phi| - a)+| and |(R |sin
/// phi| - b)+| across. With c = min(a, b) the length of that vector is at most (R - c)+. Where both
/// parts are positive, its square R^2 - 2 R c (|cos phi| + |sin phi|) + 2 c^2 is largest where one
/// part ends; where one is positive, at phi = 0. So no sampling is needed.
/// @pre the pose of the fit is the identity.
double provenExcess(const PosedShape& fit, const Cylinder& cylinder) noexcept;

/// As above, for a capsule at the body's origin: a convex shape holds a ball if it holds its center
/// with the radius to spare.
/// @pre the pose of the fit is the identity.
double provenExcess(const PosedShape& fit, const Capsule& capsule) noexcept;

/// Grows the radius (for a box: the half extents) until provenExcess <= -margin.
/// @return the growth [m]; about 1e-15 of the size for a fit that was tight up to rounding.
double widenUntilProven(const Points& points, PosedShape& fit, double margin = 0.0);
double widenUntilProven(const Cylinder& cylinder, PosedShape& fit);
double widenUntilProven(const Capsule& capsule, PosedShape& fit);

}  // namespace collision_monitor
