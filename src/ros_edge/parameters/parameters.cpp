// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/parameters/parameters.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "model/place.h"
#include "ros_edge/pace.h"
#include "ros_edge/parameters/file_parameters.h"
#include "ros_edge/parameters/parameter_struct.h"
#include "ros_edge/parameters/robot_parameters.h"
#include "ros_edge/world/world_parameters.h"

namespace collision_monitor {
namespace {

using XmlRpc::XmlRpcValue;

constexpr NumberRange kAnyLength{-1e6, 1e6};
constexpr NumberRange kLength{0.0, 1e6};
constexpr NumberRange kTime{0.0, 1e6, true};
constexpr NumberRange kDuration{0.0, 1e3};

void readLimits(const XmlRpcValue& values, const std::string& where, Limits& limits,
                SetupReport& report) {
  const std::size_t before = report.errors.size();
  ParameterStruct fields(values, where, report);
  for (const LimitField& field : kLimitFields) {
    fields.read(field.name, {field.least, field.greatest}, limits.*field.value);
  }
  if (report.errors.size() == before) {  // else a default may not fit to the others
    checkLimits(limits, "parameter " + where + "/", report);
  }
  fields.refuseOthers();
}

void readLookAhead(const XmlRpcValue& values, const std::string& where, LookAhead& ahead,
                   SetupReport& report) {
  constexpr NumberRange kReaction{1e-3, 1e3};
  ParameterStruct fields(values, where, report);
  fields.read("horizon", kDuration, ahead.horizon);
  fields.read("stop_distance", kAnyLength, ahead.stop.stop_distance);
  fields.read("stop_time", kReaction, ahead.stop.stop_time);
  fields.read("release_time", kReaction, ahead.stop.release_time);
  fields.read("rest_speed", {0.0, 1e3}, ahead.stop.rest_speed);
  fields.read("creep_scale", {0.0, 1.0}, ahead.stop.creep_scale);
  fields.refuseOthers();
}

void readTopic(ParameterStruct& fields, const std::string& field, std::string& topic,
               SetupReport& report) {
  readName(fields, field, "the name of a topic", topic, report);
}

/// A struct of links or patterns and metres, like MoveIt's default_robot_link_padding.
std::vector<NamedPadding> readPaddings(const XmlRpcValue& values, const std::string& where,
                                       SetupReport& report) {
  constexpr double kMost = 1e3;
  std::vector<NamedPadding> paddings;
  ParameterStruct fields(values, where, report);
  if (values.getType() != XmlRpcValue::TypeStruct) {
    return paddings;
  }
  for (const auto& named : values) {
    paddings.push_back({named.first, 0.0});
    fields.read(named.first, {0.0, kMost}, paddings.back().padding);
  }
  return paddings;
}

/// A file, or the rules themselves.
void readRuleList(const XmlRpcValue& value, const std::string& where, Parameters& parameters,
                  SetupReport& report) {
  if (value.getType() == XmlRpcValue::TypeString) {
    parameters.pair_rules = static_cast<std::string>(value);
  } else if (value.getType() == XmlRpcValue::TypeArray) {
    parameters.setup.pair_rules = {"parameter " + where, toYaml(value)};
  } else {
    report.errors.push_back(
        {"parameter " + where, toText(value), "a list of rules, or a file that has one"});
  }
}

/// Nothing, after a fault, if it is no pair.
std::optional<NamedPair> readPair(const XmlRpcValue& value, const std::string& where,
                                  SetupReport& report) {
  if (value.getType() != XmlRpcValue::TypeArray || value.size() != 2) {
    report.errors.push_back(
        {"parameter " + where, toText(value), "a list of two names of links or patterns"});
    return std::nullopt;
  }
  const std::size_t before = report.errors.size();
  std::array<std::string, 2> names;
  for (int i = 0; i < 2; ++i) {
    if (value[i].getType() == XmlRpcValue::TypeString) {
      names.at(static_cast<std::size_t>(i)) = static_cast<std::string>(value[i]);
    } else {  // YAML reads the name 7 as a number
      report.errors.push_back({"parameter " + where + "[" + std::to_string(i) + "]",
                               toText(value[i]), "a name of a link or a pattern, in quotes"});
    }
  }
  return report.errors.size() > before ? std::nullopt
                                       : std::optional<NamedPair>({names[0], names[1]});
}

std::vector<NamedPair> readPairs(const XmlRpcValue& values, const std::string& where,
                                 SetupReport& report) {
  std::vector<NamedPair> pairs;
  if (values.getType() != XmlRpcValue::TypeArray) {
    report.errors.push_back({"parameter " + where, toText(values), "a list of pairs of links"});
    return pairs;
  }
  for (int i = 0; i < values.size(); ++i) {
    if (auto pair = readPair(values[i], where + "[" + std::to_string(i) + "]", report)) {
      pairs.push_back(std::move(*pair));
    }
  }
  return pairs;
}

void readTiming(ParameterStruct& fields, Parameters& parameters) {
  fields.read("rate", {0.0, 10000.0, true}, parameters.rate);
  double priority = parameters.real_time_priority;
  fields.read("real_time_priority", wholeNumbers(0.0, 99.0), priority);
  parameters.real_time_priority = static_cast<int>(priority);
  std::size_t trigger = 0;
  fields.read("trigger", {"timer", "pose"}, trigger);
  parameters.trigger = trigger == 0 ? Trigger::timer : Trigger::pose;
  std::size_t source = 0;
  fields.read("pose_source", {"tf", "joint_states"}, source);
  parameters.pose_source = source == 0 ? PoseSource::tf : PoseSource::joint_states;
  fields.read("max_age", kTime, parameters.max_age);
  fields.read("clock_timeout", kTime, parameters.clock_timeout);
  fields.read("velocity_filter", kDuration, parameters.velocity_filter);
  fields.read("heartbeat_rate", {1.0, 1000.0}, parameters.heartbeat_rate);
  fields.read("marker_rate", {0.0, 1000.0, true}, parameters.marker_rate);
  auto labels = static_cast<double>(parameters.marker_labels);
  fields.read("marker_labels", wholeNumbers(0.0, 50.0), labels);  // more cannot be read
  parameters.marker_labels = static_cast<std::size_t>(labels);
  fields.read("disable_timeout", kTime, parameters.disable_timeout);
  fields.read("wait_for_description", {0.0, 1e6}, parameters.wait_for_description);
}

void readBroadPhase(ParameterStruct& fields, Parameters& parameters) {
  std::size_t choice = 0;
  fields.read("broad_phase",
              {"auto", "brute_force", "sweep_and_prune", "hashed_bins", "aabb_tree",
               "neighbour_list", "combination"},
              choice);
  parameters.broad_phase = static_cast<BroadPhaseKind>(choice);
}

void readMemoryLimit(ParameterStruct& fields, SetupOptions& options) {
  constexpr double kMegabyte = 1e6;
  double megabytes = 0.0;
  fields.read("memory_limit", wholeNumbers(0.0, 1e9), megabytes);
  options.memory_limit = static_cast<std::uint64_t>(megabytes * kMegabyte);
}

/// Reads how links get their shapes.
void readFitting(ParameterStruct& fields, Parameters& parameters) {
  fields.read("shape_rules", parameters.shape_rules);
  double max_shapes = parameters.setup.default_limits.max_shapes;
  fields.read("max_shapes_per_link", wholeNumbers(1.0, 1000.0), max_shapes);
  parameters.setup.default_limits.max_shapes = static_cast<std::uint32_t>(max_shapes);
  fields.read("target_overshoot", kLength, parameters.setup.default_limits.target_overshoot);
  fields.read("fit_cache", parameters.fit_cache);
  fields.read("padding", {0.0, 1e3}, parameters.setup.padding);
  fields.read("srdf_spheres", parameters.setup.uses_srdf_spheres);
}

/// Reads what is measured where enclosing shapes are near, and how much of it per cycle.
/// @param most [m] larger tolerances are refused: they could hide everything that warnings report
void readRefining(ParameterStruct& fields, double most, RefineOptions& refine) {
  std::size_t geometry = 0;
  fields.read("refine_geometry", {"mesh", "hull", "none"}, geometry);
  constexpr RefineGeometry kGeometries[] = {RefineGeometry::mesh, RefineGeometry::hull,
                                            RefineGeometry::none};
  refine.geometry = kGeometries[geometry];
  fields.read("refine_distance", kLength, refine.limits.distance);
  double budget = refine.limits.budget;
  fields.read("refine_budget", wholeNumbers(0.0, 4e9), budget);
  refine.limits.budget = static_cast<std::uint32_t>(budget);
  constexpr double kTolerance = 1e-4;
  refine.limits.tolerance = std::min(kTolerance, most);
  fields.read("distance_tolerance", {0.0, most}, refine.limits.tolerance);
}

/// Accepts names that other software keeps in a node's private namespace.
void tolerateForeign(ParameterStruct& fields) {
  for (const char* name :
       {"diagnostic_period", "robot_description", "robot_description_semantic",
        "robot_description_planning", "robot_description_kinematics", "num_worker_threads"}) {
    fields.tolerate(name);
  }
}

}  // namespace

Parameters readParameters(const XmlRpcValue& values, const std::string& where,
                          SetupReport& report) {
  Parameters parameters;
  parameters.setup.where = "parameter " + where + "/";
  ParameterStruct fields(values, where, report);
  if (const XmlRpcValue* robots = fields.find("robots")) {
    parameters.robots = readRobotList(*robots, fields.pathOf("robots"), report);
  }
  if (const XmlRpcValue* limits = fields.find("limits")) {
    readLimits(*limits, fields.pathOf("limits"), parameters.setup.limits, report);
  }
  if (const XmlRpcValue* ahead = fields.find("look_ahead")) {
    readLookAhead(*ahead, fields.pathOf("look_ahead"), parameters.setup.ahead, report);
  }
  if (const XmlRpcValue* pairs = fields.find("ignore_pairs")) {
    parameters.setup.ignored_pairs = readPairs(*pairs, fields.pathOf("ignore_pairs"), report);
  }
  if (const XmlRpcValue* paddings = fields.find("link_padding")) {
    parameters.setup.link_paddings = readPaddings(*paddings, fields.pathOf("link_padding"), report);
  }
  if (const XmlRpcValue* rules = fields.find("pair_rules")) {
    readRuleList(*rules, fields.pathOf("pair_rules"), parameters, report);
  }
  if (const XmlRpcValue* files = fields.find("files")) {
    readFileParameters(*files, fields.pathOf("files"), parameters.loading, parameters.setup.meshes,
                       report);
  }
  if (const XmlRpcValue* world = fields.find("world")) {
    parameters.world = yamlOf(*world);
  }
  fields.read("world_file", parameters.world_file);
  fields.read("mesh_directory", parameters.mesh_directory);
  fields.read("obey_up_axis", parameters.obey_up_axis);
  fields.read("strict", parameters.is_strict);
  fields.read("world_frame", parameters.world_frame);
  readTiming(fields, parameters);
  readTopic(fields, "joint_states", parameters.joint_states, report);
  readFitting(fields, parameters);
  readRefining(fields, std::max(0.0, parameters.setup.limits.warning_distance),
               parameters.setup.refine);
  if (parameters.trigger == Trigger::timer) {
    parameters.setup.refine.limits.period = periodOf(parameters);
  }
  fields.read("continuous", parameters.setup.is_continuous);
  fields.read("ignore_default_overlap", parameters.setup.ignore_default_overlap);
  readBroadPhase(fields, parameters);
  readMemoryLimit(fields, parameters.setup);
  tolerateForeign(fields);
  fields.refuseOthers();
  return parameters;
}

}  // namespace collision_monitor
