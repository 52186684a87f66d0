// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <string>

#include "collision_monitor/fitting/enclose.h"
#include "collision_monitor/fitting/fit_box.h"
#include "collision_monitor/fitting/fit_capsule.h"
#include "collision_monitor/fitting/fit_rounded_box.h"
#include "collision_monitor/fitting/fit_sphere.h"
#include "collision_monitor/fitting/proof.h"
#include "collision_monitor/model/urdf_reader.h"
#include "fitting/box_rotations.h"
#include "fitting/core_set.h"
#include "fitting/point_cloud.h"
#include "support/file_loader.h"

// For every mesh of every robot found: its size; the volume of each kind of fit over that of a long
// search from many more starts (1 is as good as the long search); the enclosing shape that was
// chosen, its overshoot, the vertices outside by the proof's bound, and the time of the choice.
// Arguments: part of a robot's name (all if none), starts of the long search (0: none; default
// 300).
namespace collision_monitor::test {
namespace {

double longCapsule(const NormalisedPoints& cloud, int starts) {
  double best = INFINITY;
  const Points spread = spreadDirections(starts);
  const Points representatives = representativesOf(cloud.points);
  for (int i = 0; i < starts; ++i) {
    PlacedCore core;
    core.rotation = rotationWithAxis(spread[static_cast<std::size_t>(i)]);
    core.half_extents.z() = 0.1 + 0.7 * (i % 7) / 7.0;
    const DescentGoal goal{{false, false, true}, 0.0};
    core = refineCore(descended(core, representatives, goal), representatives, cloud.points, goal);
    best = std::min(best, volumeOf(core));
  }
  return best;
}

double longBox(const NormalisedPoints& cloud, int starts) {
  double best = INFINITY;
  for (const auto& rotation : spreadRotations(starts)) {
    const auto axes = refineBoxRotation(rotation, cloud.points);
    best = std::min(best, volumeOf(boxWithAxes(axes, cloud.points)));
  }
  return best;
}

double longRoundedBox(const NormalisedPoints& cloud, int starts) {
  double best = INFINITY;
  const Points representatives = representativesOf(cloud.points);
  const DescentGoal goal{{true, true, true}, 0.0};
  int i = 0;
  for (const auto& rotation : spreadRotations(starts)) {
    PlacedCore core = boxWithAxes(rotation, cloud.points);
    core.half_extents *= 0.2 + 0.7 * (i++ % 5) / 5.0;
    core = refineCore(descended(core, representatives, goal), representatives, cloud.points, goal);
    best = std::min(best, volumeOf(core));
  }
  return best;
}

void printRatios(const TriangleMesh& mesh, int starts) {
  const Points corners = outerPoints(mesh.vertices);
  const NormalisedPoints cloud = normalise(corners);
  const double cube = std::pow(cloud.scale, 3);
  const double capsule = volumeOf(fitCapsule(corners).shape) / cube;
  const double box = volumeOf(fitBox(corners).shape) / cube;
  const double rounded = volumeOf(fitRoundedBox(corners).shape) / cube;
  std::printf("%6zu ", corners.size());
  if (starts == 0 || !(box > 1e-9)) {  // the ratio of two zeros says nothing
    std::printf("%7s %7s %7s ", "-", "-", "-");
    return;
  }
  std::printf("%7.4f %7.4f %7.4f ", capsule / longCapsule(cloud, starts),
              box / longBox(cloud, starts),
              rounded / std::min(rounded, longRoundedBox(cloud, starts)));
}

std::size_t countOutside(const TriangleMesh& mesh, const Enclosure& enclosure) {
  std::size_t outside = 0;
  for (const auto& vertex : mesh.vertices) {
    const PosedShape fit{enclosure.shape, enclosure.geometry_from_body};
    outside += provenExcess(fit, {vertex}) > 0.0 ? 1 : 0;
  }
  return outside;
}

void printMesh(const std::string& name, const TriangleMesh& mesh, int starts) {
  using Clock = std::chrono::steady_clock;
  std::printf("%-36.36s %7zu ", name.c_str(), mesh.triangles.size());
  printRatios(mesh, starts);
  const auto start = Clock::now();
  const Enclosure enclosure = encloseTightly(mesh);
  const std::chrono::duration<double, std::milli> elapsed = Clock::now() - start;
  std::printf("%-11s %6.1f %6.1f %8zu %7.1f\n", kindName(enclosure.shape),
              1e3 * enclosure.overshoot.max, 1e3 * enclosure.overshoot.mean,
              countOutside(mesh, enclosure), elapsed.count());
}

void printRobot(const RobotFile& robot, int starts) {
  SetupReport report;
  const RobotModel model = readRobots({describe(robot)}, fileLoader(robot.package_root), report);
  std::printf("\n%s\n", robot.name.c_str());
  for (const auto& link : model.links) {
    for (const auto& element : link.collisions) {
      const auto* mesh = std::get_if<TriangleMesh>(&element.geometry);
      if (mesh != nullptr && !mesh->vertices.empty()) {
        printMesh(link.name, *mesh, starts);
      }
    }
  }
}

void run(const std::string& wanted, int starts) {
  std::printf("%-36s %7s %6s %7s %7s %7s %-11s %6s %6s %8s %7s\n", "link", "tris", "hull",
              "capsule", "box", "rounded", "chosen", "max mm", "mean", "outside", "ms");
  for (const auto& robot : allRobotFiles()) {
    if (robot.name.find(wanted) != std::string::npos) {
      printRobot(robot, starts);
    }
  }
}

}  // namespace
}  // namespace collision_monitor::test

int main(int argc, char** argv) {
  try {
    collision_monitor::test::run(argc > 1 ? argv[1] : "", argc > 2 ? std::stoi(argv[2]) : 300);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "fitting_bench: %s\n", error.what());
    return 1;
  }
  return 0;
}
