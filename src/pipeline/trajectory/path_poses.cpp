// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/trajectory/path_poses.h"

#include <algorithm>

namespace collision_monitor {

PathPoses::PathPoses(const RobotModel& model, const JointPath& path, const LinkPoses& start)
    : model_(model), path_(path), start_(start), positions_(defaultPositions(model)) {
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    const auto& parent_joint = model.links[i].parent_joint;
    if (!parent_joint) {
      places_.push_back({i, nullptr, Pose()});
      continue;
    }
    const Joint& joint = model.joint(*parent_joint);
    const JointId source = joint.mimic ? joint.mimic->source : *parent_joint;
    const bool is_moved =
        std::find(path.joints.begin(), path.joints.end(), source) != path.joints.end();
    const std::size_t parent = index(joint.parent);
    if (start.part[i] != start.part[parent]) {
      places_.push_back({i, nullptr, Pose()});  // the top link of a part stays where it is
      continue;
    }
    places_.push_back({parent, is_moved ? &joint : nullptr,
                       inverse(start.world_from_link[parent]) * start.world_from_link[i]});
  }
}

void PathPoses::placeLink(std::size_t link, std::vector<Pose>& world_from_link) const noexcept {
  const LinkPlace& place = places_[link];
  if (place.parent == link) {
    world_from_link[link] = start_.world_from_link[link];
  } else {
    world_from_link[link] = world_from_link[place.parent] *
                            (place.joint != nullptr ? parentFromChild(*place.joint, positions_)
                                                    : place.parent_from_child);
  }
}

void PathPoses::place(std::size_t segment, double share, std::vector<Pose>& world_from_link) {
  setPositions(model_, path_, segment, share, positions_);
  world_from_link.resize(places_.size());
  for (std::size_t i = 0; i < places_.size(); ++i) {
    placeLink(i, world_from_link);
  }
}

void PathPoses::mark(LinkId a, LinkId b, std::vector<unsigned char>& is_wanted) const noexcept {
  for (const LinkId end : {a, b}) {
    for (std::size_t i = index(end); is_wanted[i] == 0; i = places_[i].parent) {
      is_wanted[i] = 1;
    }
  }
}

std::size_t PathPoses::place(std::size_t segment, double share,
                             const std::vector<unsigned char>& is_wanted,
                             std::vector<Pose>& world_from_link) {
  setPositions(model_, path_, segment, share, positions_);
  world_from_link.resize(places_.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    if (is_wanted[i] != 0) {
      placeLink(i, world_from_link);
      ++count;
    }
  }
  return count;
}

}  // namespace collision_monitor
