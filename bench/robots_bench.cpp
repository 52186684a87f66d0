// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <string>

#include "bench_loop.h"
#include "pipeline/cycle/place_bodies.h"
#include "robot_scene.h"

// One state of a robot at a time, with given poses: least distance and all contacts of the
// collision geometries, and the distance of every pair of their hulls. FCL runs on the same states
// in the same run. It is used in its fastest form: it skips pairs by their boxes. Robots come from
// the folder in COLLISION_MONITOR_SHARED_DATA.
namespace collision_monitor::test {
namespace {

/// Runs `query` on state after state.
template <class Query>
void forStates(benchmark::State& state, const Query& query) {
  std::size_t next = 0;
  for ([[maybe_unused]] const auto unused : state) {
    benchmark::DoNotOptimize(query(next++ % kStates));
  }
}

/// Measures the pair that was nearest in the last state first, then all pairs that bounding spheres
/// and enclosing shapes do not prove to be farther.
double leastDistance(RobotScene& scene, std::size_t state) {
  placeBodies(scene.setup, scene.states[state], scene.poses);
  placeElements(scene.setup, scene.states[state], scene.poses);
  const ElementPairIndex first = scene.nearest;
  double least = measurePair(scene, first, std::numeric_limits<double>::infinity());
  const std::vector<BodyPair>& pairs = scene.setup.table.pairs();
  for (std::size_t i = 0; i < pairs.size() && least > 0.0; ++i) {
    const ElementPairIndex elements = scene.setup.element_pair_of[i];
    if (elements != first && mayBeNearer(scene, pairs[i], least)) {
      const double distance = measurePair(scene, elements, least);
      scene.nearest = distance < least ? elements : scene.nearest;
      least = std::min(least, distance);
    }
  }
  return std::max(least, 0.0);
}

/// Measures pairs whose enclosing shapes touch.
std::size_t countContacts(RobotScene& scene, std::size_t state) {
  boundPairs(scene, state);
  std::size_t contacts = 0;
  for (const auto& [bound, pair] : scene.bounds) {
    contacts += bound <= 0.0 && touch(scene, pair) ? 1 : 0;
  }
  return contacts;
}

double sumOfHulls(RobotScene& scene, std::size_t state) {
  measureHulls(scene, state);
  double sum = 0.0;
  for (const ConvexDistance& answer : scene.answers) {
    sum += answer.measured.distance;
  }
  return sum;
}

double leastByFcl(const RobotScene& scene, std::size_t state) {
  return fclLeast(scene.setup, scene.fcl_states[state]);
}

std::size_t contactsByFcl(const RobotScene& scene, std::size_t state) {
  return fclContacts(scene.setup, scene.fcl_states[state]);
}

double fclHulls(const RobotScene& scene, std::size_t state) {
  double sum = 0.0;
  for (const ElementPair& pair : scene.setup.element_pairs) {
    sum +=
        fclDistance(*scene.fcl_hulls[state][index(pair.a)], *scene.fcl_hulls[state][index(pair.b)])
            .value_or(0.0);
  }
  return sum;
}

void registerRobot(const RobotFile& robot) {
  const auto scene = std::make_shared<std::unique_ptr<RobotScene>>();
  const auto add = [&](const std::string& what, auto query) {
    benchmark::RegisterBenchmark(
        (robotNameOf(robot) + "/" + what).c_str(), [=](benchmark::State& state) {
          if (*scene == nullptr) {
            *scene = makeRobotScene(robot);
          }
          forStates(state, [&](std::size_t i) { return query(**scene, i); });
          state.counters["pairs"] = static_cast<double>((*scene)->setup.element_pairs.size());
        });
  };
  add("least_distance/ours", leastDistance);
  add("least_distance/fcl", leastByFcl);
  add("contacts/ours", countContacts);
  add("contacts/fcl", contactsByFcl);
  add("hulls/ours", sumOfHulls);
  add("hulls/fcl", fclHulls);
}

void registerAll() {
  for (const RobotFile& robot : benchRobots()) {
    registerRobot(robot);
  }
}

}  // namespace
}  // namespace collision_monitor::test

int main(int argc, char** argv) {
  return collision_monitor::test::runBenchmarks(argc, argv, &collision_monitor::test::registerAll);
}
