// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <collision_monitor/ApplyObjects.h>
#include <collision_monitor/GetObjects.h>
#include <collision_monitor/SceneChange.h>
#include <ros/node_handle.h>
#include <ros/service_server.h>

#include <functional>
#include <memory>
#include <vector>

#include "ros_edge/inputs/inputs.h"
#include "ros_edge/parameters/monitor_setup.h"
#include "ros_edge/threads/change_locks.h"
#include "ros_edge/threads/service_queue.h"

namespace collision_monitor {

/// What the services of objects need from the monitor. Any thread may call these.
struct ObjectHooks {
  std::function<std::shared_ptr<const MonitorSetup>()> current_setup;
  /// Watches a set-up that differs in its objects alone.
  std::function<void(std::shared_ptr<const MonitorSetup>)> replace_world;
  GoesOn goes_on;
};

/// apply_objects and get_objects. A change is prepared on the
/// thread of the call, and the cycle only swaps it in.
class ObjectServices {
 public:
  /// @pre the inputs, the locks and the queues outlive the services.
  ObjectServices(const ros::NodeHandle& private_node, const Inputs& inputs, ObjectHooks hooks,
                 ChangeLocks& locks, ServiceQueue& quick, ServiceQueue& changes);

 private:
  std::vector<ObjectChange> read(const std::vector<SceneChange>& messages,
                                 SetupReport& report) const;
  bool apply(ApplyObjects::Request& request, ApplyObjects::Response& response);
  bool list(GetObjects::Request& request, GetObjects::Response& response);

  ros::NodeHandle private_node_;
  Inputs inputs_;
  ObjectHooks hooks_;
  ChangeLocks& locks_;
  ros::ServiceServer apply_objects_;
  ros::ServiceServer get_objects_;
};

}  // namespace collision_monitor
