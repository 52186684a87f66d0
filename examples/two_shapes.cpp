// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
// The distance of a capsule from a box or a mesh:
//   two_shapes [MESH_FILE]
#include <iostream>

#include "collision_monitor/solid.h"

int main(int argc, char** argv) try {
  namespace cm = collision_monitor;
  const cm::Solid capsule = cm::Solid::capsule(0.1, 0.4);
  const cm::Solid other =
      argc > 1 ? cm::Solid::mesh(std::filesystem::path(argv[1])) : cm::Solid::box({0.2, 0.2, 0.2});
  cm::Pose world_from_capsule;
  world_from_capsule.translation = Eigen::Vector3d(0.5, 0.0, 0.0);
  cm::SolidQuery query;
  const cm::SolidDistance found = query.distance(capsule, world_from_capsule, other, cm::Pose());
  std::cout << "distance " << found.measured.distance << " m, nearest points "
            << found.measured.point_on_a.transpose() << " and "
            << found.measured.point_on_b.transpose() << '\n';
} catch (const std::exception& fault) {
  std::cerr << fault.what() << '\n';
  return 1;
}
