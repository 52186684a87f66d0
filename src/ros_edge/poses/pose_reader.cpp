// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/poses/pose_reader.h"

#include <algorithm>
#include <limits>

#include "pipeline/objects/carry_objects.h"

namespace collision_monitor {

PoseReader::PoseReader(const RobotModel& model, const TransformStore& store,
                       const PoseReaderOptions& options, JointReader* joints)
    : model_(model),
      store_(store),
      world_frame_(stripLeadingSlash(options.world_frame)),
      max_age_(options.max_age),
      joints_(joints),
      positions_(model.variable_count),
      objects_(objectRuns(model)) {
  if (world_frame_.empty() && !model.robots.empty()) {
    world_frame_ = stripLeadingSlash(model.link(model.robots.front().root).frame);
  }
  makeEdges();
}

bool PoseReader::read(const ros::Time& now, LinkPoses& poses) {
  now_ns_ = static_cast<std::int64_t>(now.toNSec());
  refresh();
  for (const Robot& robot : model_.robots) {
    forOwnLinks(model_, robot, [&](std::size_t link) { judge(now_ns_, edges_[link]); });
  }
  std::int64_t oldest_ns = std::numeric_limits<std::int64_t>::max();
  bool is_new = false;
  for (std::size_t i = 0; i < model_.robots.size(); ++i) {
    const std::int64_t stamp_ns = commonStamp(model_.robots[i]);
    is_new = readRobot(model_.robots[i], stamp_ns) || is_new;
    poses.robot_stamp_ns[i] = stamp_ns;
    oldest_ns = stamp_ns > 0 ? std::min(oldest_ns, stamp_ns) : oldest_ns;
  }
  if (oldest_ns == std::numeric_limits<std::int64_t>::max()) {
    // Nothing moves, or nothing that moves is known: in the second case the last stamp stays.
    oldest_ns = isAllKnown() ? now_ns_ : poses.stamp_ns;
  }
  for (std::int64_t& stamp_ns : poses.robot_stamp_ns) {
    stamp_ns = stamp_ns > 0 ? stamp_ns : oldest_ns;
  }
  const bool has_status_changed = placeLinks(poses);
  is_new = is_new || has_status_changed || oldest_ns != poses.stamp_ns;
  poses.stamp_ns = oldest_ns;
  return is_new;
}

/// 0 if nothing of the robot both moves and is known.
std::int64_t PoseReader::commonStamp(const Robot& robot) const {
  std::int64_t stamp_ns = std::numeric_limits<std::int64_t>::max();
  forOwnLinks(model_, robot, [&](std::size_t link) {
    const Edge& edge = edges_[link];
    if (edge.status == LinkStatus::known && isMoving(edge)) {
      stamp_ns = std::min(stamp_ns, edge.newest_ns);
    }
  });
  return stamp_ns == std::numeric_limits<std::int64_t>::max() ? 0 : stamp_ns;
}

bool PoseReader::isAllKnown() const {
  bool is_all_known = true;
  for (const Robot& robot : model_.robots) {
    forOwnLinks(model_, robot, [&](std::size_t link) {
      is_all_known &= !edges_[link].is_needed || edges_[link].status == LinkStatus::known;
    });
  }
  return is_all_known;
}

/// @return true if a transform was looked up.
bool PoseReader::readRobot(const Robot& robot, std::int64_t stamp_ns) {
  bool is_new = false;
  if (joints_ != nullptr) {
    joints_->readPositions(stamp_ns, max_age_, positions_);
  }
  forOwnLinks(model_, robot, [&](std::size_t link) {
    Edge& edge = edges_[link];
    const std::int64_t wanted_ns = isMoving(edge) ? stamp_ns : 0;
    if (edge.status == LinkStatus::known && edge.read_ns != wanted_ns) {
      look(wanted_ns, edge);
      is_new = true;
    }
  });
  return is_new;
}

/// @return true if the status or part of a link changed.
bool PoseReader::placeLinks(LinkPoses& poses) const {
  bool has_changed = false;
  for (const Robot& robot : model_.robots) {
    forOwnLinks(model_, robot, [&](std::size_t link) {
      const PartId part = poses.part[link];
      const LinkStatus part_status = poses.part_status[link];
      const LinkStatus status = poses.status[link];
      placeLink(link, poses);
      has_changed = has_changed || status != poses.status[link] || part != poses.part[link] ||
                    part_status != poses.part_status[link];
    });
  }
  carryPoses(model_, objects_, poses);
  return has_changed;
}

/// Places a link relative to its parent link or, if that pose is unknown, as the top of a floating
/// part.
void PoseReader::placeLink(std::size_t link, LinkPoses& poses) const {
  const Edge& edge = edges_[link];
  if (edge.is_needed && edge.status != LinkStatus::known) {
    floatFrom(link, edge.status, poses);
    return;
  }
  Pose world_from_parent;
  double age = 0.0;
  poses.part[link] = kWorldPart;
  poses.part_status[link] = LinkStatus::known;
  if (const auto& joint = model_.links[link].parent_joint) {
    const std::size_t parent = index(model_.joint(*joint).parent);
    world_from_parent = poses.world_from_link[parent];
    age = poses.age[parent];
    poses.part[link] = poses.part[parent];
    poses.part_status[link] = poses.part_status[parent];
  }
  poses.status[link] = edge.status;
  if (edge.status == LinkStatus::known) {
    poses.world_from_link[link] = world_from_parent * edge.parent_from_child;
  }
  // Data of the near future are fresh, as from a localisation that dates its output ahead.
  poses.age[link] = std::max({0.0, age, edge.age});
}

}  // namespace collision_monitor
