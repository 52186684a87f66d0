// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "explain_setup.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <utility>

#include "model/nearest_name.h"
#include "model/place.h"
#include "model/world/world_text.h"
#include "pipeline/fits/fit_cache_folder.h"
#include "pipeline/setup/setup_input.h"
#include "pipeline/world/add_world.h"
#include "read_numbers.h"
#include "read_robot.h"

namespace collision_monitor::explain_tool {
namespace {

SetupOptions readOptions(const Options& options, SetupReport& report) {
  SetupOptions setup;
  setup.where = "option --limit, ";
  const std::size_t before = report.errors.size();
  setup.limits = readLimits(options.limits, report);
  if (report.errors.size() == before) {
    checkOptions(setup, report);
  }
  setup.fit_cache = fitCacheFolder(options.cache);
  setup.shape_rules = {options.shape_rules,
                       fit_tool::readInput("option --shape-rules", options.shape_rules, report)};
  setup.pair_rules = {options.pair_rules,
                      fit_tool::readInput("option --pair-rules", options.pair_rules, report)};
  // They may name objects and other robots.
  setup.idle_rules = options.world.empty() ? IdleRule::is_warning : IdleRule::is_accepted;
  return setup;
}

/// The robot; nothing, after a fault, if a file cannot be read.
std::vector<RobotDescription> readRobot(const Options& options, SetupReport& report) {
  const std::size_t before = report.errors.size();
  RobotDescription description = fit_tool::readDescription(options.source, report);
  description.srdf_xml = fit_tool::readInput("option --srdf", options.srdf, report);
  description.srdf_source = options.srdf;
  return report.errors.size() > before ? std::vector<RobotDescription>()
                                       : std::vector<RobotDescription>{std::move(description)};
}

std::vector<WorldObject> readObjects(const Options& options, const ResourceLoader& load_resource,
                                     SetupReport& report) {
  if (options.world.empty()) {
    return {};
  }
  const std::size_t before = report.errors.size();
  const std::string text = fit_tool::readInput("option --world", options.world, report);
  if (report.errors.size() > before) {
    report.awaits_names = true;
    return {};
  }
  const std::string folder = std::filesystem::absolute(options.world).parent_path().string();
  return readWorld({options.world, text, folder}, load_resource, MeshReading(), report);
}

/// Checks the objects of a file beside this robot.
World makeWorld(std::vector<WorldObject> objects, const std::string& world_frame,
                const RobotModel& model, SetupReport& report) {
  KnownPlaces places = placesOf(model, world_frame);
  places.has_frame = [](const std::string& /*frame*/) { return false; };
  places.other_frames = "the world frame, see option --world-frame";
  return applyChanges(World(), {{ChangeKind::replace_all, std::move(objects), true}}, places,
                      report);
}

/// Checks that there are two links or objects of these names.
void checkLinks(const Options& options, const SetupInput& robot,
                const std::vector<WorldObject>& objects, SetupReport& report) {
  const RobotModel& model = robot.model;
  std::vector<std::string> known;
  for (const Link& link : model.links) {
    known.push_back(link.name);
  }
  for (const WorldObject& object : objects) {
    known.push_back(object.name);
  }
  for (const std::string& name : {options.link_a, options.link_b}) {
    const std::optional<LinkId> link = model.findLink(name);
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      report.errors.push_back({"link " + quoted(name), "unknown" + suggestion(name, known),
                               "links and objects: " + someOf(known)});
    } else if (report.errors.empty() && link && model.link(*link).collisions.empty() &&
               !robot.link_rules[index(*link)].given) {
      report.errors.push_back(
          {"link " + quoted(name), "without collision geometry", "links with geometry"});
    }
  }
  if (options.link_a == options.link_b) {
    report.errors.push_back({"link " + quoted(options.link_a), "twice", "two different links"});
  }
}

/// Tells of warnings about these files.
void warnOf(const std::vector<std::string>& files, const CycleSetup& setup) {
  for (const Problem& warning : setup.report.warnings) {
    if (std::any_of(files.begin(), files.end(), [&](const std::string& file) {
          return !file.empty() && warning.where.find(file) != std::string::npos;
        })) {
      std::fprintf(stderr, "warning: %s\n", toString(warning).c_str());
    }
  }
}

/// The frame in which the root of the robot stands.
std::string worldFrameOf(const Options& options, const RobotModel& model) {
  const std::string& told = options.world_frame;
  return told.empty() ? model.link(model.robots.front().root).frame
                      : told.substr(told.front() == '/' ? 1 : 0);
}

}  // namespace

Explained makeSetup(const Options& options) {
  SetupReport report;
  const std::vector<RobotDescription> robots = readRobot(options, report);
  const SetupOptions of_setup = readOptions(options, report);
  const ResourceLoader load_resource = fit_tool::makeLoader(options.source);
  SetupInput input = readInput(robots, load_resource, of_setup, report);
  const std::vector<WorldObject> objects = readObjects(options, load_resource, report);
  Explained explained;
  World world;
  std::string frame;
  if (!input.model.robots.empty()) {
    frame = worldFrameOf(options, input.model);
    world = makeWorld(objects, frame, input.model, report);
    explained.positions = defaultPositions(input.model);
    readJoints(input.model, options.joints, explained.positions, report);
    if (!report.awaits_names) {
      checkLinks(options, input, objects, report);
    }
  }
  throwIfErrors(report);
  explained.setup = buildFrom(std::move(input), of_setup, std::move(report));
  if (!options.world.empty()) {
    explained.setup = addWorld(explained.setup, world,
                               prepareObjects(world, of_setup.refine.geometry, {}), frame);
    applyRulesText(of_setup.pair_rules, IdleRule::is_warning, explained.setup);
  }
  warnOf({options.srdf, options.pair_rules, options.shape_rules}, explained.setup);
  return explained;
}

}  // namespace collision_monitor::explain_tool
