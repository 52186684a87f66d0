// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "pipeline/answers/budget_use.h"
#include "pipeline/answers/carry_over.h"
#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/look_ahead/link_velocities.h"
#include "ros_edge/inputs/clock_watch.h"
#include "ros_edge/nearest_seen.h"
#include "ros_edge/parameters/monitor_setup.h"
#include "ros_edge/poses/pose_reader.h"
#include "ros_edge/prepared_message.h"
#include "ros_edge/unknowns.h"

namespace collision_monitor {

/// One set-up and everything that changes while it is monitored. For the cycle's thread.
struct Watch {
  /// @pre the stores outlive the watch
  Watch(std::shared_ptr<const MonitorSetup> fixed_parts, const TransformStore& store,
        const JointStore& joint_store);

  /// Updates poses and velocities. Does not throw: what cannot be read is unknown. If the clock has
  /// died, everything is stale.
  /// @return true when a stamp, or the status or part of a link changed.
  bool read(const ros::Time& now, const ClockState& clock_now);
  /// Forgets the poses, after time jumped.
  void forget();
  /// Runs one cycle. If links have come to be known beside others, first learns their pairs.
  void cycle() noexcept;
  /// Switches reporting off: listeners keep the verdicts that they last got.
  void pauseReporting();
  /// Switches reporting on: every difference from what listeners last got is a change.
  void resumeReporting();
  /// Finds out what can be taken over from the watch of `former`. For any thread.
  void planTakeOver(std::shared_ptr<const MonitorSetup> former);
  /// Does before a swap what would make the first cycle long: reads the poses, learns the pairs and
  /// judges them all. For any thread. The less the poses move until then, the shorter the cycle.
  void prepare(const ros::Time& now, const ClockState& clock_now);
  /// Continues what another watch has reported, its motion, and its measurements between robots,
  /// which it keeps no longer.
  /// @return pairs that the other checked and this one does not, and that were not clear
  std::vector<LinkPairIndex> takeOver(Watch& former);
  /// [s] Until the last muted pair is checked again; 0: none is muted.
  double mutedFor(RuleEnd now) const;
  /// What is unknown. @pre poses are judged
  const Unknowns& unknown() const;

  std::shared_ptr<const MonitorSetup> fixed;
  JointReader joints;
  PoseReader reader;  ///< reads `joints` too
  LinkPoses poses;
  VelocityTracker tracker;
  JointVelocities joint_velocities;
  CycleBuffers buffers;
  BudgetTally budget;
  ClockState clock;
  std::vector<Verdict> believed;  ///< by LinkPairIndex: what listeners last got, while switched off
  std::uint32_t pairs_ignored;    ///< as in State
  std::uint32_t pairs_muted;      ///< as in State
  std::optional<RuleEnd> last_mute;
  std::optional<PreparedMessage> new_objects;  ///< for the topic `objects`, if they have changed
  NearestSeen nearest;
  /// By robot, and by robot that a checked pair joins it to; the last of each is for links that no
  /// robot moves.
  std::vector<std::vector<bool>> is_checked_between;
  /// By LinkId, in the last cycle: the part of a link that is known beside others; else the link.
  std::vector<PartId> joined_to;
  /// By RobotId: it was there, at least in part, since it was taken in.
  std::vector<unsigned char> was_there;
  std::shared_ptr<const MonitorSetup> planned_from;  ///< `carried` is about this set-up
  CarryPlan carried;                                 ///< of use until the first cycle ends
  /// planMeasurements; empty: all pairs are measured anew
  std::vector<ElementPairIndex> new_element_pair_of;
  mutable Unknowns last_unknown;  ///< for unknown()

  const CycleSetup& setup() const noexcept { return fixed->setup; }

 private:
  /// Notes which links are joined to which parts. Objects follow what carries them.
  /// @return whether some have come to be known beside others since the last cycle
  bool noteJoined() noexcept;
  void forgetJoined() noexcept;
  void unlearnJoined(const Watch& former) noexcept;
  /// Notes which robots are absent, and whether that is excused.
  void noteAbsent() noexcept;
  void takeOverScales(const Watch& former);
  void holdNewPairs() noexcept;

  bool is_new_{false};  ///< took over from another watch, and has run no cycle since
};

/// Reads poses from the sources that the parameters name: tf, or joint states where they can place
/// links.
/// @pre the arguments outlive the reader
PoseReader makePoseReader(const MonitorSetup& setup, const TransformStore& store,
                          JointReader& joints);

/// Makes all known links stale and their velocities unknown, because time stands still.
/// @return true when the status of a link changed.
bool growStale(LinkPoses& poses) noexcept;

/// Counts of long steps between poses, since start.
struct StepCount {
  std::uint64_t over_cap{0};  ///< longer than StepLimit::at_poses
  std::uint64_t too_long{0};  ///< longer than StepLimit::on_way
};

/// Counts the step of the last cycle, if it had one.
void countStep(const SweepWork& work, StepCount& count) noexcept;

/// Contents of messages beside the results of the cycle.
struct CycleFacts {
  ros::Time now;
  bool is_enabled{true};
  double enabled_again_in{0.0};  ///< [s] while switched off
  double muted_for{0.0};         ///< [s] as in State
  std::uint64_t cycles{0};
  std::uint64_t overruns{0};
  StepCount steps;
  double cycle_time{0.0};  ///< [s]
};

}  // namespace collision_monitor
