// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Prints one digest for each robot and subject of what the core answers at fixed seeds. Equal
// digests show that two builds answer the same (scripts/compare_answers). Uses the robots of the
// shared data and of urdf/ whose names contain one of the words; all without words.
//   digests [WORD]...
#include <algorithm>
#include <cinttypes>
#include <cstdio>
#include <string>
#include <vector>

#include "digests/robot_digests.h"
#include "support/robots/file_loader.h"

namespace collision_monitor::test {
namespace {

void print(const std::string& robot, const char* subject, const Digest& digest) {
  std::printf("%s %s %016" PRIx64 "\n", robot.c_str(), subject, digest.value());
}

void printRobot(const RobotFile& robot) {
  SetupOptions options;
  options.refine.limits.tolerance = 1e-4;  // as the node
  const CycleSetup setup = buildSetup({describe(robot)}, fileLoader(robot.package_root), options);
  print(robot.name, "fits", digestOfFits(setup));
  print(robot.name, "pairs", digestOfPairs(setup));
  print(robot.name, "cycles", digestOfCycles(setup));
  print(robot.name, "states", digestOfStates(setup));
  print(robot.name, "trajectory", digestOfTrajectory(setup));
  print(robot.name, "pair_search", digestOfPairSearch(setup));
  std::fflush(stdout);
}

bool isAsked(const RobotFile& robot, const std::vector<std::string>& words) {
  return words.empty() || std::any_of(words.begin(), words.end(), [&](const std::string& word) {
           return robot.name.find(word) != std::string::npos;
         });
}

/// If one build refuses a robot the other must, too; error texts may change.
int printDigests(const std::vector<std::string>& words) {
  for (const RobotFile& robot : allRobotFiles()) {
    if (isAsked(robot, words)) {
      try {
        printRobot(robot);
      } catch (const SetupError&) {
        std::printf("%s refused\n", robot.name.c_str());
      }
    }
  }
  return 0;
}

}  // namespace
}  // namespace collision_monitor::test

int main(int argc, char** argv) {
  return collision_monitor::test::printDigests({argv + 1, argv + argc});
}
