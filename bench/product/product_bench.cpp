// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Measures services and cycles of one robot in the default set-up of a monitor. Prints one line per
// number: its name, the number, its unit. ROBOT is a part of a name; the first such robot of the
// shared data or urdf/ is used. --list prints all names, one per folder of the shared data.
//   product_bench ROBOT [--part start|states|cycle|trajectory]... [--cycles N]
//   product_bench --list
#include "product_bench.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <optional>
#include <string>
#include <vector>

#include "support/robots/robot_moves.h"

namespace collision_monitor::test {
namespace {

const char* const kUsage =
    "product_bench ROBOT [--part start|states|cycle|trajectory]... [--cycles N] | --list\n";

struct Arguments {
  std::string robot;
  std::vector<std::string> parts;  ///< none: all
  std::size_t cycles{10000};

  bool asksFor(const char* part) const {
    return parts.empty() || std::find(parts.begin(), parts.end(), part) != parts.end();
  }
};

bool isPart(const std::string& word) {
  return word == "start" || word == "states" || word == "cycle" || word == "trajectory";
}

std::optional<Arguments> readArguments(const std::vector<std::string>& words) {
  Arguments arguments;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == "--part" && i + 1 < words.size() && isPart(words[i + 1])) {
      arguments.parts.push_back(words[++i]);
    } else if (words[i] == "--cycles" && i + 1 < words.size()) {
      arguments.cycles = std::strtoul(words[++i].c_str(), nullptr, 10);
    } else if (arguments.robot.empty() && words[i].rfind("--", 0) != 0) {
      arguments.robot = words[i];
    } else {
      return std::nullopt;
    }
  }
  return arguments.cycles > 0 && !arguments.robot.empty() ? std::optional<Arguments>(arguments)
                                                          : std::nullopt;
}

void printSize(const CycleSetup& setup) {
  std::size_t triangles = 0;
  for (const Link& link : setup.model.links) {
    for (const CollisionElement& element : link.collisions) {
      const auto* mesh = std::get_if<TriangleMesh>(&element.geometry);
      triangles += mesh == nullptr ? 0 : mesh->triangles.size();
    }
  }
  print("triangles", triangles);
  print("elements", setup.elements.size());
  print("link_pairs", setup.checked.size());
  print("element_pairs", setup.element_pairs.size());
  print("body_pairs", setup.table.size());
}

int measure(const Arguments& arguments) {
  const std::optional<RobotFile> robot = findRobot(arguments.robot);
  if (!robot) {
    return 1;
  }
  CycleSetup setup =
      arguments.asksFor("start")
          ? measureStart(*robot)
          : buildSetup({describe(*robot)}, fileLoader(robot->package_root), SetupOptions());
  setup.refine.tolerance = kMonitorTolerance;
  printSize(setup);
  if (arguments.asksFor("states")) {
    measureStates(setup);
  }
  if (arguments.asksFor("cycle")) {
    measureCycles(setup, arguments.cycles);
  }
  if (arguments.asksFor("trajectory")) {
    measureTrajectory(setup);
  }
  return 0;
}

void listRobots() {
  std::string last;
  for (const RobotFile& robot : allRobotFiles()) {
    const std::string folder = robot.name.substr(0, robot.name.find('/'));
    if (folder != last || folder == "urdf") {
      std::printf("%s\n", robot.name.c_str());
    }
    last = folder;
  }
}

int runBench(const std::vector<std::string>& words) {
  if (words.size() == 1 && words[0] == "--list") {
    listRobots();
    return 0;
  }
  const std::optional<Arguments> arguments = readArguments(words);
  if (!arguments) {
    std::fputs(kUsage, stderr);
    return 2;
  }
  try {
    return measure(*arguments);
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "%s\n", fault.what());
    return 1;
  }
}

}  // namespace
}  // namespace collision_monitor::test

int main(int argc, char** argv) {
  return collision_monitor::test::runBench({argv + 1, argv + argc});
}
