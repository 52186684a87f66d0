// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <filesystem>

#include "check_srdf.h"
#include "geometry/rpy.h"
#include "merge_srdf.h"
#include "model/frame_names.h"
#include "model/number_text.h"
#include "output_files.h"
#include "pairs_options.h"
#include "pipeline/fits/fit_cache_folder.h"
#include "progress.h"
#include "read_robot.h"
#include "report.h"

/// Finds which pairs of links can touch: `pairs --help`.
namespace collision_monitor::pairs_tool {
namespace {

constexpr int kDone = 0;
constexpr int kInputFault = 1;
constexpr int kDisabledTouch = 1;

std::string readSrdfText(const Options& options, const std::string& robot_name,
                         SetupReport& report) {
  std::string text = fit_tool::readInput("option --write-srdf", options.write_srdf, report);
  if (report.errors.empty()) {
    checkMergeable(options.write_srdf, text, robot_name, "--write-srdf", report);
  }
  return text;
}

/// Whether there is an SRDF to update. Checked before the long work, as are its faults.
bool checkOutput(const Options& options, const std::string& robot_name, SetupReport& report) {
  if (options.write_srdf.empty()) {
    return false;
  }
  const bool merges = !options.may_replace && std::filesystem::is_regular_file(options.write_srdf);
  fit_tool::checkWritable("option --write-srdf",
                          {options.write_srdf, "", merges || options.may_replace}, report);
  if (merges && report.errors.empty()) {
    readSrdfText(options, robot_name, report);
  }
  return merges;
}

/// Includes every pair, even those that overlap in the default pose.
CycleSetup makeSetup(const Options& options, const std::vector<RobotDescription>& descriptions,
                     const fit_tool::Progress& progress) {
  SetupOptions setup_options;
  setup_options.ignore_default_overlap = false;
  setup_options.fit_cache = fitCacheFolder(options.cache);
  setup_options.fit_progress = [&](const std::string& link, std::size_t done, std::size_t total) {
    progress.show("fitting", link, done, total);
  };
  return buildSetup(descriptions, fit_tool::makeLoader(options.source), setup_options);
}

/// Leaves out warnings about pairs: the table has these.
void printWarnings(const SetupReport& report) {
  for (const Problem& warning : report.warnings) {
    if (warning.where.rfind("pair", 0) != 0) {
      std::fprintf(stderr, "warning: %s\n", toString(warning).c_str());
    }
  }
}

WorkProgress showTenths(const fit_tool::Progress& progress, const std::string& work,
                        const std::string& unit) {
  return
      [&progress, work, unit, shown = std::size_t{0}](std::size_t done, std::size_t total) mutable {
        constexpr std::size_t kAll = 10;
        const std::size_t tenths = total == 0 ? kAll : kAll * done / total;
        if (tenths != shown) {
          shown = tenths;
          progress.show(work, std::to_string(total) + unit, tenths, kAll);
        }
      };
}

/// By RobotId.
std::vector<Pose> rootsOf(const SeveralRobots& robots) {
  std::vector<std::string> prefixes{trimmedPrefix(robots.prefix)};
  for (const OtherRobot& other : robots.others) {
    prefixes.push_back(other.prefix);
  }
  std::vector<Pose> roots(prefixes.size());
  for (const Place& place : robots.places) {
    for (std::size_t i = 0; i < prefixes.size(); ++i) {
      if (prefixes[i] == place.prefix) {
        roots[i] = {rotationOfRpy(place.rpy), place.xyz};
      }
    }
  }
  return roots;
}

std::vector<RobotDescription> readAll(const Options& options, SetupReport& report) {
  std::vector<RobotDescription> descriptions{fit_tool::readDescription(options.source, report)};
  descriptions.front().tf_prefix = options.robots.prefix;
  for (const OtherRobot& other : options.robots.others) {
    fit_tool::RobotSource source = options.source;
    source.parameter.clear();
    source.urdf = other.urdf;
    descriptions.push_back(fit_tool::readDescription(source, report));
    descriptions.back().tf_prefix = other.prefix;
  }
  return descriptions;
}

std::vector<PairFound> search(const CycleSetup& setup, const Options& options,
                              const fit_tool::Progress& progress) {
  PairSearchOptions search = options.search;
  search.world_from_root = rootsOf(options.robots);
  search.state_progress = showTenths(progress, "drawing", " states");
  search.proof_progress =
      showTenths(progress, "proving", " pairs for at most " + shortText(search.time_limit) + " s");
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  std::vector<PairFound> pairs = searchPairs(setup, search);
  std::fprintf(stderr, "states and proofs took %.2f s\n",
               std::chrono::duration<double>(Clock::now() - start).count());
  return pairs;
}

void printList(const char* head, const std::vector<std::string>& items) {
  for (std::size_t i = 0; i < items.size(); ++i) {
    std::printf("%s%s\n", i == 0 ? head : "  ", items[i].c_str());
  }
}

void printMerge(const std::string& path, const SrdfMerge& merge, bool is_changed) {
  std::printf("%s %s: %zu pairs added, %zu taken out, %zu kept\n",
              is_changed ? "brought up to date" : "nothing to change in", path.c_str(), merge.added,
              merge.taken_out.size(), merge.kept);
  printList("taken out:\n  ", merge.taken_out);
  printList("kept, though they touch in some states:\n  ", merge.doubted);
}

/// Reads the file again, because it may have changed meanwhile.
/// @return number of pairs that were left out for lack of a proof.
std::size_t updateSrdf(const Options& options, const RobotModel& model,
                       const std::vector<PairFound>& pairs, const PairLines& lines) {
  SetupReport report;
  const std::string former = readSrdfText(options, model.robots.front().name, report);
  throwIfErrors(report);
  const SrdfMerge merge = mergeSrdf(former, model, pairs, lines);
  const bool is_changed = merge.text != former;
  if (is_changed) {
    fit_tool::writeFiles({{options.write_srdf, merge.text, true}});
  }
  printMerge(options.write_srdf, merge, is_changed);
  return merge.left_out;
}

/// @return as updateSrdf.
std::size_t makeSrdf(const Options& options, const RobotModel& model, const PairLines& lines) {
  const std::string text = newSrdf(model.robots.front().name, lines.lines);
  fit_tool::writeFiles({{options.write_srdf, text, options.may_replace}});
  std::printf("wrote %s\n", options.write_srdf.c_str());
  return lines.left_out.size();
}

void printLeftOut(std::size_t left_out) {
  if (left_out > 0) {
    std::printf(
        "left out %zu pairs that are Never or Always in the states drawn, but not proven; "
        "--trust-samples writes them\n",
        left_out);
  }
}

void writeFiles(const Options& options, bool merges, const RobotModel& model,
                const std::vector<PairFound>& pairs) {
  const PairLines lines = linesOf(model, pairs, options.trusts_samples);
  if (!options.write_yaml.empty()) {
    fit_tool::writeFiles(
        {{options.write_yaml, ignoredPairsYaml(lines.lines), options.may_replace}});
    std::printf("wrote %s\n", options.write_yaml.c_str());
  }
  if (!options.write_srdf.empty()) {
    printLeftOut(merges ? updateSrdf(options, model, pairs, lines)
                        : makeSrdf(options, model, lines));
  } else if (!options.write_yaml.empty()) {
    printLeftOut(lines.left_out.size());
  }
}

/// The SRDF of --check; its faults are known before the long work.
std::string readCheck(const Options& options, const std::string& robot_name, SetupReport& report) {
  std::string text = fit_tool::readInput("option --check", options.check, report);
  if (!options.check.empty() && report.errors.empty()) {
    checkMergeable(options.check, text, robot_name, "--check", report);
  }
  return text;
}

/// @return the exit code
int check(const Options& options, RobotDescription description, const std::string& srdf,
          const RobotModel& model, const std::vector<PairFound>& pairs) {
  SetupReport report;
  description.srdf_xml = srdf;
  description.srdf_source = options.check;
  const SrdfCheck found = checkSrdf(description, model, pairs, report);
  throwIfErrors(report);
  printWarnings(report);
  std::fputs(textOf(found).c_str(), stdout);
  return found.touching.empty() ? kDone : kDisabledTouch;
}

int run(const Options& options) {
  const fit_tool::Progress progress(stderr, isatty(STDERR_FILENO) != 0);
  SetupReport report;
  const std::vector<RobotDescription> descriptions = readAll(options, report);
  const std::string robot_name = robotNameOf(descriptions.front().urdf_xml);
  const std::string srdf = readCheck(options, robot_name, report);
  const bool merges = checkOutput(options, robot_name, report);
  if (!options.write_yaml.empty()) {
    fit_tool::checkWritable("option --write-yaml", {options.write_yaml, "", options.may_replace},
                            report);
  }
  throwIfErrors(report);
  const CycleSetup setup = makeSetup(options, descriptions, progress);
  printWarnings(setup.report);
  const std::vector<PairFound> pairs = search(setup, options, progress);
  std::fputs(tableOf(setup.model, pairs, options.search.states).c_str(), stdout);
  const int answer = options.check.empty()
                         ? kDone
                         : check(options, descriptions.front(), srdf, setup.model, pairs);
  writeFiles(options, merges, setup.model, pairs);
  return answer;
}

}  // namespace
}  // namespace collision_monitor::pairs_tool

int main(int argc, char** argv) {
  using namespace collision_monitor::pairs_tool;
  try {
    const Parsed parsed = parseOptions(argc, argv);
    return parsed.is_to_run ? run(parsed.options) : parsed.exit_code;
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "pairs: %s\n", collision_monitor::failureText(fault).c_str());
    return kInputFault;
  }
}
