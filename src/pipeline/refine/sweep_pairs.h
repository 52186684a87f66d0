// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <vector>

#include "collision_monitor/geometry/ids.h"
#include "collision_monitor/pipeline/setup.h"
#include "motion/conservative_advancement.h"
#include "pipeline/data/cycle_data.h"
#include "pipeline/refine/refine_pairs.h"

/// Contacts between two cycles. A screw motion joins the last and the present pose of each link,
/// and pairs that are apart at both ends are followed along it.
namespace collision_monitor {

/// The longest time between two cycles in which no link can pass through another unseen.
struct StepCap {
  double longest{std::numeric_limits<double>::infinity()};  ///< [s] infinity if nothing can pass
  LinkPairIndex pair{kNone};                                ///< the pair that limits it
  bool is_exceeded{false};
};

/// Whether poses come often enough, if only poses or also motions are checked.
struct StepLimit {
  double step{0.0};  ///< [s] between the last two stamps that differed; 0: not known
  StepCap at_poses;  ///< if only poses are checked: by the thinnest bodies and speeds
  StepCap on_way;    ///< as checked: equal to at_poses unless CycleSetup::is_continuous
};

/// A pair of elements whose bodies met between two cycles.
struct SweepTask {
  ElementPairIndex pair{0};
  PairId bodies{};          ///< the bodies that met first
  double from{0.0};         ///< share of the motion at which they met; elements are apart before
  SignedDistance measured;  ///< between the bodies
  std::uint32_t work{0};    ///< work done for this pair
};

/// Inputs and results of sweepPairs, sized at set-up.
struct SweepWork {
  // By LinkId.
  std::vector<unsigned char> has_motion;  ///< known in the last cycle and now, in the same part
  std::vector<ScrewMotion> link_motions;
  // [m] Upper bounds of the travel of any point since the last cycle.
  std::vector<double> body_travel;     ///< by BodyId
  std::vector<double> element_travel;  ///< by ElementId
  double elapsed{0.0};                 ///< [s] between the stamps of the last poses and these
  // The motion before, which took last_elapsed [s], by LinkId.
  std::vector<unsigned char> had_motion;
  std::vector<ScrewMotion> last_motions;
  double last_elapsed{0.0};  ///< 0: unknown
  StepLimit step;
  std::vector<SweepTask> tasks;
  std::vector<std::uint32_t> task_of;  ///< by ElementPairIndex: index into tasks, or kNone
  std::size_t swept{0};                ///< this and `left` as in CycleCounters
  std::size_t left{0};
  std::uint32_t budget{0};     ///< work for elements
  std::uint32_t work_done{0};  ///< work done; at least `budget` if the budget did not suffice
};

SweepWork makeSweepWork(const CycleSetup& setup);

/// Fills `distances.passed`: contacts between the last cycle and this one of pairs that are not in
/// contact now. A contact at the very start belongs to the last cycle and is not reported again.
///
/// Skips pairs that are farther apart than their travel. Then follows moving spheres, then bodies,
/// then elements unless their gaps at both ends exclude a contact, within the budget that
/// refinePairs left. A pair that the budget starves is reported as a contact of enclosing shapes: a
/// budget that is too small can raise false alarms and hides nothing.
/// Error: finds contacts deeper than rounding; exact contacts are within 1e-7 m of
/// contact_distance. Limits: only surfaces of meshes count; they are reported at touch if
/// contact_distance is negative.
/// @param memory the measurements at either end. @param refined what refinePairs did to
/// `distances`; its scratch is used.
void sweepPairs(const CycleSetup& setup, const RefineStore& memory, const RefineWork& refined,
                SweepWork& work, PairDistances& distances) noexcept;

}  // namespace collision_monitor
