// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "geometry/constants.h"
#include "motion/conservative_advancement.h"
#include "pipeline/pair_search/link_cover.h"
#include "pipeline/pair_search/pair_motion.h"

/// Bounds that hold for every state of a cell.
///
/// The links are seen from a frame F that stands somewhere in the chain: joints between A and F
/// move A, the others move B. What is proven in one frame holds in all, so the best is taken. A
/// split s is the number of joints that move A.
///
/// - Levers. A joint with a range of +-h about the middle moves a point at most 2 sin(h / 2) times
///   its distance from the axis, its lever (h itself for a prismatic joint). Joints farther out
///   increase the lever by what they move.
/// - Swept balls. A ball whose centre is l from the axis stays within a ball whose centre is
///   cos(h) l from it, on the same side, and whose radius is greater by sin(h) l; from a quarter
///   turn on, within one about the axis. Joints are applied one after the other, outermost first.
/// - A separating direction n. The gap along n of two points changes by at most
///   sum_i h_i |d_i| + 1/2 sum_ij h_i h_j D_ij. d_i is its derivative by joint i in the middle of
///   the cell, taken at each vertex. D_ij bounds second derivatives in the whole cell: the lever of
///   the joint that is farther from F.
///
/// Source: levers: Schwarzer, Saha, Latombe, "Adaptive Dynamic Collision Checking for Single and
/// Multiple Articulated Robots in Complex Environments" (2005), section IV. Direction: the mean
/// value form of second order, Moore, Kearfott, Cloud, "Introduction to Interval Analysis" (2009),
/// chapter 6.
/// Error: bounds hold in exact arithmetic; roundingOf allows for rounding.
namespace collision_monitor {

/// [m] What a gap must exceed to be proven: the threshold of touch, the error of distances, and
/// the rounding of poses, for chains of this length.
inline double roundingOf(double scale) noexcept { return 1e-8 + 1e-10 * scale; }

/// How far joints can move a ball of each side. World frame; metres.
struct Levers {
  std::vector<double> of_a, of_b;        ///< by joint: greatest distance of a point from its axis
  std::vector<double> moved_a, moved_b;  ///< by split: how far any point can move
  double travel{0.0};                    ///< how much nearer the balls' contents can come
};

/// Finds the levers of two balls at the middle of a cell.
void findLevers(const PlacedCell& placed, const Ball& a, const Ball& b, Levers& levers);

/// [m] How far one variable alone moves one side against the other.
double shareOf(const PlacedCell& placed, const Levers& levers, std::size_t variable) noexcept;

/// Balls of one side, swept. Scratch of areBallsApart.
struct SweptBalls {
  std::vector<Ball> balls;  ///< by split, then by ball
  std::size_t count{0};
};

struct SweepScratch {
  SweptBalls a;
  SweptBalls b;
};

/// Whether the balls of A are apart from those of B in the whole cell.
/// @param a in the frame of its link, as b
bool areBallsApart(const PlacedCell& placed, const std::vector<Ball>& a, const std::vector<Ball>& b,
                   double rounding, SweepScratch& scratch);

/// [m] Upper bound of the second-order terms, for the best split.
struct Curvature {
  std::size_t split{0};
  double total{kInfinity};
};

Curvature curvatureOf(const PlacedCell& placed, const Levers& levers) noexcept;

/// [m] Adds the part of the second-order terms that is due to each variable.
void addCurvatures(const PlacedCell& placed, const Levers& levers, std::size_t split,
                   std::vector<double>& of_variable) noexcept;

/// [m] A lower bound of the gap along a unit direction from A to B.
/// @param first_order by variable: how much the gap of the nearest points can change, for a choice
/// of the variable to cut
double gapAlong(const PlacedCell& placed, const Eigen::Vector3d& normal, const Curvature& curvature,
                const PointCover& a, const PointCover& b, std::vector<double>& first_order);

}  // namespace collision_monitor
