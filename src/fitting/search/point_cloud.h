// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "collision_monitor/fitting/posed_shape.h"

namespace collision_monitor {

/// Points moved and scaled so that their bounding box is centered and its half diagonal is 1: the
/// searches then need no notion of size.
struct NormalisedPoints {
  Points points;
  Eigen::Vector3d center{Eigen::Vector3d::Zero()};
  double scale{0.0};  ///< 0 when all points coincide
};

NormalisedPoints normalise(const Points& points);

/// Unit vectors spread evenly over the sphere; the same ones every time.
/// Source: Gonzalez, "Measurement of areas on a sphere using Fibonacci lattices" (2010).
Points spreadDirections(int count);

/// Rotations spread evenly over all; the same ones every time.
/// Source: Alexa, "Super-Fibonacci Spirals: Fast, Low-Discrepancy Sampling of SO(3)" (2022).
std::vector<Eigen::Matrix3d> spreadRotations(int count);

/// Columns are the principal axes of the points (of their scatter about the mean), a rotation.
Eigen::Matrix3d principalAxes(const Points& points);

/// The points that are farthest in one of the directions, each once: a few that stand for all.
Points extremePoints(const Points& points, const Points& directions);

/// At most about a hundred of the points, which stand for all while a search is still coarse.
Points representativesOf(const Points& points);

/// Points among which all corners of the hull are, up to rounding: those outside a polytope with
/// about a hundred corners, and these. Of flat sets, the corners of the hull.
/// Source: Akl, Toussaint, "A Fast Convex Hull Algorithm" (1978), for throwing away what is inside;
/// the hull itself is not worth its price (about 20 us a corner, more than all fits together).
Points outerPoints(const Points& points);

/// Any rotation whose third column is `axis` (unit).
Eigen::Matrix3d rotationWithAxis(const Eigen::Vector3d& axis);

}  // namespace collision_monitor
