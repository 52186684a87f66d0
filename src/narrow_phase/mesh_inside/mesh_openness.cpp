// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/mesh_inside/mesh_openness.h"

#include <Eigen/Geometry>
#include <cmath>
#include <memory>

#include "narrow_phase/mesh_inside/mesh_winding.h"

namespace collision_monitor {

double opennessOf(const MeshTree& tree) {
  constexpr int kPlaces = 256;
  constexpr double kBeside = 1e-6;  // of the radius
  constexpr double kError = 0.005;
  if (!tree.openSurface()) {
    return 0.0;
  }
  double area = 0.0;
  for (const Triangle& triangle : tree.triangles()) {
    area += momentsOf(triangle).area;
  }
  const auto memory = std::make_unique<MeshQueryMemory>();
  double passed = 0.0;
  double sum = 0.0;
  int places = 0;
  for (const Triangle& triangle : tree.triangles()) {
    const WindingMoments moments = momentsOf(triangle);
    passed += moments.area;
    const double here = std::floor(passed / area * kPlaces + 0.5) - places;
    if (!(moments.area > 0.0) || !(here > 0.0)) {
      continue;
    }
    const Eigen::Vector3d beside =
        moments.center + kBeside * tree.radius() / moments.area * moments.normal;
    const double number = windingNumber(tree, beside, kError, *memory).value;
    sum += here * std::abs(number - std::round(number));
    places += static_cast<int>(here);
  }
  return places > 0 ? sum / places : 0.0;
}

}  // namespace collision_monitor
