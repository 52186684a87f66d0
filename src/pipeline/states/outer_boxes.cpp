// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Core>
#include <vector>

#include "collision_monitor/geometry/bounds.h"
#include "collision_monitor/geometry/ids.h"
#include "geometry/constants.h"
#include "pipeline/states/states_block.h"

namespace collision_monitor {
namespace {

using BodyIds = std::vector<std::uint32_t>;

std::vector<BodyIds> bodiesByElement(const CycleSetup& setup) {
  std::vector<BodyIds> bodies(setup.elements.size());
  for (std::uint32_t i = 0; i < setup.bodies.size(); ++i) {
    bodies[index(setup.bodies[i].element)].push_back(i);
  }
  return bodies;
}

/// Around bodies, along the axes of a frame on their link.
Aabb boundsIn(const CycleSetup& setup, const BodyIds& bodies, const Pose& link_from_frame) {
  constexpr double kRounding = 1e-9;
  const Pose frame_from_link = inverse(link_from_frame);
  Aabb all{Eigen::Vector3d::Constant(kInfinity), Eigen::Vector3d::Constant(-kInfinity)};
  for (const std::uint32_t i : bodies) {
    const Body& body = setup.bodies[i];
    const Aabb one = aabbOf(body.shape, frame_from_link * body.link_from_body, kRounding);
    all = {all.min.cwiseMin(one.min), all.max.cwiseMax(one.max)};
  }
  return all;
}

/// Along the axes of that body for which it is smallest.
OuterBox boxAround(const CycleSetup& setup, const StatesWork& work, const BodyIds& bodies) {
  OuterBox box;
  box.core.kind = CoreKind::box;
  double least = kInfinity;
  for (const std::uint32_t i : bodies) {
    const Pose& link_from_body = setup.bodies[i].link_from_body;
    const Aabb bounds = boundsIn(setup, bodies, link_from_body);
    const Eigen::Vector3d size = bounds.max - bounds.min;
    if (i == bodies.front() || size.prod() < least) {
      least = size.prod();
      box.core.half_extents = 0.5 * size;
      box.place = work.plan.links[index(setup.bodies[i].link)];
      const Eigen::Vector3d center =
          link_from_body * Eigen::Vector3d(0.5 * (bounds.min + bounds.max));
      box.place.frame_from_link = box.place.frame_from_link * Pose{link_from_body.rotation, center};
    }
  }
  box.pose = everywhere(box.place.frame_from_link);
  return box;
}

}  // namespace

void addBoxes(const CycleSetup& setup, const StatesWork& work, StatesRefinement& refinement) {
  for (const BodyIds& bodies : bodiesByElement(setup)) {
    std::uint32_t& box = refinement.box_of.emplace_back(kNone);
    if (bodies.size() > 1) {
      box = static_cast<std::uint32_t>(setup.bodies.size() + refinement.outer_boxes.size());
      refinement.outer_boxes.push_back(boxAround(setup, work, bodies));
    } else if (bodies.size() == 1 && setup.cores[bodies.front()].kind == CoreKind::box) {
      box = bodies.front();
    }
  }
}

}  // namespace collision_monitor
