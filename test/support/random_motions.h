// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/motion/conservative_advancement.h"
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
/// at 50 Hz), at a random slant and turning; it is clear at both ends, and its centre passes
/// through the other plate.
struct PlateCrossing {
  ConvexGeometry plate;
  ScrewMotion still;
  ConvexGeometry body;
  ScrewMotion crossing;
};
PlateCrossing randomCrossing(Random& random);

}  // namespace collision_monitor::test
