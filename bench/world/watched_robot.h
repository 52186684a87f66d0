// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <collision_monitor/SceneChange.h>

#include <memory>
#include <string>
#include <vector>

#include "ros_edge/watch.h"

namespace collision_monitor::bench {

/// [ms] What a change of objects takes, in the order in which the node does it.
struct ChangeTimes {
  double read{0.0};      ///< from messages
  double checked{0.0};   ///< applyChanges
  double made{0.0};      ///< the set-up
  double buffered{0.0};  ///< the buffers of its watch
  double prepared{0.0};  ///< poses read, pairs learnt, carry-over planned
  double swapped{0.0};   ///< between two cycles
  double cpu{0.0};       ///< of all threads, for all of it: the same on a machine with other work

  double all() const { return read + checked + made + buffered + prepared + swapped; }
};

/// A robot of the shared data that stands still, watched as by the node but without a ROS master.
class WatchedRobot {
 public:
  /// @throws SetupError
  explicit WatchedRobot(const std::string& name);

  /// Makes the changes, as the service apply_objects.
  /// @throws SetupError, and then nothing has changed
  ChangeTimes change(const std::vector<SceneChange>& changes);

  /// [ms] One cycle.
  double cycle();

  const Watch& watch() const { return *watch_; }
  /// The name of its last link, which may have no shapes.
  std::string lastLink() const { return setup_->robots->model.links.back().name; }

 private:
  void place();

  TransformStore transforms_;
  JointStore joints_;
  ClockWatch clock_;
  std::shared_ptr<const MonitorSetup> setup_;
  std::unique_ptr<Watch> watch_;
};

}  // namespace collision_monitor::bench
