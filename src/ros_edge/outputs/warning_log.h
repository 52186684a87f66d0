// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <collision_monitor/PairWarning.h>
#include <ros/time.h>

#include <string>
#include <unordered_map>
#include <vector>

#include "ros_edge/threads/log_thread.h"
#include "ros_edge/watch.h"

namespace collision_monitor {

/// Logs what the topics say, at most once a second for each cause: a verdict of a link pair, or the
/// set of unknown links. Of many verdicts within a second some are logged, with all contacts; the
/// others are counted. By wall time, because a simulated clock may stand still.
class WarningLog {
 public:
  /// @pre the argument outlives the log
  explicit WarningLog(LogThread& log) : log_(log) {}
  void logChange(const PairWarning& warning, const ros::SteadyTime& now);
  /// Links that became unknown or known again since the last line. The first line comes after a
  /// second.
  void logUnknownLinks(const Watch& watch);
  /// Poses that are too rare for the speed of the links: at most every ten seconds; only once if
  /// continuous checks cover it.
  void logStep(const Watch& watch);
  /// Starts another set-up: links have other ids.
  void startWatch() { told_unknown_.clear(); }

 private:
  static constexpr std::size_t kFewKept = 1000;

  bool hasRoomFor(const PairWarning& warning, const ros::SteadyTime& now);
  /// Says a second later how many changes have no line.
  void tellLeftOut(const ros::SteadyTime& now);
  void forgetOld(const ros::SteadyTime& now);

  LogThread& log_;
  std::unordered_map<std::string, ros::SteadyTime> last_of_change_;  ///< by links and verdict
  std::size_t most_kept_{kFewKept};
  ros::SteadyTime burst_;    ///< when the second began that `lines_` counts
  std::size_t lines_{0};     ///< about pairs
  std::size_t left_out_{0};  ///< pairs without a line
  std::vector<LinkId> told_unknown_;
  ros::SteadyTime last_unknown_;
  ros::SteadyTime last_step_;
  bool has_told_cap_{false};
};

}  // namespace collision_monitor
