// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

#include "model/object_links.h"
#include "pipeline/cycle/run_cycle.h"
#include "pipeline/objects/carry_objects.h"
#include "pipeline/world/add_world.h"
#include "support/robots/robot_moves.h"
#include "support/robots/world_objects.h"

/// Prints what a cycle takes with very many objects at rest, beside one without objects, for one
/// robot of the shared data: `crowd_bench [ROBOT [COUNT]]`, by default atlas and 10,000 boxes. The
/// numbers of pairs that are refined, and in contact or a warning, tell what the robot comes near.
namespace collision_monitor::test {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kRate = 1000.0;  // [Hz]
constexpr int kMoves = 6;

/// Boxes of 5 cm between two distances [m] from the robot's root.
World boxesAround(std::size_t count, double nearest, double farthest, const CycleSetup& robots) {
  std::mt19937_64 random(20260101);
  std::uniform_real_distribution<double> coordinate(-farthest, farthest);
  std::vector<WorldObject> objects;
  while (objects.size() < count) {
    const Pose place = at(coordinate(random), coordinate(random), coordinate(random));
    if (place.translation.norm() > nearest && place.translation.norm() < farthest) {
      objects.push_back(
          objectOf("box_" + std::to_string(objects.size()), Box{{0.025, 0.025, 0.025}}, place));
    }
  }
  return worldOf(objects, placesOf(robots.model, "map"));
}

/// A set-up and its cycles.
class Monitor {
 public:
  explicit Monitor(CycleSetup made)
      : setup_(std::move(made)),
        buffers_(makeBuffers(setup_, BroadPhaseKind::automatic)),
        poses_(makeLinkPoses(setup_.model)),
        objects_(objectRuns(setup_.model)) {
    std::fill(poses_.status.begin(), poses_.status.end(), LinkStatus::known);
    std::fill(poses_.velocities.known.begin(), poses_.velocities.known.end(), 1);
  }

  /// Takes poses and velocities of the robot's links. [us] What objects and the cycle take.
  double cycle(const LinkPoses& robots) {
    poses_.stamp_ns = robots.stamp_ns;
    std::fill(poses_.robot_stamp_ns.begin(), poses_.robot_stamp_ns.end(), robots.stamp_ns);
    for (std::size_t i = 0; i < robots.status.size(); ++i) {
      poses_.world_from_link[i] = robots.world_from_link[i];
      poses_.velocities.of_link[i] = robots.velocities.of_link[i];
      poses_.velocities.known[i] = robots.velocities.known[i];
    }
    const auto start = Clock::now();
    carryPoses(setup_.model, objects_, poses_);
    carryVelocities(objects_, poses_);
    runCycle(setup_, poses_, buffers_);
    return std::chrono::duration<double, std::micro>(Clock::now() - start).count();
  }

  const CycleBuffers& buffers() const { return buffers_; }

 private:
  CycleSetup setup_;
  CycleBuffers buffers_;
  LinkPoses poses_;
  std::vector<ObjectRun> objects_;
};

double medianOf(std::vector<double> times) {
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
  std::nth_element(times.begin(), middle, times.end());
  return *middle;
}

/// What cycles take, and of how many pairs.
struct Costs {
  std::vector<double> times;    ///< [us]
  std::vector<double> refined;  ///< pairs of elements
  std::vector<double> near;     ///< pairs of links in contact or with a warning

  void add(double time, const CycleBuffers& buffers) {
    const PairEvents& events = buffers.events;
    times.push_back(time);
    refined.push_back(static_cast<double>(buffers.counters.refined));
    near.push_back(static_cast<double>(
        std::count_if(events.active.begin(), events.active.end(), [&](LinkPairIndex pair) {
          return events.verdicts[pair] == Verdict::warning ||
                 events.verdicts[pair] == Verdict::contact;
        })));
  }
};

/// Both monitors see the same poses, one after the other: taking turns in each cycle, they would
/// drive each other's data out of the caches.
void compare(const std::string& what, const CycleSetup& robots, CycleSetup with_objects) {
  Monitor alone(robots);
  Monitor crowded(std::move(with_objects));
  Mover mover(robots.model, kRate, 1.0);
  Costs of_alone;
  Costs of_crowded;
  for (int move = 0; move < kMoves; ++move) {
    const auto& all = mover.next();
    for (const LinkPoses& poses : all) {
      of_alone.add(alone.cycle(poses), alone.buffers());
    }
    for (const LinkPoses& poses : all) {
      of_crowded.add(crowded.cycle(poses), crowded.buffers());
    }
  }
  std::printf(
      "%s: %.1f us alone, %.1f us with them; %.0f and %.0f pairs refined, %.0f and %.0f near\n",
      what.c_str(), medianOf(of_alone.times), medianOf(of_crowded.times),
      medianOf(of_alone.refined), medianOf(of_crowded.refined), medianOf(of_alone.near),
      medianOf(of_crowded.near));
}

int run(const std::string& name, std::size_t count) {
  const std::optional<RobotFile> file = findRobot(name);
  if (!file) {
    return 1;
  }
  CycleSetup robots = buildSetup({describe(*file)}, fileLoader(file->package_root), {});
  robots.refine.tolerance = kMonitorTolerance;
  const auto withBoxes = [&](double nearest, double farthest) {
    const World world = boxesAround(count, nearest, farthest, robots);
    return addWorld(robots, world, prepareObjects(world, RefineGeometry::mesh, {}), "map");
  };
  compare(std::to_string(count) + " boxes from 1.5 to 6 m", robots, withBoxes(1.5, 6.0));
  compare(std::to_string(count) + " boxes from 1 to 3 m", robots, withBoxes(1.0, 3.0));
  return 0;
}

}  // namespace
}  // namespace collision_monitor::test

int main(int argc, char** argv) {
  return collision_monitor::test::run(argc > 1 ? argv[1] : "atlas",
                                      argc > 2 ? std::stoul(argv[2]) : 10000);
}
