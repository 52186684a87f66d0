// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/parameters/monitor_setup.h"

#include <malloc.h>
#include <ros/console.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "model/object_links.h"
#include "pipeline/world/add_world.h"
#include "ros_edge/parameters/fit_options.h"
#include "ros_edge/parameters/resource_loader.h"
#include "ros_edge/parameters/robot_descriptions.h"
#include "ros_edge/poses/transform_store.h"
#include "ros_edge/world/world_parameters.h"
#include "ros_edge/world/world_places.h"

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

std::shared_ptr<MonitorSetup> partsOf(const MonitorSetup& former) {
  auto made = std::make_shared<MonitorSetup>();
  made->parameters = former.parameters;
  made->robots = former.robots;
  made->world = former.world;
  made->prepared = former.prepared;
  made->world_frame = former.world_frame;
  made->descriptions = former.descriptions;
  made->later_warnings = former.later_warnings;
  return made;
}

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
  std::vector<std::string> topics;
  for (const Robot& robot : setup.setup.model.robots) {
    topics.push_back(robot.is_world ? "" : setup.parameters.joint_states);
  }
  // An empty list means one robot.
  for (std::size_t i = 0; i < setup.parameters.robots.size(); ++i) {
    const std::string& own = setup.parameters.robots[i].joint_states;
    topics[i] = own.empty() ? topics[i] : own;
  }
  return topics;
}

std::vector<std::string> frameNames(const MonitorSetup& setup) {
  std::vector<std::string> names{setup.world_frame};
  const RobotModel& model = setup.setup.model;
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    if (!isObject(model, idAt<LinkId>(i))) {
      names.push_back(model.links[i].frame);
    }
  }
  return names;
}

namespace {

/// The objects at start, or those of the set-up before a reload.
World makeWorld(const MonitorSetup& made, const MonitorSetup* former,
                const ResourceLoader& load_resource) {
  SetupReport report;
  ObjectChange change{ChangeKind::replace_all, {}, true};
  if (former != nullptr) {
    for (const auto& [name, object] : former->world.objects) {
      change.objects.push_back(*object);
    }
  } else {
    change.objects = loadObjects(made.parameters, load_resource, report);
  }
  const World world =
      applyChanges(World(), {change}, placesAtStart(made.robots->model, made.world_frame), report);
  throwIfErrors(report);
  return world;
}

void addObjects(World world, const PreparedObjects& former, MonitorSetup& made) {
  const RefineGeometry refine = made.parameters.setup.refine.geometry;
  made.world = std::move(world);
  made.prepared = prepareObjects(made.world, refine, former);
  made.setup = addWorld(*made.robots, made.world, made.prepared, made.world_frame);
}

/// Rules of the parameters may name objects, too.
/// @param idle a warning at a reload: objects that rules name may have gone
void applyRules(const PairRulesText& text, IdleRule idle, MonitorSetup& made) {
  CycleSetup& setup = made.setup;
  SetupReport report;
  const std::vector<PairRule> rules = readPairRules(text, setup.model, setup.srdfs, idle, report);
  if (idle == IdleRule::is_error) {
    reportIdleRules(rules, setup.link_pairs, idle, report);
  }
  throwIfErrors(report);
  if (!rules.empty()) {
    setup = withPairRules(setup, setup.limits, rules, report);
  }
  std::vector<Problem>& warnings = setup.report.warnings;
  warnings.insert(warnings.end(), report.warnings.begin(), report.warnings.end());
}

/// Rules and limits that have changed since start.
void keepRules(const MonitorSetup& former, MonitorSetup& made) {
  const CycleSetup& last = former.setup;
  const bool has_common_limits =
      std::all_of(kLimitFields.begin(), kLimitFields.end(), [&](const LimitField& field) {
        return last.limits.*field.value == made.setup.limits.*field.value;
      });
  if (!has_common_limits || !last.pair_rules.empty() || !made.setup.pair_rules.empty()) {
    SetupReport idle;  // objects that rules name may have gone
    made.setup =
        withPairRules(made.setup, last.limits,
                      selectAnew(last.pair_rules, made.setup.model, made.setup.srdfs), idle);
  }
  made.rule_ends = former.rule_ends;
}

}  // namespace

std::shared_ptr<const MonitorSetup> changeWorld(const MonitorSetup& former, const World& world) {
  std::shared_ptr<MonitorSetup> made = partsOf(former);
  addObjects(world, former.prepared, *made);
  keepRules(former, *made);
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
  // Faulty parameters may not even tell which robots to wait for.
  throwIfErrors(report);

  const ResourceLoader load_resource = makeResourceLoader(made->parameters.loading);
  const std::vector<RobotDescription> descriptions =
      loadDescriptions(private_node, made->parameters, load_resource, report);
  SetupOptions options = loadSetupOptions(made->parameters, load_resource, report);
  options.fit_progress = logLongFitting();
  throwIfErrors(report);

  made->descriptions = descriptions;
  const bool has_objects = !made->parameters.world.empty() ||
                           !made->parameters.world_file.empty() ||
                           (former != nullptr && !former->world.objects.empty());
  options.idle_rules = has_objects ? IdleRule::is_accepted : IdleRule::is_error;
  made->robots =
      std::make_shared<CycleSetup>(withoutPairs(buildSetup(descriptions, load_resource, options)));
  const RobotModel& model = made->robots->model;
  made->world_frame = stripLeadingSlash(made->parameters.world_frame.empty()
                                            ? model.link(model.robots.front().root).frame
                                            : made->parameters.world_frame);
  addObjects(makeWorld(*made, former, load_resource), {}, *made);
  if (has_objects) {
    applyRules(options.pair_rules, former == nullptr ? IdleRule::is_error : IdleRule::is_warning,
               *made);
  }
  made->rule_ends.assign(made->setup.pair_rules.size(), kLasts);
  malloc_trim(0);  // reading and fitting free much memory that glibc would keep
  return made;
}

}  // namespace collision_monitor
