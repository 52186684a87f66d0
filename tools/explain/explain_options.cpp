// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "explain_options.h"

#include <CLI/CLI.hpp>

namespace collision_monitor::explain_tool {
namespace {

const char* const kAbout =
    "Says whether two links or objects are checked, which rule says so and where it stands, how\n"
    "far apart they are in the default pose or in another, what a monitor would say of that at\n"
    "rest, and by which limits.\n"
    "Of a monitor that runs, its service explain_pair says the same, and how near they have "
    "been.\n";

const char* const kFooter =
    "Exit code: 0, done. 1, something that was read is at fault, all of it is listed. 2, the\n"
    "command line is at fault.\n\n"
    "Examples:\n"
    "  explain robot.urdf hand base_link --srdf robot.srdf\n"
    "  explain robot.urdf hand camera --pair-rules pair_rules.yaml --joint elbow=1.2\n"
    "  explain robot.urdf hand table --world cell.yaml --limit warning_distance=0.1";

void addFiles(CLI::App& app, Options& options) {
  const char* const group = "Input";
  app.add_option("--srdf", options.srdf, "of the robot")->type_name("FILE")->group(group);
  app.add_option("--pair-rules", options.pair_rules, "as the monitor's parameter pair_rules")
      ->type_name("FILE")
      ->group(group);
  app.add_option("--shape-rules", options.shape_rules, "as the monitor's parameter shape_rules")
      ->type_name("FILE")
      ->group(group);
  app.add_option(
         "--world", options.world,
         "objects, as the monitor's parameter world_file. Frames are those of links or the\n"
         "world frame")
      ->type_name("FILE")
      ->group(group);
  app.add_option("--world-frame", options.world_frame,
                 "where the root of the robot stands; without it that is its own frame")
      ->type_name("FRAME")
      ->group(group);
  app.add_option("--limit", options.limits,
                 "as in the monitor's parameter limits; may be given several times")
      ->allow_extra_args(false)
      ->type_name("NAME=VALUE")
      ->group(group);
  app.add_option("--joint", options.joints,
                 "its position, [rad] or [m]; may be given several times. Others are at 0, or at\n"
                 "the middle of their limits if these exclude 0")
      ->allow_extra_args(false)
      ->type_name("NAME=POSITION")
      ->group(group);
}

}  // namespace

Parsed parseOptions(int argc, const char* const* argv) {
  Parsed parsed;
  Options& options = parsed.options;
  CLI::App app{kAbout, "explain"};
  app.footer(kFooter);
  bool has_no_cache = false;
  fit_tool::addRobotOptions(app, options.source);
  app.add_option("link_a", options.link_a, "the one link")->type_name("LINK");
  app.add_option("link_b", options.link_b, "the other link")->type_name("LINK");
  addFiles(app, options);
  fit_tool::addCacheOptions(app, options.cache, has_no_cache);
  try {
    app.parse(argc, argv);
    if (!options.source.parameter.empty() && options.link_b.empty()) {
      // With --param there is no URDF before the links.
      options.link_b = options.link_a;
      options.link_a = options.source.urdf;
      options.source.urdf.clear();
    }
    fit_tool::checkOneRobot(options.source);
    if (options.link_a.empty() || options.link_b.empty()) {
      throw CLI::ValidationError("give the names of two links");
    }
  } catch (const CLI::ParseError& fault) {
    parsed.exit_code = app.exit(fault) == 0 ? 0 : fit_tool::kUsageFault;
    return parsed;
  }
  if (has_no_cache) {
    options.cache = "none";
  }
  parsed.is_to_run = true;
  return parsed;
}

}  // namespace collision_monitor::explain_tool
