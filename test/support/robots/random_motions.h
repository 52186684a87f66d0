// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "motion/conservative_advancement.h"
#include "support/random_poses.h"

/// Bodies on random motions, for the laws of motion/ and their figures.
namespace collision_monitor::test {

/// Sizes of decimetres.
Shape randomShape(Random& random);
/// Any kind but a half space. Sizes of decimetres, some of them thin.
ConvexGeometry randomGeometry(Random& random);

/// Starts within `reach` [m], travels up to `travel` [m] along each axis and turns up to `turn`
/// [rad].
ScrewMotion randomMotion(Random& random, double reach, double travel, double turn);

/// firstContact with its own workspace and a budget that suffices for any pair.
SweptContact meetConvex(const ConvexGeometry& a, const ScrewMotion& motion_a,
                        const ConvexGeometry& b, const ScrewMotion& motion_b,
                        double contact_distance = 0.0);

/// A thin plate that crosses another one between two cycles. It is 1 to 5 mm thick, travels 0.1 m
/// in one cycle (5 m/s at 50 Hz) at a random slant, and turns. It is clear at both ends, and its
/// center passes through the plane of the other plate, which stands still.
struct PlateCrossing {
  ConvexGeometry plate;
  ScrewMotion still;
  ConvexGeometry body;
  ScrewMotion crossing;
};
/// @param half_width [m] of the plate that stands still: at 0.3 all plates cross it, at 0.06 about
/// half of them pass beside it.
PlateCrossing randomCrossing(Random& random, double half_width = 0.3);

double distanceAt(const PlateCrossing& scene, double time);

/// The first of `count` even steps from 0 to 1 in which the plates overlap, or none: the result of
/// measuring every step. Steps are skipped if the distance at one step and an upper bound of the
/// speed prove them clear.
std::optional<int> firstOverlap(const PlateCrossing& scene, int count);

/// Whether firstOverlap is right: measures every step.
bool isAsEveryStepShows(const PlateCrossing& scene, int count);

}  // namespace collision_monitor::test
