// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "explain_setup.h"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "model/nearest_name.h"
#include "model/number_text.h"
#include "model/place.h"
#include "model/world/world_text.h"
#include "pipeline/fits/fit_cache_folder.h"
#include "pipeline/world/add_world.h"
#include "read_robot.h"

namespace collision_monitor::explain_tool {
namespace {

Limits readLimits(const std::vector<std::string>& texts, SetupReport& report) {
  std::vector<std::string> names;
  names.reserve(kLimitFields.size());
  for (const LimitField& field : kLimitFields) {
    names.emplace_back(field.name);
  }
  Limits limits;
  for (const std::string& text : texts) {
    const std::size_t sign = text.rfind('=');
    const std::string name = text.substr(0, sign);
    Eigen::VectorXd value(1);
    const auto field = std::find_if(kLimitFields.begin(), kLimitFields.end(),
                                    [&](const LimitField& one) { return one.name == name; });
    if (field == kLimitFields.end() || sign == std::string::npos ||
        parseNumbers(text.substr(sign + 1), value)) {
      report.errors.push_back({"option --limit", quoted(text) + suggestion(name, names),
                               "NAME=VALUE, with a name of " + joined(names)});
      continue;
    }
    limits.*field->value = value[0];
  }
  return limits;
}

SetupOptions readOptions(const Options& options, SetupReport& report) {
  SetupOptions setup;
  setup.where = "option --limit, ";
  setup.limits = readLimits(options.limits, report);
  setup.fit_cache = fitCacheFolder(options.cache);
  setup.shape_rules = {options.shape_rules,
                       fit_tool::readInput("option --shape-rules", options.shape_rules, report)};
  setup.pair_rules = {options.pair_rules,
                      fit_tool::readInput("option --pair-rules", options.pair_rules, report)};
  // They may name objects and other robots.
  setup.idle_rules = options.world.empty() ? IdleRule::is_warning : IdleRule::is_accepted;
  return setup;
}

/// The objects of a file, beside this robot.
World readObjects(const Options& options, const std::string& world_frame,
                  const ResourceLoader& load_resource, const RobotModel& model) {
  SetupReport report;
  const std::string text = fit_tool::readInput("option --world", options.world, report);
  const std::size_t slash = options.world.rfind('/');
  const std::string folder = slash == std::string::npos ? "" : options.world.substr(0, slash);
  std::vector<WorldObject> objects =
      readWorld({options.world, text, folder}, load_resource, MeshReading(), report);
  KnownPlaces places = placesOf(model, world_frame);
  places.has_frame = [](const std::string& /*frame*/) { return false; };
  places.other_frames = "the world frame, see option --world-frame";
  World world =
      applyChanges(World(), {{ChangeKind::replace_all, std::move(objects), true}}, places, report);
  throwIfErrors(report);
  return world;
}

void warnOfRules(const CycleSetup& setup, const std::string& rules) {
  for (const Problem& warning : setup.report.warnings) {
    if (!rules.empty() && warning.where.find(rules) != std::string::npos) {
      std::fprintf(stderr, "warning: %s\n", toString(warning).c_str());
    }
  }
}

}  // namespace

CycleSetup makeSetup(const Options& options) {
  SetupReport report;
  RobotDescription description = fit_tool::readDescription(options.source, report);
  description.srdf_xml = fit_tool::readInput("option --srdf", options.srdf, report);
  description.srdf_source = options.srdf;
  const SetupOptions of_setup = readOptions(options, report);
  throwIfErrors(report);
  const ResourceLoader load_resource = fit_tool::makeLoader(options.source);
  CycleSetup setup = buildSetup({description}, load_resource, of_setup);
  if (!options.world.empty()) {
    const std::string frame = options.world_frame.empty()
                                  ? setup.model.link(setup.model.robots.front().root).frame
                                  : options.world_frame;
    const World world = readObjects(options, frame, load_resource, setup.model);
    setup = addWorld(setup, world, prepareObjects(world, of_setup.refine.geometry, {}), frame);
    applyRulesText(of_setup.pair_rules, IdleRule::is_warning, setup);
  }
  warnOfRules(setup, options.pair_rules);
  return setup;
}

}  // namespace collision_monitor::explain_tool
