// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "comparison.h"
#include "exact_comparison.h"
#include "model/mesh_files/regular_file.h"
#include "read_robot.h"

/// Compares our distances and verdicts with FCL's, on the enclosing shapes of a robot.
namespace collision_monitor {
namespace {

// Exit codes, the same for all programs.
constexpr int kDone = 0;
constexpr int kFault = 1;
constexpr int kUsageFault = 2;

RobotDescription describe(const std::string& urdf, const std::string& srdf) {
  RobotDescription description;
  description.source = urdf;
  description.urdf_xml = readRegularFile(urdf);
  description.srdf_source = srdf;
  description.srdf_xml = srdf.empty() ? "" : readRegularFile(srdf);
  description.directory = std::filesystem::absolute(urdf).parent_path().string();
  return description;
}

void printKinds(const Comparison& comparison) {
  std::printf("%-26s %10s %10s %12s %8s %8s %12s %8s %12s\n", "shapes", "separated", "overlaps",
              "worst [m]", "for us", "for FCL", "FCL off [m]", "depths", "worst [m]");
  for (const auto& [kind, tally] : comparison.kinds) {
    std::printf("%-26s %10zu %10zu %12.1e %8zu %8zu %12.1e %8zu %12.1e\n", kind.c_str(),
                tally.separated, tally.overlapping, tally.worst_against_fcl, tally.decided_for_us,
                tally.decided_for_fcl, tally.worst_of_fcl, tally.depths, tally.worst_depth);
  }
}

void printDisagreements(const Comparison& comparison) {
  if (!comparison.disagreements.empty()) {
    std::printf("differences of more than %.0e m, decided by the exact reference:\n", kTolerance);
  }
  for (const Disagreement& one : comparison.disagreements) {
    std::printf("  %s: ours %.9f, FCL %.9f, reference %.9f m\n", one.pair.c_str(), one.ours,
                one.fcl, one.reference);
  }
}

/// Prints one machine-readable line.
bool printResult(const Comparison& comparison) {
  double against_fcl = 0.0;
  double depth = 0.0;
  std::size_t for_us = 0;
  std::size_t for_fcl = 0;
  for (const auto& [kind, tally] : comparison.kinds) {
    against_fcl = std::max(against_fcl, tally.worst_against_fcl);
    depth = std::max(depth, tally.worst_depth);
    for_us += tally.decided_for_us;
    for_fcl += tally.decided_for_fcl;
  }
  const bool agrees = for_fcl == 0 && comparison.wrong_verdicts == 0 && depth <= kTolerance;
  std::printf(
      "poses %zu, verdicts %zu, wrong %zu, worst against FCL %.1e m, worst depth %.1e m, "
      "decided for us %zu, decided against us %zu: %s\n",
      comparison.poses, comparison.verdicts, comparison.wrong_verdicts, against_fcl, depth, for_us,
      for_fcl, agrees ? "agrees" : "DIFFERS");
  return agrees;
}

/// No motion checks: successive random poses are no motion.
SetupOptions optionsForPoses() {
  SetupOptions options;
  options.is_continuous = false;
  return options;
}

/// Without pairs there is nothing to compare, and agreement would mean nothing.
void checkHasPairs(const CycleSetup& setup) {
  if (setup.table.size() == 0) {
    throw std::runtime_error("no pair of links is checked, so there is nothing to compare");
  }
}

int compare(const RobotDescription& robot, const ComparisonOptions& options) {
  SetupOptions setup_options = optionsForPoses();
  setup_options.refine.geometry = RefineGeometry::none;  // FCL gets the enclosing shapes
  const CycleSetup setup = buildSetup({robot}, fit_tool::makeLoader(), setup_options);
  checkHasPairs(setup);
  std::printf("%s: %zu links, %zu shapes, %zu link pairs checked, %zu shape pairs\n",
              robot.source.c_str(), setup.model.links.size(), setup.bodies.size(),
              setup.checked.size(), setup.table.size());
  const Comparison comparison = compareWithFcl(setup, options);
  printKinds(comparison);
  printDisagreements(comparison);
  return printResult(comparison) ? kDone : kFault;
}

double percent(std::size_t part, std::size_t whole) {
  return whole == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

int compareExact(const RobotDescription& robot, const ComparisonOptions& options) {
  const CycleSetup setup = buildSetup({robot}, fit_tool::makeLoader(), optionsForPoses());
  checkHasPairs(setup);
  const ExactComparison found = compareExactly(setup, options);
  for (const std::string& line : found.wrong) {
    std::printf("wrong: %s\n", line.c_str());
  }
  if (found.undecided > 0) {
    std::printf(
        "undecided: %zu verdicts, where a link reaches just into the mouth of an open mesh "
        "(winding number 0.50 to 0.52): either answer is right\n",
        found.undecided);
  }
  const std::size_t wrong = found.missed + found.wrong_contacts;
  const bool agrees = wrong + found.complete_wrong == 0;
  std::printf(
      "poses %zu, verdicts %zu, wrong %zu (%zu missed), contacts %zu; of %zu contacts of enclosing "
      "shapes %.2f %% false, refined %.2f %%; left by the budget %.4f a pose, without one wrong "
      "%zu: "
      "%s\n",
      found.poses, found.pairs, wrong, found.missed, found.contacts, found.enclosing_contacts,
      percent(found.enclosing_alarms, found.enclosing_contacts),
      percent(found.refined_alarms, found.enclosing_contacts),
      static_cast<double>(found.left) / static_cast<double>(std::max<std::size_t>(1, found.poses)),
      found.complete_wrong, agrees ? "agrees" : "DIFFERS");
  return agrees ? kDone : kFault;
}

int run(int argc, char** argv) {
  CLI::App app{
      "Measures every checked pair of a robot's enclosing shapes at random poses, with this "
      "package and with FCL, and lets a slow exact reference decide where they differ.",
      "compare_with_fcl"};
  app.footer(
      "Exit code: 0, they agree. 1, the reference is against us, or the robot cannot be read or "
      "has no pair to compare. 2, the command line is at fault.");
  std::string urdf;
  std::string srdf;
  ComparisonOptions options;
  app.add_option("urdf", urdf, "URDF file; package:// names are looked up by ROS_PACKAGE_PATH");
  app.add_option("--srdf", srdf, "SRDF file with the pairs to ignore");
  constexpr std::size_t kMost = 1000000000;
  app.add_option("--poses", options.poses, "random poses, 1 to 1000000000")
      ->check(CLI::Range(std::size_t{1}, kMost).description(""))
      ->capture_default_str();
  app.add_option("--seed", options.seed, "seed of the random poses")->capture_default_str();
  app.add_option("--depths", options.most_depths, "overlaps whose depth is checked")
      ->capture_default_str();
  bool is_exact = false;
  app.add_flag("--exact", is_exact,
               "compare verdicts of the geometries themselves instead, and count false alarms of "
               "enclosing shapes");
  try {
    app.parse(argc, argv);
    // Not by required(): CLI11 checks that before it reports unknown options.
    if (urdf.empty()) {
      throw CLI::RequiredError("urdf");
    }
  } catch (const CLI::ParseError& fault) {
    return app.exit(fault) == 0 ? kDone : kUsageFault;
  }
  return is_exact ? compareExact(describe(urdf, srdf), options)
                  : compare(describe(urdf, srdf), options);
}

}  // namespace
}  // namespace collision_monitor

int main(int argc, char** argv) {
  try {
    return collision_monitor::run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr,
                 "compare_with_fcl: %s\
",
                 collision_monitor::failureText(error).c_str());
    return collision_monitor::kFault;
  }
}
