// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/parameters/monitor_setup.h"

#include <malloc.h>

#include <algorithm>
#include <utility>

#include "collision_monitor/geometry/ids.h"
#include "model/object_links.h"
#include "pipeline/world/add_world.h"
#include "ros_edge/parameters/fit_options.h"
#include "ros_edge/parameters/resource_loader.h"
#include "ros_edge/parameters/robot_descriptions.h"
#include "ros_edge/parameters/startup_report.h"
#include "ros_edge/parameters/unknown_names.h"
#include "ros_edge/poses/transform_store.h"
#include "ros_edge/world/world_parameters.h"
#include "ros_edge/world/world_places.h"

namespace collision_monitor {
std::shared_ptr<MonitorSetup> partsOf(const MonitorSetup& former) {
  auto made = std::make_shared<MonitorSetup>();
  made->parameters = former.parameters;
  made->robots = former.robots;
  made->listed = former.listed;
  made->held_back = former.held_back;
  made->world = former.world;
  made->prepared = former.prepared;
  made->drawn = former.drawn;
  made->world_frame = former.world_frame;
  made->descriptions = former.descriptions;
  made->later_warnings = former.later_warnings;
  return made;
}

namespace {

/// The objects at start, or those of the set-up before a reload, and what that held back.
std::vector<WorldObject> objectsFor(const MonitorSetup& made, const MonitorSetup* former,
                                    const ResourceLoader& load_resource, SetupReport& report) {
  if (former == nullptr) {
    return loadObjects(made.parameters, load_resource, report);
  }
  std::vector<WorldObject> objects;
  for (const auto& [name, object] : former->world.objects) {
    objects.push_back(*object);
  }
  objects.insert(objects.end(), former->held_back.begin(), former->held_back.end());
  return objects;
}

/// @param model the robots; without links any place is accepted
/// @param awaits_links as in KnownPlaces
/// @return no objects after a fault, which is added to `report`
World makeWorld(std::vector<WorldObject> objects, const RobotModel& model, bool awaits_links,
                MonitorSetup& made, SetupReport& report) {
  if (!made.listed.empty()) {
    checkFrames(objects, made.listed.front(), made.parameters.world_frame, report);
  }
  KnownPlaces places = model.links.empty() ? anyPlaces(objects) : placesOf(model, made.world_frame);
  places.awaits_links = awaits_links;
  ObjectChange change{ChangeKind::replace_all, {}, true};
  for (WorldObject& object : objects) {
    if (object.where.empty()) {
      object.where = "world";  // a service brought it
    }
    const bool waits = awaits_links && object.is_attached && !model.findLink(object.frame) &&
                       (model.links.empty() || places.mayCome(object.frame));
    if (waits) {
      places.waiting.insert(object.name);
    }
    (waits ? made.held_back : change.objects).push_back(std::move(object));
  }
  return applyChanges(World(), {change}, places, report);
}

/// @param former has objects that may be prepared already; may be null
void addObjects(World world, const MonitorSetup* former, MonitorSetup& made) {
  const RefineGeometry refine = made.parameters.setup.refine.geometry;
  const bool is_prepared = former != nullptr && former->parameters.setup.refine.geometry == refine;
  made.world = std::move(world);
  made.prepared =
      prepareObjects(made.world, refine, is_prepared ? former->prepared : PreparedObjects());
  made.drawn = drawMeshes(made.world, former == nullptr ? DrawnMeshes() : former->drawn);
  made.setup = addWorld(*made.robots, made.world, made.prepared, made.world_frame);
}

/// Rules and limits that have changed since start.
/// @return warnings of rules that select no pair
std::vector<Problem> keepRules(const MonitorSetup& former, MonitorSetup& made) {
  SetupReport idle;  // objects that rules name may have gone
  const CycleSetup& last = former.setup;
  const bool has_common_limits =
      std::all_of(kLimitFields.begin(), kLimitFields.end(), [&](const LimitField& field) {
        return last.limits.*field.value == made.setup.limits.*field.value;
      });
  if (!has_common_limits || !last.pair_rules.empty() || !made.setup.pair_rules.empty()) {
    made.setup =
        withPairRules(made.setup, last.limits,
                      selectAnew(last.pair_rules, made.setup.model, made.setup.srdfs), idle);
  }
  made.rule_ends = former.rule_ends;
  return idle.warnings;
}

/// The warnings about robots that have not come yet, and about what names their links.
void warnOfMissing(MonitorSetup& made) {
  std::vector<Problem>& warnings = made.setup.report.warnings;
  for (std::size_t i = 0; i < made.listed.size(); ++i) {
    const ListedRobot& robot = made.listed[i];
    if (!robot.id) {
      const bool is_frame = i == 0 && made.parameters.world_frame.empty();
      warnings.push_back({"robot '" + robot.name + "'", robot.missing, "",
                          "it is taken in when it comes; until then the state is UNKNOWN" +
                              std::string(is_frame ? ". The world frame is '" + made.world_frame +
                                                         "' meanwhile and then; set world_frame"
                                                   : "")});
    }
  }
  const RobotModel& model = made.robots->model;
  for (const auto& [name, object] : made.world.objects) {
    const std::string place =
        (object->where.empty() ? "world" : object->where) + ", object '" + name + "'";
    for (const std::string& link : object->touch_links) {
      if (!model.findLink(link)) {
        const bool may_come = isAnyMissing(made);
        warnings.push_back({place, "touch link '" + link + "', which is not there", "",
                            may_come ? "it counts once a robot with it has come"
                                     : "no robot has it, so it counts for nothing"});
      }
    }
  }
  for (const WorldObject& object : made.held_back) {
    warnings.push_back({object.where.empty() ? "world" : object.where,
                        "object '" + object.name + "', which names a link that is not there yet",
                        "", "it is added when the missing robots have come"});
  }
}

/// @param idle of rules, once all robots are there
SetupOptions optionsFor(const MonitorSetup& made, const ResourceLoader& load_resource,
                        IdleRule idle, SetupReport& report) {
  SetupOptions options = loadSetupOptions(made.parameters, load_resource, report);
  options.fit_progress = logLongFitting();
  options.awaits_names = made.descriptions.empty() || isAnyMissing(made);
  options.idle_rules = options.awaits_names ? IdleRule::is_accepted : idle;
  report.awaits_names = options.awaits_names;
  return options;
}

std::shared_ptr<const CycleSetup> buildRobots(SetupInput input, const SetupOptions& options,
                                              SetupReport report) {
  checkOptions(options, report);
  throwIfErrors(report);
  return std::make_shared<CycleSetup>(
      withoutPairs(buildFrom(std::move(input), options, std::move(report))));
}

/// Names the world's frame, and a robot without a list by its URDF.
void nameByRobots(const RobotModel& model, MonitorSetup& made) {
  if (made.parameters.robots.empty()) {
    made.listed.front().name = model.robots.front().name;
  }
  made.world_frame = stripLeadingSlash(made.parameters.world_frame.empty()
                                           ? model.link(model.robots.front().root).frame
                                           : made.parameters.world_frame);
}

/// Builds everything of `made` but its parameters and robots' descriptions. Reads all of it before
/// shapes are fitted, so that all faults are told at once.
/// @param former gives objects; may be null
/// @param report has the faults of parameters and descriptions
void build(const ResourceLoader& load_resource, const MonitorSetup* former, SetupReport& report,
           MonitorSetup& made) {
  const bool has_objects =
      !made.parameters.world.empty() || !made.parameters.world_file.empty() ||
      (former != nullptr && (!former->world.objects.empty() || !former->held_back.empty()));
  const SetupOptions options = optionsFor(
      made, load_resource, has_objects ? IdleRule::is_accepted : IdleRule::is_error, report);
  SetupInput input = readInput(made.descriptions, load_resource, options, report);
  const bool are_links_known =
      !made.descriptions.empty() && input.model.robots.size() == made.descriptions.size();
  if (are_links_known) {
    nameByRobots(input.model, made);
  }
  const std::vector<WorldObject> objects = objectsFor(made, former, load_resource, report);
  World world = makeWorld(objects, are_links_known ? input.model : RobotModel(), isAnyMissing(made),
                          made, report);
  if (!report.errors.empty() && has_objects && former == nullptr && !report.awaits_names) {
    checkRuleNames(options.pair_rules, input, objects, report);
  }
  throwIfErrors(report);
  made.robots = buildRobots(std::move(input), options, report);
  addObjects(std::move(world), former, made);
  if (has_objects) {
    const IdleRule at_reload = former == nullptr ? IdleRule::is_error : IdleRule::is_warning;
    applyRulesText(options.pair_rules, options.awaits_names ? IdleRule::is_accepted : at_reload,
                   made.setup);
  }
  made.rule_ends.assign(made.setup.pair_rules.size(), kLasts);
  warnOfMissing(made);
  malloc_trim(0);  // reading and fitting free much memory that glibc would keep
}

}  // namespace

bool isAnyMissing(const MonitorSetup& setup) {
  return std::any_of(setup.listed.begin(), setup.listed.end(),
                     [](const ListedRobot& robot) { return !robot.id; });
}

std::shared_ptr<const MonitorSetup> changeWorld(const MonitorSetup& former, const World& world,
                                                std::vector<WorldObject> held_back) {
  std::shared_ptr<MonitorSetup> made = partsOf(former);
  made->held_back = std::move(held_back);
  addObjects(world, &former, *made);
  keepRules(former, *made);
  warnOfMissing(*made);
  return made;
}

std::shared_ptr<const MonitorSetup> buildLate(LoadedRobots come, const MonitorSetup& former,
                                              SetupReport& report) {
  auto late = std::make_shared<MonitorSetup>();
  late->parameters = former.parameters;
  late->descriptions = std::move(come.descriptions);
  late->listed = std::move(come.listed);
  const ResourceLoader load_resource = makeResourceLoader(former.parameters.loading);
  const SetupOptions options = optionsFor(*late, load_resource, IdleRule::is_accepted, report);
  throwIfErrors(report);
  SetupInput input = readInput(late->descriptions, load_resource, options, report);
  late->robots = buildRobots(std::move(input), options, report);
  return late;
}

std::shared_ptr<const MonitorSetup> takeIn(const MonitorSetup& late, const MonitorSetup& former) {
  auto made = std::make_shared<MonitorSetup>();
  made->parameters = former.parameters;
  made->world_frame = former.world_frame;
  made->robots = late.robots;
  made->listed = late.listed;
  made->descriptions = late.descriptions;
  SetupReport report;
  const ResourceLoader load_resource = makeResourceLoader(former.parameters.loading);
  World world = makeWorld(objectsFor(*made, &former, load_resource, report), made->robots->model,
                          true, *made, report);
  throwIfErrors(report);
  addObjects(std::move(world), &former, *made);
  std::vector<Problem> idle = keepRules(former, *made);
  if (!isAnyMissing(*made)) {
    std::vector<Problem>& warnings = made->setup.report.warnings;
    warnings.insert(warnings.end(), idle.begin(), idle.end());
    idle = warningsOfNames(made->setup);
    warnings.insert(warnings.end(), idle.begin(), idle.end());
  }
  warnOfMissing(*made);
  malloc_trim(0);
  return made;
}

std::shared_ptr<const MonitorSetup> withMissing(const MonitorSetup& former,
                                                const std::vector<ListedRobot>& listed) {
  auto made = std::make_shared<MonitorSetup>(former);
  for (std::size_t i = 0; i < listed.size(); ++i) {
    if (former.listed[i].id) {
      continue;
    }
    for (Problem& warning : made->setup.report.warnings) {
      if (warning.found == former.listed[i].missing) {
        warning.found = listed[i].missing;
      }
    }
    made->listed[i].missing = listed[i].missing;
    made->listed[i].has_come = listed[i].has_come;
  }
  return made;
}

std::shared_ptr<const MonitorSetup> makeMonitorSetup(const ros::NodeHandle& private_node,
                                                     GoesOn goes_on, const MonitorSetup* former) {
  const Interruptible interruptible(std::move(goes_on));
  SetupReport report;
  const std::string& where = private_node.getNamespace();
  XmlRpc::XmlRpcValue values;
  private_node.getParam(where, values);
  auto made = std::make_shared<MonitorSetup>();
  made->parameters = readParameters(values, where, report);
  const ResourceLoader load_resource = makeResourceLoader(made->parameters.loading);
  LoadedRobots loaded = loadDescriptions(private_node, made->parameters, load_resource, report);
  made->descriptions = std::move(loaded.descriptions);
  made->listed = std::move(loaded.listed);
  build(load_resource, former, report, *made);
  return made;
}

}  // namespace collision_monitor
