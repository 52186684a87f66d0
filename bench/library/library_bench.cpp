// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The library as its users call it: the distance of every pair of a robot in motion, for joint
// values, the nearest pair and all contacts, beside FCL, which starts from poses of its objects and
// skips pairs by their boxes where it can. Prints lines of "robot/figure microseconds"; FCL's
// figures end in /fcl and /fcl_solids.
//   collision_monitor_library_bench ROBOT...
#include <cmath>
#include <cstdio>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "bench_loop.h"
#include "collision_monitor/robot_query.h"
#include "peers/fcl_elements.h"
#include "pipeline/cycle/place_bodies.h"
#include "support/robots/file_loader.h"
#include "support/robots/robot_moves.h"

namespace collision_monitor::test {
namespace {

constexpr std::size_t kStates = 400;
constexpr std::size_t kStatesAMove = 100;
constexpr std::size_t kFclStates = 20;  // evenly among them: FCL takes milliseconds for each
constexpr std::size_t kManyStates = 100'000;

MonitorOptions optionsOf(const RobotFile& robot) {
  MonitorOptions options;
  options.load_resource = fileLoader(robot.package_root);
  options.fit_cache = "none";
  return options;
}

/// From each random configuration straight to the next.
std::vector<JointPositions> moveThrough(const RobotModel& model) {
  std::mt19937_64 random(20260101);
  std::vector<JointPositions> states;
  JointPositions from = drawPositions(model, random);
  while (states.size() < kStates) {
    const JointPositions to = drawPositions(model, random);
    for (std::size_t step = 0; step < kStatesAMove; ++step) {
      states.push_back(between(from, to, static_cast<double>(step) / kStatesAMove));
    }
    from = to;
  }
  return states;
}

void print(const std::string& robot, const char* figure, double nanoseconds) {
  std::printf("%s/%s %.4g\n", robot.c_str(), figure, 1e-3 * nanoseconds);
  std::fflush(stdout);
}

/// [ns] a state; `ask` returns a number that depends on the answer.
template <class Inputs, class Ask>
double timeOfEach(const Inputs& inputs, const Ask& ask) {
  double sum = 0.0;
  const double time = medianTime([&] {
    for (const auto& input : inputs) {
      sum += ask(input);
    }
  });
  benchmark::DoNotOptimize(sum);
  return time / static_cast<double>(inputs.size());
}

/// [ns] a state
double timeDistances(RobotQuery& query, const std::vector<JointPositions>& states,
                     const DistanceRequest& request) {
  return timeOfEach(states, [&](const JointPositions& state) {
    double sum = 0.0;
    for (const MeasuredPair& pair : query.distances(state, request).pairs) {
      sum += pair.measured.distance;
    }
    return sum;
  });
}

CycleSetup fclSetup(const RobotFile& robot) {
  SetupOptions options;
  options.default_limits.max_shapes = 1;
  return buildSetup({describe(robot)}, fileLoader(robot.package_root), options);
}

/// The convex elements as FCL's convex solids, in which it is faster than in meshes; the others as
/// their geometries.
std::vector<FclGeometry> fclSolids(const CycleSetup& setup) {
  std::vector<FclGeometry> solids = fclGeometries(setup);
  for (std::size_t i = 0; i < solids.size(); ++i) {
    if (setup.elements[i].convex) {
      solids[i] = toFclGeometry(*setup.elements[i].convex);
    }
  }
  return solids;
}

/// Some of the states.
std::vector<FclObjects> placeForFcl(const CycleSetup& setup,
                                    const std::vector<FclGeometry>& geometries,
                                    const std::vector<JointPositions>& states) {
  BodyPoses poses = makeBodyPoses(setup);
  std::vector<FclObjects> placed;
  for (std::size_t i = 0; i < kFclStates; ++i) {
    const LinkPoses links = posesAt(setup.model, states[i * (kStates / kFclStates)]);
    placeBodies(setup, links, poses);
    placeElements(setup, links, poses);
    placed.push_back(placeFcl(geometries, poses.world_from_element));
  }
  return placed;
}

/// [ns] a state, with what it takes to place the objects
template <class Ask>
double timeFcl(const std::vector<FclObjects>& states, const Ask& ask) {
  return timeOfEach(states, [&](const FclObjects& objects) {
    for (const auto& object : objects) {
      if (object != nullptr) {
        object->setTransform(object->getTransform());
        object->computeAABB();
      }
    }
    return ask(objects);
  });
}

/// [ns] a state, on one thread
double timeCheck(RobotQuery& query, StateQuestion question) {
  std::mt19937_64 random(20260101);
  std::vector<double> states;
  for (std::size_t i = 0; i < kManyStates; ++i) {
    const JointPositions state = drawPositions(query.monitor().model(), random);
    states.insert(states.end(), state.begin(), state.end());
  }
  const StatesRequest request{question, 1, {}};
  return timeOf([&] { query.check(states, request); }) / kManyStates;
}

void measureFcl(const RobotFile& robot, const std::string& name,
                const std::vector<JointPositions>& states) {
  const CycleSetup setup = fclSetup(robot);
  const auto every = [&](const FclObjects& objects) { return fclLeastOfEvery(setup, objects); };
  const std::vector<FclObjects> placed = placeForFcl(setup, fclGeometries(setup), states);
  print(name, "every_distance/fcl", timeFcl(placed, every));
  print(name, "every_distance/fcl_solids",
        timeFcl(placeForFcl(setup, fclSolids(setup), states), every));
  print(name, "nearest/fcl",
        timeFcl(placed, [&](const FclObjects& objects) { return fclLeast(setup, objects); }));
  print(name, "contacts/fcl", timeFcl(placed, [&](const FclObjects& objects) {
          return static_cast<double>(fclContacts(setup, objects));
        }));
}

void measure(const RobotFile& robot) {
  const std::string name = robot.name.substr(0, robot.name.find('/'));
  RobotQuery query(RobotMonitor({describe(robot)}, optionsOf(robot)));
  const std::vector<JointPositions> states = moveThrough(query.monitor().model());
  print(name, "every_distance", timeDistances(query, states, {}));
  print(name, "every_distance_and_gradient",
        timeDistances(query, states, {std::numeric_limits<double>::infinity(), true}));
  print(name, "distances_within_0.2_m", timeDistances(query, states, {0.2, false}));
  print(name, "nearest", timeOfEach(states, [&](const JointPositions& state) {
          return query.nearest(state).measured.distance;
        }));
  print(name, "contacts", timeOfEach(states, [&](const JointPositions& state) {
          return static_cast<double>(query.contacts(state).size());
        }));
  measureFcl(robot, name, states);
  print(name, "check_contact", timeCheck(query, StateQuestion::contact));
  print(name, "check_nearest", timeCheck(query, StateQuestion::nearest));
}

}  // namespace
}  // namespace collision_monitor::test

int main(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    const auto robot = collision_monitor::test::findRobot(argv[i]);
    if (!robot) {
      return 1;
    }
    collision_monitor::test::measure(*robot);
  }
  return 0;
}
