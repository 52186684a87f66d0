// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/parameters/monitor_setup.h"

#include <malloc.h>
#include <ros/console.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "ros_edge/parameters/fit_options.h"
#include "ros_edge/parameters/resource_loader.h"
#include "ros_edge/parameters/robot_descriptions.h"
#include "ros_edge/poses/transform_store.h"

namespace collision_monitor {
namespace {

/// Logs the progress of fitting if it takes long, as at a first start with large meshes.
FitProgress logLongFitting() {
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::seconds kBetween(3);
  return [next = Clock::now() + kBetween](const std::string& link, std::size_t done,
                                          std::size_t total) mutable {
    if (done < total && Clock::now() >= next) {
      next = Clock::now() + kBetween;
      ROS_INFO_STREAM("fitting shapes to link '" << link << "' (" << done + 1 << " of " << total
                                                 << ")");
    }
  };
}

}  // namespace

std::optional<RuleEnd> lastMuteOf(const MonitorSetup& setup) {
  std::optional<RuleEnd> last;
  for (const LinkPair& pair : setup.setup.link_pairs) {
    if (pair.reason == PairReason::muted) {
      const RuleEnd end = setup.rule_ends[pair.rule];
      last = last ? std::max(*last, end) : end;
    }
  }
  return last;
}

std::vector<std::string> jointTopics(const MonitorSetup& setup) {
  std::vector<std::string> topics(setup.setup.model.robots.size(), setup.parameters.joint_states);
  // An empty list means one robot.
  for (std::size_t i = 0; i < setup.parameters.robots.size(); ++i) {
    const std::string& own = setup.parameters.robots[i].joint_states;
    topics[i] = own.empty() ? topics[i] : own;
  }
  return topics;
}

std::vector<std::string> frameNames(const MonitorSetup& setup) {
  std::vector<std::string> names{setup.world_frame};
  for (const Link& link : setup.setup.model.links) {
    names.push_back(link.frame);
  }
  return names;
}

std::shared_ptr<const MonitorSetup> makeMonitorSetup(const ros::NodeHandle& private_node,
                                                     GoesOn goes_on) {
  const Interruptible interruptible(std::move(goes_on));
  SetupReport report;
  const std::string& where = private_node.getNamespace();
  XmlRpc::XmlRpcValue values;
  private_node.getParam(where, values);
  auto made = std::make_shared<MonitorSetup>();
  made->parameters = readParameters(values, where, report);
  // Faulty parameters may not even tell which robots to wait for.
  throwIfErrors(report);

  const ResourceLoader load_resource = makeResourceLoader(made->parameters.loading);
  const std::vector<RobotDescription> descriptions =
      loadDescriptions(private_node, made->parameters, load_resource, report);
  SetupOptions options = loadSetupOptions(made->parameters, load_resource, report);
  options.fit_progress = logLongFitting();
  throwIfErrors(report);

  made->descriptions = descriptions;
  made->setup = buildSetup(descriptions, load_resource, options);
  made->rule_ends.assign(made->setup.pair_rules.size(), kLasts);
  const RobotModel& model = made->setup.model;
  made->world_frame = stripLeadingSlash(made->parameters.world_frame.empty()
                                            ? model.link(model.robots.front().root).frame
                                            : made->parameters.world_frame);
  malloc_trim(0);  // reading and fitting free much memory that glibc would keep
  return made;
}

}  // namespace collision_monitor
