// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "library/monitor_parts.h"

#include <algorithm>
#include <string>
#include <utility>

#include "geometry/interruption.h"
#include "library/option_texts.h"
#include "model/world/world_text.h"
#include "pipeline/fits/fit_cache_folder.h"
#include "pipeline/world/add_world.h"

namespace collision_monitor {
namespace {

SetupOptions setupOptions(const MonitorOptions& options) {
  SetupOptions setup;
  setup.where = "option ";
  setup.limits = options.limits;
  setup.limits.report_distance =
      std::max(options.limits.report_distance, options.limits.warning_distance);
  setup.padding = options.padding;
  setup.default_limits = options.fit;
  setup.shape_rules = options.shape_rules;
  setup.pair_rules = options.pair_rules;
  setup.idle_rules = options.world.text.empty() ? IdleRule::is_error : IdleRule::is_accepted;
  setup.meshes = options.meshes;
  setup.refine.geometry = options.detail;
  setup.refine.limits.tolerance = options.distance_tolerance;
  setup.is_continuous = false;
  setup.fit_cache = fitCacheFolder(options.fit_cache);
  setup.fit_progress = options.fit_progress;
  setup.ignored_pairs = options.ignored_pairs;
  setup.ignore_default_overlap = options.ignore_default_overlap;
  return setup;
}

void checkRoots(const MonitorOptions& options, std::size_t robots, SetupReport& report) {
  const std::vector<Pose>& roots = options.world_from_root;
  if (!roots.empty() && roots.size() != robots) {
    report.errors.push_back({"option world_from_root", std::to_string(roots.size()) + " poses",
                             "none, or one for each of the " + std::to_string(robots) + " robots"});
  }
  for (std::size_t i = 0; i < roots.size(); ++i) {
    if (!isRigid(roots[i]) || roots[i].translation.cwiseAbs().maxCoeff() > kFarthest) {
      report.errors.push_back({"option world_from_root[" + std::to_string(i) + "]",
                               "a pose that is not finite, not rigid or far away",
                               "a rotation of orthonormal columns, right-handed, and a translation "
                               "up to 1e9 m"});
    }
  }
}

/// The set-up; its faults join those of the report. Rules may name links of a robot that is
/// missing: they are then not looked at.
CycleSetup buildReported(const std::vector<RobotDescription>& robots, const MonitorOptions& options,
                         SetupReport& report) {
  SetupOptions setup = setupOptions(options);
  if (!report.errors.empty()) {
    setup.shape_rules = {};
    setup.pair_rules = {};
    setup.ignored_pairs.clear();
  }
  try {
    return buildSetup(robots, loaderOf(options), setup);
  } catch (const SetupError& fault) {
    report.errors.insert(report.errors.end(), fault.problems().begin(), fault.problems().end());
  }
  return {};
}

/// The frame of the world. No link of a robot has a name with a slash in front.
constexpr const char* kWorldFrame = "/world";

/// The objects of a text, checked.
World readObjects(const DocumentText& text, const RobotModel& robots,
                  const MonitorOptions& options) {
  SetupReport report;
  KnownPlaces places = placesOf(robots, kWorldFrame);
  places.has_frame = [](const std::string&) { return false; };
  places.other_frames = "none or 'world' for the world";
  const auto& frames = places.link_frames;
  const bool is_link = std::find(frames.begin(), frames.end(), "world") != frames.end();
  ObjectChange change{ChangeKind::replace_all,
                      readWorld({text.source, text.text, absoluteOf(text.directory)},
                                loaderOf(options), options.meshes, report),
                      true};
  for (WorldObject& object : change.objects) {
    if (object.frame == "world" && !object.is_attached && !is_link) {
      object.frame.clear();
    }
  }
  World world = applyChanges(World(), {change}, places, report);
  throwIfErrors(report);
  return world;
}

/// @param prepared of earlier objects
void addObjects(const DocumentText& text, const PreparedObjects& prepared, IdleRule idle,
                MonitorParts& parts) {
  const World world = readObjects(text, parts.robots->model, parts.options);
  parts.prepared = prepareObjects(world, parts.options.detail, prepared);
  parts.setup = addWorld(*parts.robots, world, parts.prepared, kWorldFrame);
  applyRulesText(parts.options.pair_rules, idle, parts.setup);
}

}  // namespace

std::shared_ptr<const MonitorParts> makeMonitorParts(const GivenRobots& robots,
                                                     const MonitorOptions& given) {
  // An empty question leaves the caller's own in place.
  const Interruptible interruptible(given.goes_on ? given.goes_on : goesOnHere());
  auto parts = std::make_shared<MonitorParts>();
  SetupReport report = robots.report;
  MonitorOptions& options = parts->options;
  options = given;
  readTexts(options, report);
  if (!robots.descriptions.empty() || report.errors.empty()) {
    std::vector<RobotDescription> descriptions = robots.descriptions;
    for (RobotDescription& robot : descriptions) {
      robot.directory = absoluteOf(robot.directory);
    }
    parts->setup = buildReported(descriptions, options, report);
  }
  checkRoots(options, robots.descriptions.size() + robots.report.errors.size(), report);
  if (!report.errors.empty()) {
    addTextFaults(options, report);
  }
  throwIfErrors(report);
  options.goes_on = nullptr;
  options.fit_progress = nullptr;
  if (!options.world.text.empty()) {
    parts->robots = std::make_shared<CycleSetup>(withoutPairs(parts->setup));
    addObjects(options.world, {}, IdleRule::is_error, *parts);
  }
  describeSetup(*parts);
  return parts;
}

std::shared_ptr<const MonitorParts> replaceWorld(const MonitorParts& former,
                                                 const DocumentText& world) {
  auto parts = std::make_shared<MonitorParts>();
  parts->options = former.options;
  parts->options.world = world;
  SetupReport report;
  readText("world", parts->options.world, report);
  throwIfErrors(report);
  parts->robots = former.robots ? former.robots
                                : std::make_shared<const CycleSetup>(withoutPairs(former.setup));
  addObjects(parts->options.world, former.prepared, IdleRule::is_warning, *parts);
  describeSetup(*parts);
  return parts;
}

}  // namespace collision_monitor
