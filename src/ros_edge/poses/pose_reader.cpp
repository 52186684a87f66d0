// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/poses/pose_reader.h"

#include <algorithm>
#include <limits>

namespace collision_monitor {

PoseReader::PoseReader(const RobotModel& model, const TransformStore& store,
                       const PoseReaderOptions& options, JointReader* joints)
    : model_(model),
      store_(store),
      world_frame_(stripLeadingSlash(options.world_frame)),
      max_age_(options.max_age),
      joints_(joints),
      positions_(model.variable_count) {
  if (world_frame_.empty() && !model.robots.empty()) {
    world_frame_ = stripLeadingSlash(model.link(model.robots.front().root).frame);
  }
  makeEdges();
}

bool PoseReader::read(const ros::Time& now, LinkPoses& poses) {
  refresh();
  now_ns_ = static_cast<std::int64_t>(now.toNSec());
  for (Edge& edge : edges_) {
    judge(now_ns_, edge);
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
  for (std::size_t i = robot.first_link; i < robot.first_link + robot.link_count; ++i) {
    const Edge& edge = edges_[i];
    if (edge.status == LinkStatus::known && isMoving(edge)) {
      stamp_ns = std::min(stamp_ns, edge.newest_ns);
    }
  }
  return stamp_ns == std::numeric_limits<std::int64_t>::max() ? 0 : stamp_ns;
}

bool PoseReader::isAllKnown() const {
  return std::all_of(edges_.begin(), edges_.end(), [](const Edge& edge) {
    return !edge.is_needed || edge.status == LinkStatus::known;
  });
}

/// @return true if a transform was looked up.
bool PoseReader::readRobot(const Robot& robot, std::int64_t stamp_ns) {
  bool is_new = false;
  if (joints_ != nullptr) {
    joints_->readPositions(stamp_ns, max_age_, positions_);
  }
  for (std::size_t i = robot.first_link; i < robot.first_link + robot.link_count; ++i) {
    Edge& edge = edges_[i];
    const std::int64_t wanted_ns = isMoving(edge) ? stamp_ns : 0;
    if (edge.status == LinkStatus::known && edge.read_ns != wanted_ns) {
      look(wanted_ns, edge);
      is_new = true;
    }
  }
  return is_new;
}

/// @return true if the status or part of a link changed.
bool PoseReader::placeLinks(LinkPoses& poses) const {
  bool has_changed = false;
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    const PartId part = poses.part[i];
    const LinkStatus part_status = poses.part_status[i];
    const LinkStatus status = poses.status[i];
    placeLink(i, poses);
    has_changed = has_changed || status != poses.status[i] || part != poses.part[i] ||
                  part_status != poses.part_status[i];
  }
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
