// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/parameters/robot_descriptions.h"

#include <ros/names.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "collision_monitor/geometry/ids.h"
#include "geometry/interruption.h"
#include "ros_edge/name_beside.h"

namespace collision_monitor {
namespace {

/// A search uses the process's remappings only, not those of a nodelet. So a name that a nodelet
/// remaps is resolved first.
std::string nameForSearch(const ros::NodeHandle& node, const std::string& name) {
  if (ros::names::getUnresolvedRemappings().count(name) > 0) {
    return name;
  }
  const std::string plain = nameBeside(node, name);
  const std::string remapped = node.resolveName(plain, true);
  return remapped == node.resolveName(plain, false) ? name : remapped;
}

/// The parameter name that a search for `name` starts from. A search applies remappings, but not
/// the node's namespace.
std::string startOfSearch(const ros::NodeHandle& node, const std::string& name) {
  const ros::M_string& remapped = ros::names::getUnresolvedRemappings();
  const auto found = remapped.find(name);
  return node.resolveName(found == remapped.end() ? name : found->second, false);
}

/// By wall time: a simulated clock may not have started.
bool waitForParameter(const ros::NodeHandle& node, const std::string& name,
                      const ros::WallTime& deadline, std::string& text) {
  constexpr double kPollPeriod = 0.1;
  for (;;) {
    std::string resolved;
    if (node.searchParam(name, resolved) && node.getParam(resolved, text) && !text.empty()) {
      return true;
    }
    throwIfInterrupted();
    if (ros::WallTime::now() >= deadline) {
      return false;
    }
    ros::WallDuration(kPollPeriod).sleep();
  }
}

std::string readFile(const std::string& uri, const std::string& what, const std::string& robot,
                     const ResourceLoader& load_resource, SetupReport& report) {
  try {
    return load_resource(uri);
  } catch (const std::exception& fault) {
    report.errors.push_back({"robot '" + robot + "', " + what + " '" + uri + "'", fault.what(),
                             "a readable file or package:// URI"});
    return "";
  }
}

/// @param missing what is missing, if there is no URDF
RobotDescription fromParameter(const ros::NodeHandle& node, const RobotSource& robot,
                               const ros::WallTime& deadline, std::string& missing) {
  RobotDescription description;
  const std::string name = nameForSearch(node, robot.description);
  description.source = "parameter " + startOfSearch(node, name);
  if (waitForParameter(node, name, deadline, description.urdf_xml)) {
    std::string resolved;
    node.searchParam(name, resolved);
    description.source = "parameter " + resolved;
  } else {
    missing = "no URDF in " + description.source + " nor under the same name in a namespace above";
  }
  return description;
}

/// Where robots are loaded from, and where faults go.
struct Loading {
  const ros::NodeHandle& node;
  const Parameters& parameters;
  const ResourceLoader& load_resource;
  SetupReport& report;
};

RobotDescription fromFile(const RobotSource& robot, const ResourceLoader& load_resource,
                          SetupReport& report) {
  RobotDescription description;
  description.source = robot.file;
  description.urdf_xml = readFile(robot.file, "file", robot.name, load_resource, report);
  const std::size_t slash = robot.file.rfind('/');
  description.directory = slash == std::string::npos ? "" : robot.file.substr(0, slash);
  return description;
}

/// A named SRDF must exist. The default one beside robot_description is optional.
void addSemantic(const ros::NodeHandle& node, const RobotSource& robot, bool is_required,
                 RobotDescription& description, SetupReport& report) {
  if (robot.semantic.empty()) {
    return;
  }
  const std::string name = nameForSearch(node, robot.semantic);
  const std::string accepted = "a parameter that holds the text of an SRDF";
  std::string resolved;
  if (node.searchParam(name, resolved)) {
    description.srdf_source = "parameter " + resolved;
    if (!node.getParam(resolved, description.srdf_xml)) {
      report.errors.push_back(
          {"robot '" + robot.name + "'", "no text in parameter " + resolved, accepted});
    }
  } else if (is_required) {
    report.errors.push_back({"robot '" + robot.name + "'",
                             "no SRDF in parameter " + startOfSearch(node, name) +
                                 " nor under the same name in a namespace above",
                             accepted});
  }
}

/// The robots that the parameters name or, without a list, the one in robot_description.
std::vector<RobotSource> sourcesOf(const Parameters& parameters) {
  if (!parameters.robots.empty()) {
    return parameters.robots;
  }
  RobotSource robot;
  robot.name = "robot_description";
  robot.may_be_absent = false;  // there are no others
  robot.description = "robot_description";
  robot.semantic = "robot_description_semantic";
  return {robot};
}

void addRest(const Loading& from, const RobotSource& robot, RobotDescription& description) {
  addSemantic(from.node, robot, !from.parameters.robots.empty(), description, from.report);
  if (!robot.semantic_file.empty()) {
    description.srdf_source = robot.semantic_file;
    description.srdf_xml =
        readFile(robot.semantic_file, "semantic_file", robot.name, from.load_resource, from.report);
  }
  description.tf_prefix = robot.tf_prefix;
  description.obeys_up_axis = from.parameters.obey_up_axis;
  description.is_strict = from.parameters.is_strict;
  if (robot.file.empty()) {
    description.directory = from.parameters.mesh_directory;
  }
}

void loadRobot(const Loading& from, const RobotSource& robot, const ros::WallTime& deadline,
               LoadedRobots& loaded) {
  ListedRobot listed{robot.name, std::nullopt, "", robot.may_be_absent};
  RobotDescription description = robot.file.empty()
                                     ? fromParameter(from.node, robot, deadline, listed.missing)
                                     : fromFile(robot, from.load_resource, from.report);
  if (listed.missing.empty()) {
    addRest(from, robot, description);
    listed.id = idAt<RobotId>(loaded.descriptions.size());
    loaded.descriptions.push_back(std::move(description));
  }
  loaded.listed.push_back(std::move(listed));
}

LoadedRobots loadListed(const ros::NodeHandle& private_node, const Parameters& parameters,
                        const ResourceLoader& load_resource, double patience, SetupReport& report) {
  const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(patience);
  LoadedRobots loaded;
  for (const RobotSource& robot : sourcesOf(parameters)) {
    loadRobot({private_node, parameters, load_resource, report}, robot, deadline, loaded);
  }
  if (loaded.descriptions.empty()) {
    for (const ListedRobot& robot : loaded.listed) {
      report.errors.push_back({"robot '" + robot.name + "'", robot.missing,
                               "a parameter that holds the text of a URDF"});
    }
  }
  return loaded;
}

}  // namespace

LoadedRobots loadDescriptions(const ros::NodeHandle& private_node, const Parameters& parameters,
                              const ResourceLoader& load_resource, SetupReport& report) {
  const bool are_good = report.errors.empty();
  const std::string list = parameters.setup.where + "robots";
  if (std::any_of(report.errors.begin(), report.errors.end(), [&](const Problem& fault) {
        return fault.where.compare(0, list.size(), list) == 0;
      })) {
    return {};
  }
  SetupReport of_robots;
  LoadedRobots loaded = loadListed(private_node, parameters, load_resource,
                                   are_good ? parameters.wait_for_description : 0.0, of_robots);
  const bool are_there = std::all_of(loaded.listed.begin(), loaded.listed.end(),
                                     [](const ListedRobot& robot) { return robot.id.has_value(); });
  if (!are_good && !are_there) {
    return {};  // nobody has waited for them
  }
  report.errors.insert(report.errors.end(), of_robots.errors.begin(), of_robots.errors.end());
  return of_robots.errors.empty() ? loaded : LoadedRobots();
}

LoadedRobots loadLate(const ros::NodeHandle& private_node, const Parameters& parameters,
                      const ResourceLoader& load_resource, const LoadedRobots& former,
                      std::optional<std::size_t> only, SetupReport& report) {
  const std::vector<RobotSource> sources = sourcesOf(parameters);
  LoadedRobots loaded;
  for (std::size_t i = 0; i < former.listed.size(); ++i) {
    const ListedRobot& before = former.listed[i];
    if (!before.id && only.value_or(i) == i) {
      loadRobot({private_node, parameters, load_resource, report}, sources[i], ros::WallTime(),
                loaded);
      continue;
    }
    loaded.listed.push_back(before);
    if (!before.id) {
      continue;
    }
    loaded.listed.back().id = idAt<RobotId>(loaded.descriptions.size());
    loaded.descriptions.push_back(former.descriptions[index(*before.id)]);
  }
  return loaded;
}

}  // namespace collision_monitor
