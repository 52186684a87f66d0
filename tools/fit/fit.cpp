// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <unistd.h>

#include <cstdio>

#include "options.h"
#include "output_files.h"
#include "outputs/exports.h"
#include "pictures/write_html.h"
#include "pipeline/fits/fit_cache_folder.h"
#include "progress.h"
#include "read_robot.h"
#include "sphere_overlaps.h"
#include "table.h"

/// Encloses a robot's links and reports how well: `fit --help`.
namespace collision_monitor::fit_tool {
namespace {

constexpr int kDone = 0;
constexpr int kInputFault = 1;

void checkOutputs(const Options& options, SetupReport& report) {
  for (const auto& [option, file] : outputsOf(options)) {
    checkWritable(std::string("option ") + option, {file, "", options.may_replace}, report);
  }
}

void warn(const std::vector<Problem>& warnings) {
  for (const Problem& warning : warnings) {
    std::fprintf(stderr, "warning: %s\n", toString(warning).c_str());
  }
}

void addPage(const Options& options, const RobotDescription& description, const FittedRobot& robot,
             const Progress& progress, std::vector<OutputFile>& files) {
  if (!options.html.empty()) {
    const auto show = [&](const std::string& link, std::size_t done, std::size_t total) {
      progress.show("drawing", link, done, total);
    };
    files.push_back(
        {options.html, writeHtml(robot, description.source, show), options.may_replace});
  }
}

std::vector<OutputFile> makeOutputs(const Options& options, const RobotDescription& description,
                                    const FittedRobot& robot, const Progress& progress) {
  std::vector<OutputFile> files;
  if (!options.yaml.empty()) {
    files.push_back({options.yaml, writeRules(robot), options.may_replace});
  }
  if (!options.new_urdf.empty()) {
    files.push_back(
        {options.new_urdf, writeShapeUrdf(robot, description.urdf_xml), options.may_replace});
  }
  if constexpr (kHasPictures) {
    addPage(options, description, robot, progress, files);
  }
  if (options.spheres_yaml.empty() && options.spheres_srdf.empty()) {
    return files;
  }
  const std::vector<LinkSpheres> spheres = buildSpheres(robot, options.leaves);
  warn(sphereOverlaps(robot.model, spheres));
  if (!options.spheres_yaml.empty()) {
    files.push_back({options.spheres_yaml, toYaml(spheres), options.may_replace});
  }
  if (!options.spheres_srdf.empty()) {
    files.push_back({options.spheres_srdf, writeSphereSrdf(robot, spheres, options.sphere_level),
                     options.may_replace});
  }
  return files;
}

int run(const Options& options) {
  SetupReport report;
  RobotDescription description = readDescription(options.source, report);
  description.srdf_source = options.srdf;
  description.srdf_xml = readInput("option --srdf", options.srdf, report);
  description.is_strict = options.is_strict;
  FitRequest request{options.limits, options.padding, readRules(options.rules, report),
                     fitCacheFolder(options.cache), options.link_pattern};
  checkOutputs(options, report);
  throwIfErrors(report);

  const Progress progress(stderr, isatty(STDERR_FILENO) != 0);
  const auto show = [&](const std::string& link, std::size_t done, std::size_t total) {
    progress.show("fitting", link, done, total);
  };
  const FittedRobot robot = fitRobot(description, makeLoader(options.source), request, show);
  warn(robot.report.warnings);
  std::fputs(tableOf(robot).c_str(), stdout);
  const std::vector<OutputFile> files = makeOutputs(options, description, robot, progress);
  writeFiles(files);
  for (const OutputFile& file : files) {
    std::printf("wrote %s\n", file.path.c_str());
  }
  return kDone;
}

}  // namespace
}  // namespace collision_monitor::fit_tool

int main(int argc, char** argv) {
  using namespace collision_monitor::fit_tool;
  try {
    const Parsed parsed = parseOptions(argc, argv);
    return parsed.is_to_run ? run(parsed.options) : parsed.exit_code;
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "fit: %s\n", collision_monitor::failureText(fault).c_str());
    return kInputFault;
  }
}
