// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "motion/conservative_advancement.h"
#include "support/random_poses.h"

/// Bodies on random motions, for the laws of motion/ and their figures.
namespace collision_monitor::test {

/// Of decimetres.
Shape randomShape(Random& random);
/// Of every kind but a half space; decimetres, some of them thin.
ConvexGeometry randomGeometry(Random& random);

/// From within `reach` [m], travelling up to `travel` [m] along each axis and turning up to `turn`
/// [rad].
ScrewMotion randomMotion(Random& random, double reach, double travel, double turn);

/// firstContact with scratch of its own and steps enough for any pair.
SweptContact meetConvex(const ConvexGeometry& a, const ScrewMotion& motion_a,
                        const ConvexGeometry& b, const ScrewMotion& motion_b,
                        double contact_distance = 0.0);

/// A thin plate that crosses another between two cycles: 1 to 5 mm thick, 0.1 m in one cycle (5 m/s
/// at 50 Hz), at a random slant and turning; it is clear at both ends, and its center passes
/// through the plane of the other plate, which stands still.
struct PlateCrossing {
  ConvexGeometry plate;
  ScrewMotion still;
  ConvexGeometry body;
  ScrewMotion crossing;
};
/// @param half_width [m] of the plate that stands still: all cross one of 0.3, one of 0.06 is as
/// often passed beside.
PlateCrossing randomCrossing(Random& random, double half_width = 0.3);

double distanceAt(const PlateCrossing& scene, double time);

/// The first of `count` even steps from 0 to 1 in which the plates overlap, or nothing: what
/// looking at every one of them shows. Where the distance of one step, and a speed that no point
/// exceeds, say that those after it are clear, these are not measured.
std::optional<int> firstOverlap(const PlateCrossing& scene, int count);

/// Whether firstOverlap is right: measures every step.
bool isAsEveryStepShows(const PlateCrossing& scene, int count);

}  // namespace collision_monitor::test
