// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>

#include "output_files.h"

namespace collision_monitor::fit_tool {
namespace {

const char* const kAbout =
    "Encloses the links of a robot in spheres, capsules, boxes and rounded boxes as the monitor\n"
    "does, and prints for each collision element how tight they are and that they are proven to\n"
    "enclose it. Writes the files that it is told to, and replaces none without --force.\n";

const char* const kFooter =
    "Columns: volume is that of the shapes over that of the convex hull; overshoot, how far the\n"
    "shapes stick out; inner radius, that of the largest sphere found inside (-: the mesh is\n"
    "open or flat); proof, by how much shapes had to grow to enclose.\n\n"
    "Exit code: 0, done. 1, something that was read or is to be written is at fault; all of it is\n"
    "listed and no file is touched. 2, the command line is at fault.\n\n"
    "Examples:\n"
    "  fit robot.urdf --html fit.html        look at every link\n"
    "  fit robot.urdf --yaml rules.yaml      write the shapes down, edit them, then\n"
    "  fit robot.urdf --rules rules.yaml     see how they do, and give the file to the monitor\n"
    "  fit robot.urdf --link '*_finger' --max-shapes 6";

/// Lengths are finite and not negative. CLI11's own checks accept infinity.
std::string faultOfLength(const std::string& text) {
  double value = -1.0;
  const bool is_length =
      CLI::detail::lexical_cast(text, value) && std::isfinite(value) && value >= 0.0;
  return is_length ? "" : "'" + text + "' is no length; accepted: metres, 0 or more";
}

void addInputs(CLI::App& app, Options& options) {
  const char* const group = "Input";
  CLI::Option* srdf = app.add_option("--srdf", options.srdf, "for rules that name its groups")
                          ->type_name("FILE")
                          ->group(group);
  app.add_flag("--strict", options.is_strict, "names in the SRDF that the URDF lacks are errors")
      ->needs(srdf)
      ->group(group);
  app.add_option("--rules", options.rules,
                 "rules for single links, as config/shape_rules.yaml shows them")
      ->type_name("FILE")
      ->group(group);
  app.add_option("--link", options.link_pattern,
                 "only links of this name; * stands for any characters, ? for one")
      ->type_name("PATTERN")
      ->group(group);
}

void addLimits(CLI::App& app, Options& options, std::vector<std::string>& kinds) {
  constexpr std::uint32_t kMostShapes = 1000;  // as max_shapes_per_link of the node
  const char* const group = "Shapes, by default as the monitor's";
  app.add_option("--max-shapes", options.limits.max_shapes, "that a link may have, 1 to 1000")
      ->check(CLI::Range(1U, kMostShapes).description(""))
      ->type_name("N")
      ->capture_default_str()
      ->group(group);
  app.add_option("--target-overshoot", options.limits.target_overshoot,
                 "a link whose shapes stick out no farther gets no more of them")
      ->check(faultOfLength)
      ->type_name("METRES")
      ->capture_default_str()
      ->group(group);
  app.add_option("--kinds", kinds, "that may be chosen: sphere,capsule,box,rounded_box or some")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember({"sphere", "capsule", "box", "rounded_box"}).description(""))
      ->type_name("LIST")
      ->group(group);
  app.add_option("--padding", options.padding, "that the monitor adds to every shape")
      ->check(faultOfLength)
      ->type_name("METRES")
      ->capture_default_str()
      ->group(group);
}

void addOutputs(CLI::App& app, Options& options) {
  const auto add_file = [&](const char* name, std::string& file, const char* what) {
    app.add_option(name, file, what)->type_name("FILE")->group("Output");
  };
  if (kHasPictures) {
    add_file("--html", options.html, "a page with a picture and figures of each link");
  }
  add_file("--yaml", options.yaml, "the shapes as rules, for --rules and the monitor");
  add_file("--urdf", options.new_urdf, "the robot with its shapes as <collision> and <visual>");
  add_file("--spheres-yaml", options.spheres_yaml, "sphere hierarchies about the links");
  add_file("--spheres-srdf", options.spheres_srdf,
           "one level of them as <link_sphere_approximation> of an SRDF");
  addForceOption(app, options.may_replace);
  app.add_option("--sphere-level", options.sphere_level,
                 "of --spheres-srdf; 0: one sphere an element; default: the leaves")
      ->type_name("N")
      ->group("Output");
  app.add_option("--leaves", options.leaves,
                 "finest spheres that a collision element may have, 1 to 100000")
      ->check(CLI::Range(std::size_t{1}, std::size_t{100000}).description(""))
      ->type_name("N")
      ->capture_default_str()
      ->group("Output");
}

/// Checks options that depend on each other.
void checkTogether(const Options& options) {
  checkOneRobot(options.source);
  std::vector<std::filesystem::path> targets;
  for (const auto& [option, file] : outputsOf(options)) {
    for (const InputFile& input : {InputFile{"robot", options.source.urdf},
                                   {"SRDF", options.srdf},
                                   {"file of rules", options.rules}}) {
      checkKeeps(input, option, file);
    }
    const std::filesystem::path target = targetOf(file);
    if (std::find(targets.begin(), targets.end(), target) != targets.end()) {
      throw CLI::ValidationError("two options write '" + file + "'");
    }
    targets.push_back(target);
  }
}

ShapeKinds kindsOf(const std::vector<std::string>& names) {
  const auto holds = [&](const char* name) {
    return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
  };
  return {holds("sphere"), holds("capsule"), holds("box"), holds("rounded_box")};
}

}  // namespace

std::vector<OutputOption> outputsOf(const Options& options) {
  std::vector<OutputOption> outputs;
  for (const OutputOption& output : {OutputOption{"--yaml", options.yaml},
                                     {"--urdf", options.new_urdf},
                                     {"--html", options.html},
                                     {"--spheres-yaml", options.spheres_yaml},
                                     {"--spheres-srdf", options.spheres_srdf}}) {
    if (!output.file.empty()) {
      outputs.push_back(output);
    }
  }
  return outputs;
}

Parsed parseOptions(int argc, const char* const* argv) {
  Parsed parsed;
  CLI::App app{kAbout, "fit"};
  app.footer(kFooter);
  std::vector<std::string> kinds;
  bool has_no_cache = false;
  addRobotOptions(app, parsed.options.source);
  addInputs(app, parsed.options);
  addLimits(app, parsed.options, kinds);
  addCacheOptions(app, parsed.options.cache, has_no_cache);
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
