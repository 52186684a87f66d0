// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/setup/setup_input.h"

#include <utility>

#include "pipeline/setup/setup_parts.h"

namespace collision_monitor {
namespace {

std::vector<SrdfPairs> readSrdfs(const std::vector<RobotDescription>& robots,
                                 const RobotModel& model, SetupReport& report) {
  std::vector<SrdfPairs> srdfs;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    if (!robots[i].srdf_xml.empty()) {
      srdfs.push_back(readSrdf(robots[i], idAt<RobotId>(i), model, report));
    }
  }
  return srdfs;
}

/// Finds faults of the rules' text that need no links.
void readRulesAlone(const SetupOptions& options, SetupReport& report) {
  SetupReport without_names;
  without_names.awaits_names = true;
  const RobotModel none;
  readShapeRules(options.shape_rules, none, {}, without_names);
  readPairRules(options.pair_rules, none, {}, IdleRule::is_accepted, without_names);
  report.errors.insert(report.errors.end(), without_names.errors.begin(),
                       without_names.errors.end());
}

}  // namespace

SetupInput readInput(const std::vector<RobotDescription>& robots,
                     const ResourceLoader& load_resource, const SetupOptions& options,
                     SetupReport& report) {
  SetupInput input;
  input.model = readRobots(robots, load_resource, report, options.meshes);
  if (input.model.robots.empty()) {
    readRulesAlone(options, report);
    return SetupInput();
  }
  input.srdfs = readSrdfs(robots, input.model, report);
  input.link_rules = readShapeRules(options.shape_rules, input.model, input.srdfs, report);
  padLinks(options.link_paddings, options.where + "link_padding", input.model, input.link_rules,
           report);
  if (options.uses_srdf_spheres) {
    giveSpheres(input.srdfs, input.link_rules);
  }
  input.ignored =
      findNamedPairs(options.ignored_pairs, options.where + "ignore_pairs", input.model, report);
  input.pair_rules =
      readPairRules(options.pair_rules, input.model, input.srdfs, options.idle_rules, report);
  return input;
}

}  // namespace collision_monitor
