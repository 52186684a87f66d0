// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <collision_monitor/CheckStates.h>
#include <collision_monitor/CheckTrajectory.h>
#include <collision_monitor/ExplainPair.h>
#include <collision_monitor/GetDistances.h>
#include <collision_monitor/SetLimits.h>
#include <collision_monitor/SetPairs.h>
#include <ros/node_handle.h>
#include <ros/service_server.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <functional>
#include <memory>
#include <vector>

#include "ros_edge/inputs/inputs.h"
#include "ros_edge/parameters/monitor_setup.h"
#include "ros_edge/poses/newest_state.h"
#include "ros_edge/robots/late_robots.h"
#include "ros_edge/services/explain_pair.h"
#include "ros_edge/services/rule_clock.h"
#include "ros_edge/threads/change_locks.h"
#include "ros_edge/threads/log_thread.h"
#include "ros_edge/threads/repeater.h"
#include "ros_edge/threads/service_queue.h"
#include "ros_edge/world/object_services.h"

namespace collision_monitor {

/// What the services need from the monitor. Any thread may call these.
struct ServiceHooks {
  std::function<std::shared_ptr<const MonitorSetup>()> current_setup;
  std::function<void(std::shared_ptr<const MonitorSetup>)> replace_setup;
  /// Watches a set-up that differs in its objects, rules or limits alone.
  std::function<void(std::shared_ptr<const MonitorSetup>)> change_setup;
  PairViewer view_pair;
  std::function<void(bool)> set_enabled;
  std::function<int()> network_priority;  ///< as for ServiceQueue
  GoesOn goes_on;                         ///< whether long calls may continue
};

/// All services. They do not touch the cycle's data. Rules that end by themselves end on a thread
/// of their own, however long other calls take. The two checks may take seconds: they run one after
/// the other, and yield the processor to threads of normal priority. Changes may take seconds, too,
/// so questions do not wait for them.
class Services {
 public:
  /// @pre the inputs and the log outlive the services.
  Services(const ros::NodeHandle& private_node, const Inputs& inputs, ServiceHooks hooks,
           LogThread& log);
  ~Services();
  Services(const Services&) = delete;
  Services& operator=(const Services&) = delete;

 private:
  bool goesOn() const;
  /// Logs how much of a call is done, every two seconds. @return true while the call may continue
  std::function<bool(double)> tellProgress(const char* call) const;
  NewestState newestState(const MonitorSetup& current) const;
  bool getDistances(GetDistances::Request& request, GetDistances::Response& response);
  bool checkTrajectory(CheckTrajectory::Request& request, CheckTrajectory::Response& response);
  bool checkStates(CheckStates::Request& request, CheckStates::Response& response);
  bool explainPair(ExplainPair::Request& request, ExplainPair::Response& response);
  bool setPairs(SetPairs::Request& request, SetPairs::Response& response);
  bool setLimits(SetLimits::Request& request, SetLimits::Response& response);
  void endRules();
  LateHooks lateHooks();
  void takeInLate(const MonitorSetup& late, const MonitorSetup& former);
  void tellMissing(const MonitorSetup& former, const std::vector<ListedRobot>& listed);
  bool setEnabled(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response);
  bool reload(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);

  ros::NodeHandle private_node_;
  Inputs inputs_;
  ServiceHooks hooks_;
  LogThread& log_;  ///< for what is told under a lock: a console may stand still
  ChangeLocks locks_;
  std::size_t requests_{0};  ///< of set_pairs
  // The queues outlive their services.
  ServiceQueue quick_;
  ServiceQueue changes_;
  ServiceQueue background_;
  std::vector<ros::ServiceServer> servers_;
  ObjectServices objects_;
  // The last, since their threads use the others.
  RuleClock rule_clock_;
  LateRobots late_robots_;
  Repeater late_look_;
};

}  // namespace collision_monitor
