// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

#include "pipeline/answers/carry_over.h"
#include "pipeline/cycle/run_cycle.h"
#include "pipeline/look_ahead/find_motions.h"
#include "pipeline/world/add_world.h"
#include "support/robots/robot_moves.h"
#include "support/robots/world_objects.h"

/// Prints how long it takes until new objects are watched, and what they cost in each cycle, beside
/// one robot of the shared data: `world_bench [ROBOT]`, by default atlas.
namespace collision_monitor::test {
namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

KnownPlaces placesOf(const CycleSetup& robots) {
  KnownPlaces places;
  for (const Link& link : robots.model.links) {
    places.links.push_back(link.name);
    places.link_frames.push_back(link.frame);
  }
  places.world_frame = "map";
  return places;
}

/// Boxes of 5 cm on a shell around the robot, from 1.5 m to 6 m away.
std::vector<WorldObject> boxesAround(std::size_t count) {
  std::mt19937_64 random(20260101);
  std::uniform_real_distribution<double> coordinate(-6.0, 6.0);
  std::vector<WorldObject> objects;
  while (objects.size() < count) {
    const Pose place = at(coordinate(random), coordinate(random), coordinate(random));
    if (place.translation.norm() > 1.5 && place.translation.norm() < 6.0) {
      objects.push_back(
          objectOf("box_" + std::to_string(objects.size()), Box{{0.025, 0.025, 0.025}}, place));
    }
  }
  return objects;
}

/// A ball of 2 n^2 triangles with bumps, so that it is not convex.
SharedMesh bumpyBall(std::uint32_t n) {
  constexpr double kTurn = 6.283185307179586;
  auto mesh = std::make_shared<TriangleMesh>();
  for (std::uint32_t i = 0; i <= n; ++i) {
    for (std::uint32_t k = 0; k < n; ++k) {
      const double up = 0.5 * kTurn * i / n;
      const double round = kTurn * k / n;
      const double radius = 0.5 + 0.02 * std::sin(9.0 * up) * std::sin(9.0 * round);
      mesh->vertices.emplace_back(radius * std::sin(up) * std::cos(round),
                                  radius * std::sin(up) * std::sin(round), radius * std::cos(up));
    }
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t k = 0; k < n; ++k) {
      const std::uint32_t next = (k + 1) % n;
      mesh->triangles.push_back({i * n + k, (i + 1) * n + k, (i + 1) * n + next});
      mesh->triangles.push_back({i * n + k, (i + 1) * n + next, i * n + next});
    }
  }
  return mesh;
}

struct Watched {
  CycleSetup setup;
  CycleBuffers buffers;
};

/// Prints the stages of a change up to the swap.
Watched watch(const CycleSetup& robots, const CycleSetup& former, const LinkPoses& robot_poses,
              const std::string& what, const std::vector<WorldObject>& objects) {
  const auto start = Clock::now();
  const World world = worldOf(objects, placesOf(robots));
  const double checked = millisecondsSince(start);
  const PreparedObjects prepared = prepareObjects(world, RefineGeometry::mesh, {});
  const double made = millisecondsSince(start);
  Watched watched{addWorld(robots, world, prepared, {"map", 0}), {}};
  const double added = millisecondsSince(start);
  watched.buffers = makeBuffers(watched.setup, BroadPhaseKind::automatic);
  LinkPoses poses = makeLinkPoses(watched.setup.model);
  std::fill(poses.status.begin(), poses.status.end(), LinkStatus::known);
  std::copy(robot_poses.world_from_link.begin(), robot_poses.world_from_link.end(),
            poses.world_from_link.begin());
  for (const Joint& joint : watched.setup.model.joints) {
    if (index(joint.child) >= robots.model.links.size()) {
      poses.world_from_link[index(joint.child)] =
          poses.world_from_link[index(joint.parent)] * joint.parent_from_joint;
    }
  }
  const double buffered = millisecondsSince(start);
  learnPairs(watched.setup, poses, watched.buffers);
  const double learnt = millisecondsSince(start);
  planCarryOver(former, watched.setup);
  std::printf(
      "%-28s %8.1f ms: checked %.1f, prepared %.1f, pairs %.1f, buffers %.1f, learnt %.1f, "
      "carry-over %.1f\n",
      what.c_str(), millisecondsSince(start), checked, made - checked, added - made,
      buffered - added, learnt - buffered, millisecondsSince(start) - learnt);
  return watched;
}

/// [ms] The median cycle of moves at 100 Hz.
double cycleTime(Watched& watched) {
  Mover mover(watched.setup.model, 100.0, 1.0);
  std::vector<double> times;
  for (int i = 0; i < 8; ++i) {
    for (const LinkPoses& poses : mover.next()) {
      const auto start = Clock::now();
      runCycle(watched.setup, poses, watched.buffers);
      times.push_back(millisecondsSince(start));
    }
  }
  std::nth_element(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2),
                   times.end());
  return times[times.size() / 2];
}

int run(const std::string& name) {
  const std::optional<RobotFile> file = findRobot(name);
  if (!file) {
    return 1;
  }
  SetupOptions options;
  options.limits.warning_time = 0.0;
  CycleSetup robots = buildSetup({describe(*file)}, fileLoader(file->package_root), options);
  const LinkPoses poses = posesAt(robots.model, defaultPositions(robots.model));
  std::printf("%s: %zu links, %zu bodies\n", name.c_str(), robots.model.links.size(),
              robots.bodies.size());
  Watched alone{robots, makeBuffers(robots, BroadPhaseKind::automatic)};
  const double without = cycleTime(alone);
  watch(robots, robots, poses, "1,000 boxes, first", boxesAround(1000));
  Watched thousand = watch(robots, robots, poses, "1,000 boxes, again", boxesAround(1000));
  Watched many = watch(robots, robots, poses, "10,000 boxes", boxesAround(10000));
  const Watched mesh = watch(robots, robots, poses, "a mesh of 100,352 triangles",
                             {objectOf("mesh", bumpyBall(224), at(3, 0, 0))});
  std::printf("cycle: %.3f ms alone, %.3f ms with 1,000 boxes, %.3f ms with 10,000\n", without,
              cycleTime(thousand), cycleTime(many));
  return 0;
}

}  // namespace
}  // namespace collision_monitor::test

int main(int argc, char** argv) {
  return collision_monitor::test::run(argc > 1 ? argv[1] : "atlas");
}
