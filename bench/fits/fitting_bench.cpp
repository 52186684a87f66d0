// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <string>

#include "collision_monitor/fitting/enclose.h"
#include "collision_monitor/model/urdf_reader.h"
#include "fits_long_search.h"
#include "fitting/proofs/proof.h"
#include "support/robots/file_loader.h"

// Prints for every mesh of every robot found: its size; the volume of each kind of fit relative to
// a long search from many more starts (1 is as good as the long search); the chosen enclosing
// shape, its overshoot, the vertices outside by the proof's bound, and the time of the choice.
// Arguments: part of a robot's name (all without it), starts of the long search (0: none; default
// 300).
namespace collision_monitor::test {
namespace {

void printRatios(const TriangleMesh& mesh, int starts) {
  const VolumeRatios ratios = compareVolumes(mesh, starts);
  std::printf("%6zu ", ratios.corners);
  if (std::isnan(ratios.box)) {
    std::printf("%7s %7s %7s ", "-", "-", "-");
    return;
  }
  std::printf("%7.4f %7.4f %7.4f ", ratios.capsule, ratios.box, ratios.rounded_box);
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
