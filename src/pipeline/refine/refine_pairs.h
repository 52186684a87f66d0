// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "collision_monitor/pipeline/setup.h"
#include "motion/conservative_advancement.h"
#include "pipeline/data/cycle_data.h"

namespace collision_monitor {

/// Scratch of exact measurements. It is large, and its content means nothing between them.
struct RefineScratch {
  ConvexWorkspace convex;
  MeshQueryMemory mesh;
};

/// A pair of elements to refine.
struct RefineTask {
  ElementPairIndex pair{0};
  std::uint32_t place{kNone};  ///< index into PairDistances::pairs of its nearest bodies
  double bound{std::numeric_limits<double>::infinity()};  ///< [m] the distance of these bodies
  std::uint32_t starved_cycles{0};                        ///< as PairMemory::starved_cycles
  std::uint32_t work{0};                                  ///< work done for this pair
  bool may_touch{false};  ///< the last measurement does not exclude a contact
  bool touches{false};    ///< decideContact found a contact
  /// [m] as ElementDistance::outside, where it was measured
  double outside{std::numeric_limits<double>::infinity()};
};

/// Inputs and results of refinePairs, sized at set-up.
struct RefineWork {
  RefineLimits limits;            ///< `distance` is not used
  std::vector<double> distances;  ///< [m] by CheckedLinkPair::limits: what is refined
  /// [m] Of a pair beyond this, a lower bound may be told instead of the distance. A cycle has
  /// none.
  double cutoff{std::numeric_limits<double>::infinity()};
  bool finds_nearest{false};  ///< the cutoff falls to each distance that is measured
  bool skips_robots{false};   ///< pairs of robots wait for what another set-up knows of them
  bool tells_all{true};       ///< somebody listens to the distances of all near pairs
  /// [m] By LinkPairIndex: if not all distances are told, one below this still is.
  std::vector<double> told_below;
  double elapsed{0.0};  ///< [s] between the stamps of the last poses and these; 0: unknown
  std::vector<RefineTask> tasks;
  std::vector<std::uint32_t> task_of;      ///< by ElementPairIndex: index into tasks, or kNone
  std::vector<unsigned char> is_measured;  ///< by ElementPairIndex: in this cycle
  std::vector<unsigned char> is_passed;    ///< by ElementPairIndex: scratch
  std::vector<double> nearest;             ///< by LinkPairIndex: [m] the least refined distance
  std::vector<Ball> balls;                 ///< by ElementId: ballOf
  std::unique_ptr<RefineScratch> scratch;
  std::size_t refined{0};  ///< these three as in CycleCounters
  std::size_t left{0};
  std::size_t work_done{0};
  std::size_t work_before{0};     ///< of the same budget, that refinePairs has done before
  std::size_t near_bodies{0};     ///< pairs of bodies that count; 0 while learning
  std::uint32_t depth_points{0};  ///< tried for the depth of each overlap, in a cycle
};

/// The work that a cycle may do on elements. It grows where poses come seldom: there is more time,
/// and more motion to follow. Where the boxes of many bodies meet, they take up to half of it.
std::uint32_t budgetOf(const RefineWork& work) noexcept;

RefineWork makeRefineWork(const CycleSetup& setup);

RefineStore makeRefineMemory(const CycleSetup& setup);

/// Measures the elements behind enclosing shapes that are within work.distances: each pair of
/// elements once, however many bodies it has. Pairs starved longest come first, then nearest ones,
/// until the budget is spent. Where enclosing shapes touch, contact is decided first for all pairs,
/// which takes less work than distances; the rest of the budget goes into distances. A complete
/// measurement of unchanged poses is reused. Pairs that the budget starves get the last measurement
/// minus the motion since, as a lower bound, if that is better than their shapes.
///
/// The last part of the budget goes into depths of overlapping meshes, which are followed from
/// cycle to cycle (depthOf).
///
/// A measured pair of elements keeps one entry in `distances`. Of two proven lower bounds the
/// larger stays. Pairs that are farther than a refined pair of their links and in no contact are
/// skipped.
/// Unless `work.tells_all`, a pair with a mesh need not be measured again. The bounds of its last
/// measurement are kept in two cases: the lower one is above 0, or the pair is still in contact and
/// has moved by less than half of its depth. PairDistance::shortfall tells so, and measureFully
/// measures those that matter. Error: as signedDistanceBetween and distanceBetween of meshes.
/// Depths of meshes are estimates (Quality::estimate), except of convex ones, which are measured by
/// their hulls. Limits: the last measurement may exceed the budget by the work of two convex
/// geometries.
void refinePairs(const CycleSetup& setup, const BodyPoses& body_poses, PairMemory& memory,
                 RefineWork& work, PairDistances& distances) noexcept;

}  // namespace collision_monitor
