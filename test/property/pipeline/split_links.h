// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "listening_scene.h"

// Links of several elements, beside links that have one element each.
namespace collision_monitor::test::measure_told_laws {

using Links = std::vector<std::vector<CollisionElement>>;

/// A link for each element.
inline Links split(const Links& links) {
  Links elements;
  for (const std::vector<CollisionElement>& link : links) {
    for (const CollisionElement& element : link) {
      elements.push_back({element});
      elements.back().front().link_from_geometry = Pose();
    }
  }
  return elements;
}

/// Moves elements with their links.
inline void place(const Links& links, const LinkPoses& poses, LinkPoses& elements) {
  elements.stamp_ns = poses.stamp_ns;
  std::size_t next = 0;
  for (std::size_t link = 0; link < links.size(); ++link) {
    for (const CollisionElement& element : links[link]) {
      elements.world_from_link[next] = poses.world_from_link[link] * element.link_from_geometry;
      elements.velocities.of_link[next] = poses.velocities.of_link[link];
      elements.velocities.known[next] = poses.velocities.known[link];
      ++next;
    }
  }
}

}  // namespace collision_monitor::test::measure_told_laws
