// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <memory>
#include <string>

#include "geometry/interruption.h"

namespace collision_monitor {

/// The whole monitor: reads its parameters and the robots, follows tf on roscpp's network thread,
/// runs cycles on one of its own, answers services on the callback queue of the node handle and,
/// where they may take seconds, on a thread in the background. Topics, services and parameters:
/// README.md and config/monitor.yaml.
class Monitor {
 public:
  /// Returns when the set-up is built and the cycle runs; may wait for robot descriptions.
  /// `node_name` is what diagnostics call it. Set-ups, this one and those of reloads, are given up
  /// when ROS shuts down or `goes_on`, which may be empty, says no.
  /// @throws SetupError with every problem of parameters, URDFs and SRDFs.
  /// @throws Interrupted where the set-up was given up
  Monitor(const ros::NodeHandle& private_node, const std::string& node_name,
          const GoesOn& goes_on = {});
  ~Monitor();
  Monitor(const Monitor&) = delete;
  Monitor& operator=(const Monitor&) = delete;

 private:
  class Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace collision_monitor
