// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "options.h"

#include <CLI/CLI.hpp>
#include <cmath>

namespace collision_monitor::fit_tool {
namespace {

constexpr int kUsageFault = 2;

const char* const kAbout =
    "Encloses the links of a robot in spheres, capsules, boxes and rounded boxes as the monitor "
    "does, and prints for each collision element how tight they are and that they are proven to "
    "enclose it. Changes nothing but the files that it is told to write.";

const char* const kFooter =
    "Columns: volume is that of the shapes over that of the convex hull; overshoot is how far the "
    "shapes stick out; inner radius is that of the largest sphere found inside (-: the mesh is "
    "open); proof says by how much shapes had to grow to enclose.\n"
    "Exit code: 0 done; 1 something that was read or is to be written is at fault, all of it "
    "listed; 2 the command line is.\n\n"
    "  fit robot.urdf --html fit.html          look at every link\n"
    "  fit robot.urdf --yaml rules.yaml        write the shapes down, edit them, then\n"
    "  fit robot.urdf --rules rules.yaml       see how they do, and give the file to the monitor\n"
    "  fit --param /robot_description --link '*_finger' --max-shapes 6";

/// Lengths are finite and not negative; CLI11's own checks let infinity pass.
std::string faultOfLength(const std::string& text) {
  double value = -1.0;
  const bool is_length =
      CLI::detail::lexical_cast(text, value) && std::isfinite(value) && value >= 0.0;
  return is_length ? "" : "'" + text + "' is no length; accepted: metres, 0 or more";
}

void addInputs(CLI::App& app, Options& options) {
  app.add_option("urdf", options.urdf, "URDF file, or - for standard input");
  app.add_option("--param", options.parameter,
                 "read the URDF from this parameter of a running roscore instead");
  app.add_option("--srdf", options.srdf, "SRDF file, for rules that name its groups");
  app.add_option("--package-root", options.package_roots,
                 "folder that holds packages, or is one: looked at for package:// names before "
                 "ROS_PACKAGE_PATH; may be given several times")
      ->allow_extra_args(false);
}

void addLimits(CLI::App& app, Options& options, std::vector<std::string>& kinds) {
  constexpr std::uint32_t kMostShapes = 1000;  // as max_shapes_per_link of the node
  app.add_option("--max-shapes", options.limits.max_shapes, "shapes a link may have, 1 to 1000")
      ->check(CLI::Range(1U, kMostShapes))
      ->capture_default_str();
  app.add_option("--target-overshoot", options.limits.target_overshoot,
                 "[m] a link whose shapes stick out no farther gets no more of them")
      ->check(faultOfLength)
      ->capture_default_str();
  app.add_option("--kinds", kinds,
                 "kinds of shape that may be chosen, of sphere,capsule,box,rounded_box; default: "
                 "all")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember({"sphere", "capsule", "box", "rounded_box"}));
  app.add_option("--padding", options.padding, "[m] that the monitor adds to every shape")
      ->check(faultOfLength)
      ->capture_default_str();
  app.add_option("--rules", options.rules,
                 "file with rules for single links, as config/shape_rules.yaml");
  app.add_option("--link", options.link_pattern,
                 "only links of this name; * stands for any characters, ? for one");
}

void addOutputs(CLI::App& app, Options& options) {
  app.add_option("--yaml", options.yaml, "write the shapes as rules, for --rules and the monitor");
  app.add_option("--urdf", options.new_urdf,
                 "write the robot with its shapes as <collision> and <visual>, for rviz");
  app.add_option("--html", options.html, "write a page with a picture and figures of each link");
  app.add_option("--spheres-yaml", options.spheres_yaml,
                 "write sphere hierarchies about the links, every level");
  app.add_option("--spheres-srdf", options.spheres_srdf,
                 "write one level of them as <link_sphere_approximation> of an SRDF");
  app.add_option("--sphere-level", options.sphere_level,
                 "level for --spheres-srdf, 0 is one sphere an element; default: the leaves");
  app.add_option("--leaves", options.leaves,
                 "finest spheres a collision element may have, 1 to 100000")
      ->check(CLI::Range(std::size_t{1}, std::size_t{100000}))
      ->capture_default_str();
}

/// What one option cannot know of the others.
void checkTogether(const Options& options) {
  if (options.urdf.empty() == options.parameter.empty()) {
    throw CLI::ValidationError("give one robot: a URDF file, - or --param NAME");
  }
  std::vector<std::string> outputs{options.yaml, options.new_urdf, options.html,
                                   options.spheres_yaml, options.spheres_srdf};
  std::sort(outputs.begin(), outputs.end());
  for (std::size_t i = 1; i < outputs.size(); ++i) {
    if (!outputs[i].empty() && outputs[i] == outputs[i - 1]) {
      throw CLI::ValidationError("two options write '" + outputs[i] + "'");
    }
  }
  if (!options.new_urdf.empty() && options.new_urdf == options.urdf) {
    throw CLI::ValidationError("--urdf would replace the robot that is read; name another file");
  }
}

ShapeKinds kindsOf(const std::vector<std::string>& names) {
  const auto holds = [&](const char* name) {
    return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
  };
  return {holds("sphere"), holds("capsule"), holds("box"), holds("rounded_box")};
}

}  // namespace

Parsed parseOptions(int argc, const char* const* argv) {
  Parsed parsed;
  CLI::App app{kAbout, "fit"};
  app.footer(kFooter);
  std::vector<std::string> kinds;
  bool has_no_cache = false;
  addInputs(app, parsed.options);
  addLimits(app, parsed.options, kinds);
  CLI::Option* cache = app.add_option(
      "--cache", parsed.options.cache,
      "folder that keeps fits; default: the monitor's, ~/.ros/collision_monitor/fits");
  app.add_flag("--no-cache", has_no_cache, "fit anew and keep nothing")->excludes(cache);
  addOutputs(app, parsed.options);
  try {
    app.parse(argc, argv);
    checkTogether(parsed.options);
  } catch (const CLI::ParseError& fault) {
    parsed.exit_code = app.exit(fault) == 0 ? 0 : kUsageFault;
    return parsed;
  }
  parsed.options.limits.kinds = kindsOf(kinds);
  if (has_no_cache) {
    parsed.options.cache = "none";
  }
  parsed.is_to_run = true;
  return parsed;
}

}  // namespace collision_monitor::fit_tool
