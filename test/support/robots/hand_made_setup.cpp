// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/robots/hand_made_setup.h"

#include <algorithm>
#include <string>

#include "collision_monitor/geometry/bounds.h"
#include "pipeline/setup/setup_parts.h"
#include "support/random_poses.h"

namespace collision_monitor::test {
namespace {

Shape randomShape(Random& random) {
  const Eigen::Vector3d size =
      0.01 * Eigen::Vector3d::Ones() + 0.07 * (randomPoint(random, 1.0) + Eigen::Vector3d::Ones());
  switch (random() % 4) {
    case 0:
      return Sphere{size.x()};
    case 1:
      return Capsule{size.z(), size.x()};
    case 2:
      return Box{size};
    default:
      return RoundedBox{0.7 * size, 0.3 * size.x()};
  }
}

}  // namespace

CycleSetup handMadeSetup(const std::vector<ShapeOnLink>& shapes, const Limits& limits) {
  CycleSetup setup;
  setup.least_horizon = setup.ahead.horizon;
  setup.limits = limits;
  setup.model.robots.push_back({"hand_made", "", LinkId{0}, 0, 0, 0, 0});
  for (const ShapeOnLink& placed : shapes) {
    while (setup.model.links.size() <= placed.link) {
      Link link;
      link.name = "link_" + std::to_string(setup.model.links.size());
      link.frame = link.name;
      setup.model.links.push_back(link);
    }
    Link& link = setup.model.links[placed.link];
    link.collisions.push_back({"collision_0", placed.link_from_body, Sphere{}});
    Element element;
    element.link = idAt<LinkId>(placed.link);
    element.name = "collision_0";
    element.link_from_element = placed.link_from_body;
    element.convex =
        std::visit([](const auto& shape) { return ConvexGeometry(shape); }, placed.shape);
    element.is_exact = true;
    element.is_body = true;
    setup.bodies.push_back({element.link, placed.link_from_body, placed.shape,
                            boundingRadius(placed.shape), true,
                            idAt<ElementId>(setup.elements.size())});
    setup.elements.push_back(element);
    setup.labels.push_back({std::string("collision_0/") + kindName(placed.shape), {}, 0.0});
  }
  setup.model.robots[0].link_count = setup.model.links.size();
  for (std::size_t a = 0; a < setup.model.links.size(); ++a) {
    for (std::size_t b = a + 1; b < setup.model.links.size(); ++b) {
      setup.link_pairs.push_back({idAt<LinkId>(a), idAt<LinkId>(b), PairReason::checked});
    }
  }
  listPairs(setup);
  return setup;
}

LinkPoses knownPoses(const CycleSetup& setup) {
  LinkPoses poses = makeLinkPoses(setup.model);
  std::fill(poses.status.begin(), poses.status.end(), LinkStatus::known);
  return poses;
}

CycleSetup randomSetup(std::size_t count, unsigned seed) {
  Random random(seed);
  std::vector<ShapeOnLink> shapes;
  for (std::size_t link = 0; link < count; ++link) {
    for (std::uint64_t i = 0; i < 1 + random() % 2; ++i) {
      shapes.push_back({link, randomShape(random), randomPose(random, 0.1)});
    }
  }
  return handMadeSetup(shapes);
}

LinkPoses randomLinkPoses(const CycleSetup& setup, double reach, unsigned seed) {
  Random random(seed);
  LinkPoses poses = knownPoses(setup);
  for (Pose& pose : poses.world_from_link) {
    pose = randomPose(random, reach);
  }
  return poses;
}

std::vector<double> allDistances(const CycleSetup& setup, const BodyRows& rows) {
  constexpr double kEverywhere = std::numeric_limits<double>::infinity();
  std::vector<NearestPair> near;
  findNear(setup.blocks, rows, kEverywhere, near);
  std::vector<double> distances(setup.table.size(), std::numeric_limits<double>::quiet_NaN());
  for (const NearestPair& pair : near) {
    distances[index(pair.pair)] = pair.distance;
  }
  return distances;
}

}  // namespace collision_monitor::test
