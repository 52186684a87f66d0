// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <memory>
#include <string>

#include "geometry/interruption.h"

namespace collision_monitor {

/// The whole monitor. Reads its parameters and the robots, follows tf on roscpp's network thread,
/// and runs cycles and answers services on threads of its own. Topics, services and parameters:
/// README.md and config/monitor.yaml.
class Monitor {
 public:
  /// Returns once the set-up is built and the cycle runs; may wait for robot descriptions.
  /// Diagnostics use `node_name`. A set-up, this one or that of a reload, is given up when ROS
  /// shuts down or `goes_on`, if not empty, returns false.
  /// @throws SetupError with every problem of parameters, URDFs and SRDFs.
  /// @throws Interrupted if the set-up was given up
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
