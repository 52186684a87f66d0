// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/parameters/robot_parameters.h"

#include <ros/names.h>

#include <algorithm>

#include "model/place.h"

namespace collision_monitor {
namespace {

using XmlRpc::XmlRpcValue;

/// Whether a name can be a part of the name of a topic.
bool isTopicPart(const std::string& name) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const auto is_legal = [&](char c) {
    return is_letter(c) || (c >= '0' && c <= '9') || c == '_' || c == '/';
  };
  return !name.empty() && is_letter(name.front()) && name.back() != '/' &&
         name.find("//") == std::string::npos && std::all_of(name.begin(), name.end(), is_legal);
}

RobotSource readRobot(const XmlRpcValue& values, const std::string& where, SetupReport& report) {
  RobotSource robot;
  ParameterStruct fields(values, where, report);
  fields.read("name", robot.name);
  if (!robot.name.empty() && !isTopicPart(robot.name)) {
    report.errors.push_back({"parameter " + where + "/name", collision_monitor::quoted(robot.name),
                             "a letter, then letters, digits, _ and /: topics have this name"});
  }
  fields.read("may_be_absent", robot.may_be_absent);
  readName(fields, "description", "the name of a parameter", robot.description, report);
  readName(fields, "semantic", "the name of a parameter", robot.semantic, report);
  fields.read("file", robot.file);
  fields.read("semantic_file", robot.semantic_file);
  fields.read("tf_prefix", robot.tf_prefix);
  readName(fields, "joint_states", "the name of a topic", robot.joint_states, report);
  fields.refuseOthers();
  if (values.getType() != XmlRpcValue::TypeStruct) {
    return robot;  // reported already, and further faults would only follow from it
  }
  if (robot.description.empty() == robot.file.empty()) {
    report.errors.push_back({"parameter " + where, robot.file.empty() ? "no source" : "two sources",
                             "either 'description' (a parameter's name) or 'file'"});
  }
  if (!robot.semantic.empty() && !robot.semantic_file.empty()) {
    report.errors.push_back({"parameter " + where, "two sources of the SRDF",
                             "either 'semantic' or 'semantic_file', or neither"});
  }
  return robot;
}

}  // namespace

void readName(ParameterStruct& fields, const std::string& field, const char* accepted,
              std::string& name, SetupReport& report) {
  fields.read(field, name);
  std::string fault = "begins with ~";
  if (name.rfind('~', 0) == 0 || !ros::names::validate(name, fault)) {
    report.errors.push_back(
        {"parameter " + fields.pathOf(field), "'" + name + "': " + fault, accepted});
  }
}

std::vector<RobotSource> readRobotList(const XmlRpcValue& values, const std::string& where,
                                       SetupReport& report) {
  std::vector<RobotSource> robots;
  if (values.getType() != XmlRpcValue::TypeArray) {
    report.errors.push_back({"parameter " + where, toText(values), "a list of robots"});
    return robots;
  }
  for (int i = 0; i < values.size(); ++i) {
    const std::string place = where + "[" + std::to_string(i) + "]";
    robots.push_back(readRobot(values[i], place, report));
    if (robots.back().name.empty()) {
      robots.back().name = "robot_" + std::to_string(i);
    }
    for (std::size_t other = 0; other + 1 < robots.size(); ++other) {
      if (robots[other].name == robots.back().name) {
        report.errors.push_back(
            {"parameter " + place + "/name", "'" + robots.back().name + "' twice", "unique names"});
      }
    }
  }
  return robots;
}

}  // namespace collision_monitor
