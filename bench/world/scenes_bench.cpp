// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Scenes beside one robot, against FCL. ROBOT is a part of a name; the first such robot of the
// shared data or urdf/ is used. A scene is a file that a monitor reads as its `world_file`. Prints
// one line for each: the file, then names and numbers in turn, which figures/scenes.py reads.
// --times measures times in place of verdicts.
//   scenes_bench ROBOT [--states N] [--times] [--packages FOLDER]... FILE...
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "collision_monitor/geometry/ids.h"
#include "model/world/world_text.h"
#include "peers/placed_states.h"
#include "pipeline/states/check_states.h"
#include "pipeline/world/add_world.h"
#include "scene_verdicts.h"
#include "support/robots/robot_moves.h"
#include "thread_time.h"

namespace collision_monitor::test {
namespace {

const char* const kUsage =
    "scenes_bench ROBOT [--states N] [--times] [--packages FOLDER]... FILE...\n";

struct Arguments {
  std::string robot;
  std::size_t states{1000};
  bool are_timed{false};
  std::vector<std::string> package_roots;
  std::vector<std::string> files;
};

std::optional<Arguments> readArguments(const std::vector<std::string>& words) {
  Arguments arguments;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == "--states" && i + 1 < words.size()) {
      arguments.states = std::strtoul(words[++i].c_str(), nullptr, 10);
    } else if (words[i] == "--packages" && i + 1 < words.size()) {
      arguments.package_roots.push_back(words[++i]);
    } else if (words[i] == "--times") {
      arguments.are_timed = true;
    } else if (words[i].rfind("--", 0) == 0) {
      return std::nullopt;
    } else if (arguments.robot.empty()) {
      arguments.robot = words[i];
    } else {
      arguments.files.push_back(words[i]);
    }
  }
  return arguments.states > 0 && !arguments.files.empty() ? std::optional<Arguments>(arguments)
                                                          : std::nullopt;
}

/// Looks in one folder of packages after the other.
ResourceLoader loaderOf(const std::vector<std::string>& package_roots) {
  return [package_roots](const std::string& uri) {
    for (std::size_t i = 0; i + 1 < package_roots.size(); ++i) {
      try {
        return fileLoader(package_roots[i])(uri);
      } catch (const std::exception&) {
        continue;
      }
    }
    return fileLoader(package_roots.empty() ? "" : package_roots.back())(uri);
  };
}

World readScene(const std::string& file, const CycleSetup& robot, const ResourceLoader& loader) {
  SetupReport report;
  const std::string folder = std::filesystem::path(file).parent_path().string();
  const auto objects = readWorld({file, readFile(file), folder}, loader, {}, report);
  throwIfErrors(report);
  World world = applyChanges(World(), {{ChangeKind::replace_all, objects, true}},
                             placesOf(robot.model, "world"), report);
  throwIfErrors(report);
  return world;
}

/// Checks pairs of a link and an object alone.
CycleSetup withObjectPairs(const CycleSetup& setup) {
  const auto is_object = [&](LinkId link) {
    return setup.model.robots[index(setup.model.link(link).robot)].is_world;
  };
  std::vector<LinkPair> wanted;
  std::copy_if(setup.link_pairs.begin(), setup.link_pairs.end(), std::back_inserter(wanted),
               [&](const LinkPair& pair) {
                 return isChecked(pair.reason) && is_object(pair.a) != is_object(pair.b);
               });
  return withPairs(setup, std::move(wanted));
}

void print(const char* name, double number) { std::printf(" %s %.9g", name, number); }

void print(const char* name, std::size_t number) { print(name, static_cast<double>(number)); }

/// check_states' question whether a state is in contact. @return [us] a state
double timeStates(const CycleSetup& setup, const JointPositions& positions,
                  std::vector<StateCheck>& checks) {
  constexpr int kCalls = 50;  // together about as long as FCL's
  StatesWork work =
      makeStatesWork(setup, standingAt(setup.model, std::vector<Pose>(setup.model.robots.size())));
  const auto check = [&] {
    checkStatesExactly(setup, positions, StateQuestion::contact, work, checks);
  };
  check();  // fills memories
  return 1e-3 * medianTimeOf(kCalls, check) / static_cast<double>(checks.size());
}

/// @param query of FCL about the set-up at one state @return [us] a state
template <class Query>
double timeFcl(const CycleSetup& setup, const PlacedStates& states, const Query& query) {
  constexpr int kCalls = 3;
  std::size_t contacts = 0;
  const double time = medianTimeOf(kCalls, [&] {
    for (const FclObjects& objects : states.fcl) {
      contacts += query(setup, objects) ? 1 : 0;
    }
  });
  return contacts > kCalls * states.size() ? 0.0 : 1e-3 * time / static_cast<double>(states.size());
}

void measureTimes(const CycleSetup& whole, const PlacedStates& states) {
  std::vector<StateCheck> checks;
  print("objects_us", timeStates(states.setup, states.positions, checks));
  print("objects_fcl_us", timeFcl(states.setup, states, fclContacts));
  print("objects_fcl_first_us", timeFcl(states.setup, states, fclHasContact));
  print("all_us", timeStates(whole, states.positions, checks));
  print("all_fcl_us", timeFcl(whole, states, fclContacts));
  print("all_fcl_first_us", timeFcl(whole, states, fclHasContact));
}

void measureScene(const CycleSetup& robot, const World& world, const Arguments& arguments) {
  const PreparedObjects prepared = prepareObjects(world, RefineGeometry::mesh, {});
  CycleSetup whole = addWorld(robot, world, prepared, "world");
  for (std::size_t i = 0; i < robot.model.links.size(); ++i) {  // FCL reads their triangles
    whole.model.links[i].collisions = robot.model.links[i].collisions;
  }
  const CycleSetup setup = withObjectPairs(whole);
  const std::vector<Geometry> geometries = sourceGeometries(setup, world);
  const PlacedStates states = drawPlacedStates(setup, geometries, arguments.states);
  print("objects", world.objects.size());
  print("pairs", setup.checked.size());
  print("states", states.size());
  if (arguments.are_timed) {
    measureTimes(whole, states);
    return;
  }
  const SceneVerdicts verdicts = compareVerdicts(states, geometries);
  print("compared", verdicts.compared);
  print("contacts", verdicts.contacts);
  print("different", verdicts.different);
  print("touching", verdicts.touching);
  print("inside", verdicts.inside);
  print("fcl_wrong", verdicts.fcl_wrong);
  print("ours_wrong", verdicts.ours_wrong);
  std::vector<StateCheck> checks;
  StatesWork work =
      makeStatesWork(setup, standingAt(setup.model, std::vector<Pose>(setup.model.robots.size())));
  checkStatesExactly(setup, states.positions, StateQuestion::contact, work, checks);
  print("states_wrong", countWrong(checks, verdicts.states));
}

int measure(const Arguments& arguments) {
  const std::optional<RobotFile> file = findRobot(arguments.robot);
  if (!file) {
    return 1;
  }
  SetupOptions options;
  options.is_continuous = false;
  CycleSetup robot = buildSetup({describe(*file)}, fileLoader(file->package_root), options);
  robot.refine.tolerance = kMonitorTolerance;
  const ResourceLoader loader = loaderOf(arguments.package_roots);
  int failed = 0;
  for (const std::string& scene : arguments.files) {
    std::printf("%s", scene.c_str());
    try {
      measureScene(robot, readScene(scene, robot, loader), arguments);
    } catch (const std::exception& fault) {
      std::fprintf(stderr, "%s: %s\n", scene.c_str(), fault.what());
      std::printf(" failed 1");
      failed = 1;
    }
    std::printf("\n");
    std::fflush(stdout);
  }
  return failed;
}

int runBench(const std::vector<std::string>& words) {
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
