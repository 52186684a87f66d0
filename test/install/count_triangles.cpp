// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <collision_monitor/model/urdf_reader.h>

#include <cstdio>
#include <fstream>
#include <iterator>

#ifdef HAS_MESSAGES
#include <collision_monitor/State.h>
static_assert(collision_monitor::State::OK == 0, "the messages are those of the package");
#endif

namespace {

std::string readFile(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

/// A program of another package: prints how many triangles the meshes of a URDF have.
int main(int, char** argv) {
  using namespace collision_monitor;
  RobotDescription description;
  description.source = argv[1];
  description.urdf_xml = readFile(argv[1]);
  SetupReport report;
  const RobotModel model = readRobots({description}, readFile, report);
  for (const Problem& problem : report.errors) {
    std::printf("%s\n", toString(problem).c_str());
  }
  std::size_t triangles = 0;
  for (const Link& link : model.links) {
    for (const CollisionElement& element : link.collisions) {
      if (const auto* mesh = std::get_if<TriangleMesh>(&element.geometry)) {
        triangles += mesh->triangles.size();
      }
    }
  }
  std::printf("%zu triangles\n", triangles);
  return report.errors.empty() ? 0 : 1;
}
