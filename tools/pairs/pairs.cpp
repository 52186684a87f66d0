// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <unistd.h>

#include <chrono>
#include <cstdio>

#include "output_files.h"
#include "pairs_options.h"
#include "progress.h"
#include "read_robot.h"
#include "report.h"
#include "ros_edge/fit_options.h"

/// Finds out which pairs of links can touch: `pairs --help`.
namespace collision_monitor::pairs_tool {
namespace {

constexpr int kDone = 0;
constexpr int kInputFault = 1;

/// Every pair counts, also those that overlap in the default pose.
CycleSetup makeSetup(const Options& options, const fit_tool::Progress& progress) {
  SetupReport report;
  const RobotDescription description = fit_tool::readDescription(options.source, report);
  if (!options.srdf.empty()) {
    fit_tool::checkWritable("option --srdf", options.srdf, report);
  }
  throwIfErrors(report);
  SetupOptions setup_options;
  setup_options.ignore_default_overlap = false;
  setup_options.fit_cache = fitCacheFolder(options.cache);
  setup_options.fit_progress = [&](const std::string& link, std::size_t done, std::size_t total) {
    progress.show("fitting", link, done, total);
  };
  return buildSetup({description}, fit_tool::makeLoader(options.source.package_roots),
                    setup_options);
}

/// What it says of pairs, the table says better.
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

int run(const Options& options) {
  const fit_tool::Progress progress(stderr, isatty(STDERR_FILENO) != 0);
  const CycleSetup setup = makeSetup(options, progress);
  printWarnings(setup.report);
  PairSearchOptions search = options.search;
  search.state_progress = showTenths(progress, "drawing", " states");
  search.proof_progress = showTenths(progress, "proving", " pairs");
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  const std::vector<PairFound> pairs = searchPairs(setup, search);
  std::fprintf(stderr, "states and proofs took %.2f s\n",
               std::chrono::duration<double>(Clock::now() - start).count());
  std::fputs(tableOf(setup.model, pairs, options.search.states).c_str(), stdout);
  if (!options.srdf.empty()) {
    const PairSrdf srdf = writeSrdf(setup.model, pairs, options.trusts_samples);
    fit_tool::writeFiles({{options.srdf, srdf.text}});
    std::printf("wrote %s\n", options.srdf.c_str());
    if (srdf.left_out > 0) {
      std::printf(
          "left out %zu pairs that were never seen to touch and are not proven apart; "
          "--trust-samples writes them\n",
          srdf.left_out);
    }
  }
  return kDone;
}

}  // namespace
}  // namespace collision_monitor::pairs_tool

int main(int argc, char** argv) {
  using namespace collision_monitor::pairs_tool;
  try {
    const Parsed parsed = parseOptions(argc, argv);
    return parsed.is_to_run ? run(parsed.options) : parsed.exit_code;
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "pairs: %s\n", fault.what());
    return kInputFault;
  }
}
