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

/// What happens between two cycles: each link's last pose and this one are joined by a screw
/// motion, and pairs that are apart in both are followed on the way.
namespace collision_monitor {

/// The longest step between two cycles in which no link can pass another unseen.
struct StepCap {
  double longest{std::numeric_limits<double>::infinity()};  ///< [s] infinity where nothing may pass
  LinkPairIndex pair{kNone};                                ///< that it is about
  bool is_exceeded{false};
};

/// Whether poses come often enough.
struct StepLimit {
  double step{0.0};  ///< [s] between the last two stamps that differed; 0: not known
  StepCap at_poses;  ///< if poses alone were looked at: by the thinnest bodies and their speeds
  StepCap on_way;    ///< with what is looked at: the same, unless CycleSetup::is_continuous
};

/// A pair of elements whose bodies met on the way.
struct SweepTask {
  ElementPairIndex pair{0};
  PairId bodies{};          ///< that met first
  double from{0.0};         ///< then; the elements were apart before
  SignedDistance measured;  ///< of the bodies
  std::uint32_t work{0};    ///< spent of the budget on this pair
};

/// What sweepPairs works with and tells, sized at set-up.
struct SweepWork {
  // By LinkId.
  std::vector<unsigned char> has_motion;  ///< known in the last cycle and in this one, in one part
  std::vector<ScrewMotion> link_motions;
  // [m] how far any point may have come since the last cycle.
  std::vector<double> body_travel;     ///< by BodyId
  std::vector<double> element_travel;  ///< by ElementId
  double elapsed{0.0};                 ///< [s] between the stamps of the last poses and these
  // The step before, of last_elapsed [s], by LinkId.
  std::vector<unsigned char> had_motion;
  std::vector<ScrewMotion> last_motions;
  double last_elapsed{0.0};  ///< 0: there was none
  StepLimit step;
  std::vector<SweepTask> tasks;
  std::vector<std::uint32_t> task_of;  ///< by ElementPairIndex: into tasks, or kNone
  std::size_t swept{0};                ///< these two as in CycleCounters
  std::size_t left{0};
  std::uint32_t budget{0};     ///< of steps, for elements
  std::uint32_t work_done{0};  ///< spent of it; not less than it where it did not suffice
};

SweepWork makeSweepWork(const CycleSetup& setup);

/// Fills `distances.passed`: contacts on the way of pairs that are not in contact now. A contact at
/// the very start of the way is that of the last cycle, and not told again.
///
/// Pairs farther apart than they can have come nearer are passed over; then moving spheres, then
/// the bodies are asked; then elements, unless they were so far apart at both ends that they cannot
/// have met between, with what refinePairs left of its budget. What that leaves open is told as a
/// contact of enclosing shapes: a budget that is too small can raise false alarms and hides
/// nothing. Error: contacts deeper than rounding are found; what is told as exact is within 1e-7 m
/// of contact_distance. Limits: of meshes, surfaces count, and a contact is told at touch where
/// contact_distance is negative.
/// @param memory what is known of elements at either end. @param refined what refinePairs did to
/// `distances`; its scratch is used.
void sweepPairs(const CycleSetup& setup, const RefineStore& memory, const RefineWork& refined,
                SweepWork& work, PairDistances& distances) noexcept;

}  // namespace collision_monitor
