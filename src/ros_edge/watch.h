// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "pipeline/answers/budget_use.h"
#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/look_ahead/link_velocities.h"
#include "ros_edge/inputs/clock_watch.h"
#include "ros_edge/parameters/monitor_setup.h"
#include "ros_edge/poses/pose_reader.h"

namespace collision_monitor {

/// One set-up and what changes while it is watched. Belongs to the thread of the cycle.
struct Watch {
  /// @pre the stores outlive the watch
  Watch(std::shared_ptr<const MonitorSetup> fixed_parts, const TransformStore& store,
        const JointStore& joint_store);

  /// Brings poses and velocities up to date. Does not throw: what cannot be read is unknown, and
  /// all is old by a clock that has died.
  /// @return true when a stamp, or the status or part of a link changed.
  bool read(const ros::Time& now, const ClockState& clock_now);
  /// Forgets where links were: time jumped.
  void forget();
  /// One cycle; before it, what links that come to be known bring with them is learned.
  void cycle() noexcept;
  /// It is switched off: listeners go on believing what they were told.
  void pauseReporting();
  /// It is switched on again: what is not as listeners believe is a change.
  void resumeReporting();
  /// What another watch has reported is carried on by this one.
  /// @return pairs of the other that it checks no more, and that were not clear
  std::vector<LinkPairIndex> inheritVerdicts(const Watch& former);

  std::shared_ptr<const MonitorSetup> fixed;
  JointReader joints;
  PoseReader reader;  ///< reads `joints`, too
  LinkPoses poses;
  VelocityTracker tracker;
  JointVelocities joint_velocities;
  CycleBuffers buffers;
  BudgetTally budget;
  ClockState clock;
  std::vector<Verdict> believed;  ///< by LinkPairIndex, while it is switched off
  std::uint32_t pairs_ignored;    ///< as in State
  std::ptrdiff_t links_known{0};  ///< in the last cycle

  const CycleSetup& setup() const noexcept { return fixed->setup; }
};

/// Reads poses as the parameters say: from tf, or from joint states where they can place links.
/// @pre all outlive the reader
PoseReader makePoseReader(const MonitorSetup& setup, const TransformStore& store,
                          JointReader& joints);

/// All that was known is stale, how fast it moved unknown: time stands still.
/// @return true when the status of a link changed.
bool growStale(LinkPoses& poses) noexcept;

/// Steps between poses since start.
struct StepCount {
  std::uint64_t over_cap{0};  ///< longer than StepLimit::at_poses
  std::uint64_t too_long{0};  ///< longer than StepLimit::on_way
};

/// Counts the step of the last cycle, if it came with one.
void countStep(const SweepWork& work, StepCount& count) noexcept;

/// What messages say beside the result of the cycle.
struct CycleFacts {
  ros::Time now;
  bool is_enabled{true};
  double enabled_again_in{0.0};  ///< [s] while switched off
  std::uint64_t cycles{0};
  std::uint64_t overruns{0};
  StepCount steps;
  double cycle_time{0.0};  ///< [s]
};

/// Links that keep a checked pair unknown, into `links`: those of it that do not stand in the
/// MainPart.
/// @pre poses are judged
void findUnknownLinks(const Watch& watch, std::vector<LinkId>& links);

}  // namespace collision_monitor
