// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <malloc.h>
#include <ros/time.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "ros_edge/outputs/conversions.h"
#include "support/robots/robot_moves.h"
#include "world/watched_robot.h"

/// Prints how long it takes until new objects are watched, and the memory that they take, beside
/// one robot of the shared data: `world_bench [ROBOT [COUNT]...] [--attach TIMES]`, by default
/// atlas, 1,000 and 10,000 boxes.
namespace collision_monitor::bench {
namespace {

SceneChange changeOf(std::uint8_t kind, std::vector<SceneObject> objects) {
  SceneChange change;
  change.kind = kind;
  change.objects = std::move(objects);
  return change;
}

SceneObject named(const std::string& name) {
  SceneObject object;
  object.name = name;
  object.pose.orientation.w = 1.0;
  return object;
}

/// Boxes of 5 cm on a shell around the robot, from 1.5 m to 6 m away.
std::vector<SceneObject> boxesAround(std::size_t count) {
  std::mt19937_64 random(20260101);
  std::uniform_real_distribution<double> coordinate(-6.0, 6.0);
  std::vector<SceneObject> objects;
  while (objects.size() < count) {
    const Eigen::Vector3d place(coordinate(random), coordinate(random), coordinate(random));
    if (place.norm() > 1.5 && place.norm() < 6.0) {
      SceneObject object = named("box_" + std::to_string(objects.size()));
      object.primitives.resize(1);
      object.primitives[0].type = shape_msgs::SolidPrimitive::BOX;
      object.primitives[0].dimensions = {0.05, 0.05, 0.05};
      toMessage(place, object.pose.position);
      objects.push_back(object);
    }
  }
  return objects;
}

geometry_msgs::Point pointOf(double x, double y, double z) {
  geometry_msgs::Point point;
  point.x = x;
  point.y = y;
  point.z = z;
  return point;
}

/// A ball of 2 n^2 triangles with bumps, so that it is not convex.
SceneObject bumpyBall(std::uint32_t n) {
  constexpr double kTurn = 6.283185307179586;
  SceneObject object = named("mesh");
  object.pose.position.x = 3.0;
  shape_msgs::Mesh& mesh = object.meshes.emplace_back();
  for (std::uint32_t i = 0; i <= n; ++i) {
    for (std::uint32_t k = 0; k < n; ++k) {
      const double up = 0.5 * kTurn * i / n;
      const double round = kTurn * k / n;
      const double radius = 0.5 + 0.02 * std::sin(9.0 * up) * std::sin(9.0 * round);
      mesh.vertices.push_back(pointOf(radius * std::sin(up) * std::cos(round),
                                      radius * std::sin(up) * std::sin(round),
                                      radius * std::cos(up)));
    }
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t k = 0; k < n; ++k) {
      const std::uint32_t next = (k + 1) % n;
      mesh.triangles.emplace_back().vertex_indices = {i * n + k, (i + 1) * n + k,
                                                      (i + 1) * n + next};
      mesh.triangles.emplace_back().vertex_indices = {i * n + k, (i + 1) * n + next, i * n + next};
    }
  }
  return object;
}

/// [MB] What this process holds now.
double memoryNow() {
  malloc_trim(0);
  std::ifstream file("/proc/self/statm");
  double pages = 0.0;
  file >> pages >> pages;
  return pages * 4096e-6;
}

void print(const std::string& what, const ChangeTimes& times) {
  std::printf(
      "%-28s %8.1f ms: read %.1f, checked %.1f, set-up %.1f, buffers %.1f, prepared %.1f, "
      "swapped %.2f; CPU %.1f ms\n",
      what.c_str(), times.all(), times.read, times.checked, times.made, times.buffered,
      times.prepared, times.swapped, times.cpu);
}

/// Prints the first and the median of some times that these changes take, each of which `undo`
/// takes back.
void printTimes(const std::string& what, const std::vector<SceneChange>& changes,
                const std::vector<SceneChange>& undo, WatchedRobot& robot) {
  constexpr std::size_t kTimes = 9;
  std::vector<ChangeTimes> times;
  for (std::size_t i = 0; i < kTimes; ++i) {
    times.push_back(robot.change(changes));
    robot.cycle();
    robot.change(undo);
    robot.cycle();
  }
  print(what + ", first", times.front());
  std::sort(times.begin(), times.end(), [](const ChangeTimes& one, const ChangeTimes& other) {
    return one.all() < other.all();
  });
  print(what, times[kTimes / 2]);
}

void addBoxes(std::size_t count, WatchedRobot& robot) {
  const std::vector<SceneChange> clear{changeOf(SceneChange::CLEAR, {})};
  const std::vector<SceneChange> add{changeOf(SceneChange::ADD, boxesAround(count))};
  printTimes(std::to_string(count) + " boxes", add, clear, robot);
  const double before = memoryNow();
  robot.change(add);
  robot.cycle();
  const std::size_t pairs = robot.watch().setup().table.size();
  const double taken = memoryNow() - before;
  std::printf("%-28s %8.1f MB, %.0f bytes a pair of %zu\n", "  memory", taken,
              1e6 * taken / static_cast<double>(pairs), pairs);
  SceneObject more = boxesAround(1).front();
  more.name = "one more";
  printTimes("  one more", {changeOf(SceneChange::ADD, {more})},
             {changeOf(SceneChange::REMOVE, {named("one more")})}, robot);
  robot.change(clear);
  robot.cycle();
}

/// By names of links, without this object.
std::map<std::string, Verdict> verdictsWithout(const std::string& object, const Watch& watch) {
  std::map<std::string, Verdict> verdicts;
  const CycleSetup& setup = watch.setup();
  for (std::size_t i = 0; i < setup.checked.size(); ++i) {
    const std::string& a = setup.model.link(setup.checked[i].a).name;
    const std::string& b = setup.model.link(setup.checked[i].b).name;
    if (a != object && b != object) {
      verdicts[a + " " + b] = watch.buffers.events.verdicts[i];
    }
  }
  return verdicts;
}

/// Attaches a box to the last link and detaches it, many times, where it stands.
void attachOften(std::size_t times, WatchedRobot& robot) {
  SceneObject box = boxesAround(1).front();
  robot.change({changeOf(SceneChange::ADD, {box})});
  robot.cycle();
  SceneChange attach = changeOf(SceneChange::ATTACH, {named(box.name)});
  attach.where_it_stands = 1;
  attach.objects[0].frame_id = robot.lastLink();
  const SceneChange detach = changeOf(SceneChange::DETACH, {named(box.name)});
  const auto verdicts = verdictsWithout(box.name, robot.watch());
  std::size_t others = 0;
  double before = 0.0;
  double taken = 0.0;
  for (std::size_t i = 0; i < times; ++i) {
    taken += robot.change({attach}).all();
    robot.cycle();
    others += verdictsWithout(box.name, robot.watch()) == verdicts ? 0 : 1;
    taken += robot.change({detach}).all();
    robot.cycle();
    others += verdictsWithout(box.name, robot.watch()) == verdicts ? 0 : 1;
    before = i == times / 10 ? memoryNow() : before;
  }
  std::printf("%-28s %8.1f ms a change, %.1f MB more at the end, %zu times another verdict\n",
              ("attached " + std::to_string(times) + " times").c_str(),
              taken / static_cast<double>(2 * times), memoryNow() - before, others);
  robot.change({changeOf(SceneChange::CLEAR, {})});
}

struct Options {
  std::string robot{"atlas"};
  std::vector<std::size_t> counts;
  std::size_t attach_times{200};
};

Options optionsOf(int argc, char** argv) {
  Options options;
  const std::vector<std::string> words(argv + 1, argv + argc);
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == "--attach" && i + 1 < words.size()) {
      options.attach_times = std::stoul(words[++i]);
    } else if (i == 0) {
      options.robot = words[i];
    } else {
      options.counts.push_back(std::stoul(words[i]));
    }
  }
  if (options.counts.empty()) {
    options.counts = {1000, 10000};
  }
  return options;
}

void run(const Options& options) {
  WatchedRobot robot(options.robot);
  const CycleSetup& setup = robot.watch().setup();
  std::printf("%s: %zu links, %zu bodies\n", options.robot.c_str(), setup.model.links.size(),
              setup.bodies.size());
  for (const std::size_t count : options.counts) {
    addBoxes(count, robot);
  }
  printTimes("a mesh of 100,352 triangles", {changeOf(SceneChange::ADD, {bumpyBall(224)})},
             {changeOf(SceneChange::CLEAR, {})}, robot);
  attachOften(options.attach_times, robot);
}

}  // namespace
}  // namespace collision_monitor::bench

int main(int argc, char** argv) {
  ros::Time::init();
  collision_monitor::bench::run(collision_monitor::bench::optionsOf(argc, argv));
}
