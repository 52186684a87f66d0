// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/parameters/other_faults.h"

#include <algorithm>
#include <map>
#include <utility>

#include "collision_monitor/geometry/ids.h"
#include "pipeline/setup/setup_input.h"
#include "ros_edge/parameters/fit_options.h"
#include "ros_edge/world/world_parameters.h"

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

Names namesOf(const SetupInput& input, const std::vector<WorldObject>& objects) {
  Names names{{}, input.srdfs};
  RobotModel& model = names.model;
  model.robots = input.model.robots;
  for (const Link& link : input.model.links) {
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

/// Every frame and link that objects name.
KnownPlaces anyPlaces(const std::vector<WorldObject>& objects) {
  KnownPlaces places;
  for (const WorldObject& object : objects) {
    places.links.push_back(object.frame);
    places.links.insert(places.links.end(), object.touch_links.begin(), object.touch_links.end());
  }
  return places;
}

void addFaultsOfObjects(const StartInput& from, const SetupInput& input, bool are_links_known,
                        const std::vector<WorldObject>& objects, SetupReport& report) {
  if (!from.robots.listed.empty()) {
    checkFrames(objects, from.robots.listed.front(), from.parameters.world_frame, report);
  }
  const KnownPlaces places =
      are_links_known ? placesOf(input.model, from.parameters.world_frame) : anyPlaces(objects);
  applyChanges(World(), {{ChangeKind::replace_all, objects, true}}, places, report);
}

bool isSame(const Problem& a, const Problem& b) { return a.where == b.where && a.found == b.found; }

}  // namespace

void addOtherFaults(const StartInput& from, SetupReport& report) {
  const bool are_links_known =
      !from.robots.descriptions.empty() &&
      std::all_of(from.robots.listed.begin(), from.robots.listed.end(),
                  [](const ListedRobot& robot) { return robot.id.has_value(); });
  SetupReport all;
  all.awaits_names = !are_links_known;
  SetupOptions options = loadSetupOptions(from.parameters, from.load_resource, all);
  options.idle_rules = IdleRule::is_accepted;
  const SetupInput input = readInput(from.robots.descriptions, from.load_resource, options, all);
  if (!from.is_reload) {
    const std::vector<WorldObject> objects = loadObjects(from.parameters, from.load_resource, all);
    const bool has_links = are_links_known && !input.model.links.empty();
    addFaultsOfObjects(from, input, has_links, objects, all);
    if (has_links) {
      const Names names = namesOf(input, objects);
      readPairRules(options.pair_rules, names.model, names.groups, IdleRule::is_error, all);
    }
  }
  for (Problem& fault : all.errors) {
    const auto is_told = [&](const Problem& told) { return isSame(told, fault); };
    if (std::none_of(report.errors.begin(), report.errors.end(), is_told)) {
      report.errors.push_back(std::move(fault));
    }
  }
}

}  // namespace collision_monitor
