// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/parameters/unknown_names.h"

#include <utility>

#include "collision_monitor/geometry/ids.h"

namespace collision_monitor {
namespace {

/// What rules may name: links, and the names and groups of objects that may have faults themselves.
struct Names {
  RobotModel model;  ///< without geometry
  std::vector<SrdfPairs> groups;
};

void addLink(const std::string& name, RobotId robot, RobotModel& model) {
  Link link;
  link.name = link.frame = name;
  link.robot = robot;
  model.links.push_back(std::move(link));
}

Names namesOf(const SetupInput& robots, const std::vector<WorldObject>& objects) {
  Names names{{}, robots.srdfs};
  RobotModel& model = names.model;
  model.robots = robots.model.robots;
  for (const Link& link : robots.model.links) {
    addLink(link.name, link.robot, model);
  }
  const auto world = idAt<RobotId>(model.robots.size());
  model.robots.emplace_back().is_world = true;
  SrdfPairs groups;
  groups.robot = world;
  for (const WorldObject& object : objects) {
    if (!object.group.empty()) {
      groups.groups.push_back({object.group, {idAt<LinkId>(model.links.size())}, {}, {}});
    }
    addLink(object.name, world, model);
  }
  names.groups.push_back(std::move(groups));
  return names;
}

}  // namespace

KnownPlaces anyPlaces(const std::vector<WorldObject>& objects) {
  KnownPlaces places;
  for (const WorldObject& object : objects) {
    places.links.push_back(object.frame);
    places.links.insert(places.links.end(), object.touch_links.begin(), object.touch_links.end());
  }
  return places;
}

void checkRuleNames(const DocumentText& rules, const SetupInput& robots,
                    const std::vector<WorldObject>& objects, SetupReport& report) {
  const Names names = namesOf(robots, objects);
  SetupReport of_names;
  readPairRules(rules, names.model, names.groups, IdleRule::is_warning, of_names);
  report.errors.insert(report.errors.end(), of_names.warnings.begin(), of_names.warnings.end());
}

std::vector<Problem> warningsOfNames(const CycleSetup& setup) {
  std::vector<Problem> warnings;
  for (const PairRule& rule : setup.pair_rules) {
    std::string list = "- " + rule.yaml;
    for (std::size_t end = list.find('\n'); end != std::string::npos;
         end = list.find('\n', end + 1)) {
      list.insert(end + 1, "  ");
    }
    SetupReport report;
    readPairRules({rule.where, list}, setup.model, setup.srdfs, IdleRule::is_warning, report);
    for (Problem& warning : report.warnings) {
      warning.where = rule.where;
      warnings.push_back(std::move(warning));
    }
  }
  return warnings;
}

}  // namespace collision_monitor
