// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/look_ahead/find_motions.h"

#include <algorithm>
#include <utility>

#include "collision_monitor/geometry/bounds.h"
#include "collision_monitor/geometry/ids.h"
#include "geometry/ball_motion.h"
#include "pipeline/refine/sweep_pairs.h"

namespace collision_monitor {
namespace {

double reachOf(const Body& body, const ScrewMotion& link_motion) noexcept {
  return velocityAt(link_motion, body.link_from_body.translation).norm() +
         link_motion.turn.norm() * body.bounding_radius;
}

}  // namespace

SweepWork makeSweepWork(const CycleSetup& setup) {
  SweepWork work;
  work.has_motion.resize(setup.model.links.size(), 0);
  work.link_motions.resize(setup.model.links.size());
  work.body_travel.resize(setup.bodies.size(), 0.0);
  work.element_travel.resize(setup.elements.size(), 0.0);
  work.had_motion = work.has_motion;
  work.last_motions = work.link_motions;
  work.tasks.reserve(setup.element_pairs.size());
  work.task_of.resize(setup.element_pairs.size(), kNone);
  return work;
}

void findMotions(const CycleSetup& setup, const LinkPoses& poses, const BodyPoses& body_poses,
                 const PairMemory& memory, SweepWork& work) noexcept {
  const LastPoses& last = memory.last;
  if (work.elapsed > 0.0) {
    std::swap(work.had_motion, work.has_motion);
    std::swap(work.last_motions, work.link_motions);
    work.last_elapsed = work.elapsed;
  }
  if (last.stamp_ns == 0) {
    work.last_elapsed = 0.0;  // forgetPoses
  }
  forIndices(body_poses.moved.links, [&](std::size_t i) noexcept {
    work.has_motion[i] = hasStayed(last, body_poses, i) ? 1 : 0;
    if (work.has_motion[i] == 0 || isSame(last.world_from_link[i], poses.world_from_link[i])) {
      work.link_motions[i] = {last.world_from_link[i]};
    } else {
      work.link_motions[i] = screwBetween(last.world_from_link[i], poses.world_from_link[i]);
    }
  });
  forIndices(body_poses.moved.elements,
             [&](std::size_t i) noexcept { work.element_travel[i] = 0.0; });
  forIndices(body_poses.moved.bodies, [&](std::size_t i) noexcept {
    const Body& body = setup.bodies[i];
    work.body_travel[i] = reachOf(body, work.link_motions[index(body.link)]);
    double& of_element = work.element_travel[index(body.element)];
    of_element = std::max(of_element, work.body_travel[i]);
  });
  const bool is_known = last.stamp_ns > 0 && poses.stamp_ns > last.stamp_ns;
  work.elapsed = is_known ? 1e-9 * static_cast<double>(poses.stamp_ns - last.stamp_ns) : 0.0;
}

void keepLinks(const LinkPoses& poses, const BodyPoses& body_poses, PlacedLinks& placed) noexcept {
  for (const IndexRange& range : body_poses.moved.links) {
    const auto first = static_cast<std::ptrdiff_t>(range.first);
    const auto count = static_cast<std::ptrdiff_t>(range.last - range.first);
    std::copy_n(poses.world_from_link.begin() + first, count,
                placed.world_from_link.begin() + first);
    std::copy_n(body_poses.link_known.begin() + first, count, placed.known.begin() + first);
    std::copy_n(body_poses.part.begin() + first, count, placed.part.begin() + first);
  }
}

void keepPoses(const LinkPoses& poses, const BodyPoses& body_poses, LastPoses& last) noexcept {
  keepLinks(poses, body_poses, last);
  last.stamp_ns = poses.stamp_ns;
}

}  // namespace collision_monitor
