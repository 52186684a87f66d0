// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "collision_monitor/pipeline/setup.h"
#include "motion/conservative_advancement.h"
#include "pipeline/data/cycle_data.h"

namespace collision_monitor {

/// Scratch of exact measurements. Large, and means nothing between them.
struct RefineScratch {
  ConvexWorkspace convex;
  MeshQueryMemory mesh;
};

/// A pair of elements that is to be refined.
struct RefineTask {
  ElementPairIndex pair{0};
  std::uint32_t place{0};           ///< in PairDistances: its nearest bodies
  double bound{0.0};                ///< [m] their distance
  std::uint32_t starved_cycles{0};  ///< as PairMemory::waited
  std::uint32_t work{0};            ///< spent of the budget on this pair
  /// [m] as ElementDistance::outside, where it was measured
  double outside{std::numeric_limits<double>::infinity()};
};

/// What refinePairs works with and tells, sized at set-up.
struct RefineWork {
  RefineLimits limits;
  double elapsed{0.0};  ///< [s] between the stamps of the last poses and these; 0: not known
  std::vector<RefineTask> tasks;
  std::vector<std::uint32_t> task_of;      ///< by ElementPairIndex: into tasks, or kNone
  std::vector<unsigned char> is_measured;  ///< by ElementPairIndex: in this cycle
  std::vector<unsigned char> is_passed;    ///< by ElementPairIndex: scratch of measureClosest
  std::vector<double> nearest;             ///< by LinkPairIndex: [m] the least refined distance
  std::vector<Ball> balls;                 ///< by ElementId: of what is measured
  std::unique_ptr<RefineScratch> scratch;
  std::size_t refined{0};  ///< these three as in CycleCounters
  std::size_t left{0};
  std::size_t work_done{0};
};

/// Of steps in a cycle. Where poses come seldom there is more time, and after a long way more to
/// do.
std::uint32_t budgetOf(const RefineWork& work) noexcept;

RefineWork makeRefineWork(const CycleSetup& setup);

RefineStore makeRefineMemory(const CycleSetup& setup);

/// Measures the geometries behind enclosing shapes that are within limits.distance of each other:
/// each pair of elements, however many bodies it has. Those that waited longest come first,
/// then the nearest, until the budget is spent. Where enclosing shapes are in contact it is first
/// decided for all pairs whether the geometries are, too, which takes fewer steps than their
/// distance; whatever budget is left then goes into distances. What stands as it was measured to
/// the end is not measured again; for the rest the last measurement holds less the motion since, as
/// a lower bound, where that is more than the enclosing shapes say.
///
/// What budget is left then goes into depths of meshes that overlap, which are followed from cycle
/// to cycle (depthOf).
///
/// A pair of elements that is measured keeps one entry in `distances`. Of proven lower bounds the
/// larger one stays. Pairs that cannot be the nearest of their links and are in no contact are
/// passed over: what is refined is nearer.
/// Error: as signedDistanceBetween and distanceBetween of meshes. Depths of meshes are estimates
/// (Quality::estimate), except of convex ones, which are measured by their hulls.
/// Limits: the last measurement may go beyond the budget by that of two convex geometries.
void refinePairs(const CycleSetup& setup, const BodyPoses& body_poses, PairMemory& memory,
                 RefineWork& work, PairDistances& distances) noexcept;

}  // namespace collision_monitor
