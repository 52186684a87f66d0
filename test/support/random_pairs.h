// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "collision_monitor/geometry/shapes.h"
#include "support/random_poses.h"

/// Random pairs of shapes for property tests, the comparison with FCL and the benchmark. The same
/// seed gives the same pairs.
namespace collision_monitor::test {

struct ShapePair {
  Shape a;
  Pose world_from_a;
  Shape b;
  Pose world_from_b;
};

enum class ShapeKind : unsigned char { sphere, capsule, box, rounded_box };

/// How near the two shapes are along the line between their closest points.
enum class Nearness : unsigned char {
  separated,    ///< gaps up to 10 m
  near,         ///< gaps and depths from 1 um to 1 mm
  touching,     ///< cores or surfaces that touch up to rounding
  overlapping,  ///< depths up to the whole size, sometimes concentric
};

/// The relative rotation of the shapes.
enum class Alignment : unsigned char {
  random,
  aligned,        ///< multiples of 90 degrees; centers often share coordinates
  near_parallel,  ///< aligned, plus an angle from 1e-16 to 1e-3 rad
};

constexpr ShapeKind kShapeKinds[] = {ShapeKind::sphere, ShapeKind::capsule, ShapeKind::box,
                                     ShapeKind::rounded_box};
constexpr Nearness kNearnesses[] = {Nearness::separated, Nearness::near, Nearness::touching,
                                    Nearness::overlapping};
constexpr Alignment kAlignments[] = {Alignment::random, Alignment::aligned,
                                     Alignment::near_parallel};

const char* nameOf(ShapeKind kind) noexcept;
const char* nameOf(Nearness nearness) noexcept;
const char* nameOf(Alignment alignment) noexcept;

struct PairRecipe {
  ShapeKind a{ShapeKind::sphere};
  ShapeKind b{ShapeKind::sphere};
  Nearness nearness{Nearness::separated};
  Alignment alignment{Alignment::random};
  double least_length{1e-3};      ///< [m] of half extents, half lengths and radii
  double greatest_length{5.0};    ///< [m] so no shape's core is longer than 10 m
  bool with_zero_lengths{false};  ///< every fifth length is 0
};

/// Lengths are log-uniform.
ShapePair randomPair(const PairRecipe& recipe, Random& random);

/// Text of the pair that pastes into a test.
std::string describe(const ShapePair& pair);

}  // namespace collision_monitor::test
