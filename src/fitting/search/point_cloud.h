// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "collision_monitor/fitting/posed_shape.h"

namespace collision_monitor {

/// Points moved and scaled so that their bounding box is centered and its half diagonal is 1. So
/// searches need no notion of size.
struct NormalisedPoints {
  Points points;
  Eigen::Vector3d center{Eigen::Vector3d::Zero()};
  double scale{0.0};  ///< 0 when all points coincide
};

NormalisedPoints normalise(const Points& points);

/// Unit vectors spread evenly over the sphere; always the same ones.
/// Source: Gonzalez, "Measurement of areas on a sphere using Fibonacci lattices" (2010).
Points spreadDirections(int count);

/// Rotations spread evenly; always the same ones.
/// Source: Alexa, "Super-Fibonacci Spirals: Fast, Low-Discrepancy Sampling of SO(3)" (2022).
std::vector<Eigen::Matrix3d> spreadRotations(int count);

/// A rotation whose columns are the points' principal axes (of their scatter about the mean).
Eigen::Matrix3d principalAxes(const Points& points);

/// The points that are farthest in one of the directions, each once: a few that represent all.
Points extremePoints(const Points& points, const Points& directions);

/// At most about a hundred of the points, which represent all while a search is still coarse.
Points representativesOf(const Points& points);

/// Points that include all corners of the hull, up to rounding: those outside a polytope of about a
/// hundred corners, and these corners. For flat sets, the corners of the hull.
/// Source: Akl, Toussaint, "A Fast Convex Hull Algorithm" (1978), for dropping inner points. The
/// hull itself costs too much: about 20 us per corner, more than all fits together.
Points outerPoints(const Points& points);

/// A rotation whose third column is `axis` (unit).
Eigen::Matrix3d rotationWithAxis(const Eigen::Vector3d& axis);

}  // namespace collision_monitor
