// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/robots/geometry_setup.h"

#include <algorithm>
#include <string>

#include "pipeline/setup/setup_parts.h"

namespace collision_monitor::test {

CycleSetup geometrySetup(const std::vector<Geometry>& geometries, const SetupOptions& options) {
  std::vector<std::vector<CollisionElement>> links;
  for (const Geometry& geometry : geometries) {
    links.push_back({{"collision_0", Pose(), geometry}});
  }
  return linkSetup(links, options);
}

CycleSetup linkSetup(const std::vector<std::vector<CollisionElement>>& links,
                     const SetupOptions& options) {
  CycleSetup setup;
  setup.least_horizon = setup.ahead.horizon;
  setup.limits = options.limits;
  setup.refine = options.refine.limits;
  setup.model.robots.push_back({"hand_made", "", LinkId{0}, 0, links.size(), 0, 0});
  for (std::size_t i = 0; i < links.size(); ++i) {
    Link link;
    link.name = "link_" + std::to_string(i);
    link.frame = link.name;
    link.collisions = links[i];
    setup.model.links.push_back(link);
    for (std::size_t b = i + 1; b < links.size(); ++b) {
      setup.link_pairs.push_back({idAt<LinkId>(i), idAt<LinkId>(b), PairReason::checked});
    }
  }
  const FitSettings settings{options.default_limits, options.padding, {}, {}};
  const std::vector<LinkFit> fits = fitLinks(setup.model, settings, {}, setup.report);
  makeBodies(fits, setup);
  makeElements(fits, {options.refine.geometry, settings.rules}, setup, setup.report);
  listPairs(setup);
  return setup;
}

TriangleMesh angleMesh() {
  constexpr double kOutline[6][2] = {{0, 0},     {0.3, 0},   {0.3, 0.1},
                                     {0.1, 0.1}, {0.1, 0.3}, {0, 0.3}};
  TriangleMesh mesh;
  for (const double z : {-0.05, 0.05}) {
    for (const auto& corner : kOutline) {
      mesh.vertices.emplace_back(corner[0], corner[1], z);
    }
  }
  constexpr std::uint32_t kFace[4][3] = {{0, 1, 3}, {1, 2, 3}, {0, 3, 5}, {3, 4, 5}};
  for (const auto& face : kFace) {
    mesh.triangles.push_back({face[0] + 6, face[1] + 6, face[2] + 6});
    mesh.triangles.push_back({face[0], face[2], face[1]});
  }
  for (std::uint32_t i = 0; i < 6; ++i) {
    const std::uint32_t next = (i + 1) % 6;
    mesh.triangles.push_back({i, next, next + 6});
    mesh.triangles.push_back({i, next + 6, i + 6});
  }
  return mesh;
}

Pose hookedPose() {
  // Half a turn about z. One bar is 0.02 m above the other's end, one inside the other angle.
  Pose pose;
  pose.rotation.diagonal() = Eigen::Vector3d(-1.0, -1.0, 1.0);
  pose.translation = Eigen::Vector3d(0.25, 0.42, 0.0);
  return pose;
}

}  // namespace collision_monitor::test
