// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/setup/setup_input.h"

#include <utility>

#include "model/urdf/read_links.h"
#include "pipeline/setup/setup_parts.h"

namespace collision_monitor {
namespace {

std::vector<SrdfPairs> readSrdfs(const std::vector<RobotDescription>& robots,
                                 const RobotModel& model, SetupReport& report) {
  std::vector<SrdfPairs> srdfs;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    if (!robots[i].srdf_xml.empty()) {
      const std::size_t before = report.errors.size();
      srdfs.push_back(readSrdf(robots[i], idAt<RobotId>(i), model, report));
      report.awaits_names = report.awaits_names || report.errors.size() > before;  // its groups
    }
  }
  return srdfs;
}

}  // namespace

SetupInput readInput(const std::vector<RobotDescription>& robots,
                     const ResourceLoader& load_resource, const SetupOptions& options,
                     SetupReport& report) {
  SetupInput input;
  input.model = readLinks(robots, load_resource, report, options.meshes);
  report.awaits_names = report.awaits_names || robots.empty();
  if (input.model.robots.size() == robots.size()) {
    input.srdfs = readSrdfs(robots, input.model, report);
  }
  input.link_rules = readShapeRules(options.shape_rules, input.model, input.srdfs, report);
  padLinks(options.link_paddings, options.where + "link_padding", input.model, input.link_rules,
           report);
  if (options.uses_srdf_spheres) {
    giveSpheres(input.srdfs, input.link_rules);
  }
  input.ignored =
      findNamedPairs(options.ignored_pairs, options.where + "ignore_pairs", input.model, report);
  input.pair_rules =
      readPairRules(options.pair_rules, input.model, input.srdfs,
                    report.awaits_names ? IdleRule::is_accepted : options.idle_rules, report);
  return input;
}

}  // namespace collision_monitor
