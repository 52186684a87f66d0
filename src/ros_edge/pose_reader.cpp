// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/ros_edge/pose_reader.h"

#include <tf2/exceptions.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace collision_monitor {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Pose toPose(const geometry_msgs::Transform& transform) {
  const auto& q = transform.rotation;
  Pose pose;
  // The store lets quaternions pass that are a little off unit length.
  pose.rotation = Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized().toRotationMatrix();
  pose.translation = {transform.translation.x, transform.translation.y, transform.translation.z};
  return pose;
}

}  // namespace

PoseReader::PoseReader(const RobotModel& model, const TransformStore& store,
                       const PoseReaderOptions& options)
    : model_(model),
      store_(store),
      world_frame_(stripLeadingSlash(options.world_frame)),
      max_age_(options.max_age) {
  if (world_frame_.empty() && !model.robots.empty()) {
    world_frame_ = stripLeadingSlash(model.link(model.robots.front().root).frame);
  }
  makeEdges();
}

void PoseReader::makeEdges() {
  edges_.resize(model_.links.size());
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    const Link& link = model_.links[i];
    edges_[i].child_frame = stripLeadingSlash(link.frame);
    edges_[i].parent_frame = world_frame_;
    if (link.parent_joint) {
      edges_[i].parent_frame =
          stripLeadingSlash(model_.link(model_.joint(*link.parent_joint).parent).frame);
    }
  }
  // Children stand behind their parents.
  for (std::size_t i = edges_.size(); i-- > 0;) {
    const Link& link = model_.links[i];
    edges_[i].is_needed = edges_[i].is_needed || hasShapes(link);
    if (edges_[i].is_needed && link.parent_joint) {
      edges_[index(model_.joint(*link.parent_joint).parent)].is_needed = true;
    }
  }
}

bool PoseReader::read(const ros::Time& now, LinkPoses& poses) {
  refresh();
  const auto now_ns = static_cast<std::int64_t>(now.toNSec());
  for (Edge& edge : edges_) {
    judge(now_ns, edge);
  }
  std::int64_t oldest_ns = std::numeric_limits<std::int64_t>::max();
  bool is_new = false;
  for (const Robot& robot : model_.robots) {
    const std::int64_t stamp_ns = commonStamp(robot);
    is_new = readRobot(robot, stamp_ns) || is_new;
    oldest_ns = stamp_ns > 0 ? std::min(oldest_ns, stamp_ns) : oldest_ns;
  }
  if (oldest_ns == std::numeric_limits<std::int64_t>::max()) {
    // Nothing moves, or nothing that moves is known: then the last stamp stays.
    oldest_ns = isAllKnown() ? now_ns : poses.stamp_ns;
  }
  const bool has_status_changed = placeLinks(poses);
  is_new = is_new || has_status_changed || oldest_ns != poses.stamp_ns;
  poses.stamp_ns = oldest_ns;
  return is_new;
}

void PoseReader::refresh() {
  const TransformStore::Version version = store_.version();
  if (!has_records_ || version.topology != seen_.topology || version.jumps != seen_.jumps) {
    store_.copyRecords(records_);
    places_.clear();
    for (std::size_t i = 0; i < records_.size(); ++i) {
      places_.emplace(records_[i].name, i);
    }
    for (Edge& edge : edges_) {
      connect(edge);
    }
    has_records_ = true;
  } else if (version.data != seen_.data) {
    store_.refreshRecords(records_);
  }
  seen_ = version;
}

/// The frame and what is above it, up to a frame without parent.
std::vector<std::string> PoseReader::chainAbove(const std::string& frame) const {
  std::vector<std::string> chain{frame};
  // A loop in tf would be endless; no chain is longer than there are frames.
  while (chain.size() <= records_.size()) {
    const auto place = places_.find(chain.back());
    if (place == places_.end() || records_[place->second].parent.empty()) {
      break;
    }
    chain.push_back(records_[place->second].parent);
  }
  return chain;
}

void PoseReader::connect(Edge& edge) const {
  edge.read_ns = -1;
  edge.path.clear();
  edge.moving_path.clear();
  std::vector<std::string> up = chainAbove(edge.child_frame);
  std::vector<std::string> down = chainAbove(edge.parent_frame);
  edge.is_connected = up.back() == down.back();
  if (!edge.is_connected) {
    return;
  }
  while (!up.empty() && !down.empty() && up.back() == down.back()) {
    up.pop_back();
    down.pop_back();
  }
  up.insert(up.end(), down.begin(), down.end());
  for (const std::string& frame : up) {
    const std::size_t place = places_.at(frame);
    edge.path.push_back(place);
    if (!records_[place].is_static) {
      edge.moving_path.push_back(place);
    }
  }
}

void PoseReader::judge(std::int64_t now_ns, Edge& edge) const {
  edge.status = LinkStatus::missing;
  edge.age = kInfinity;
  if (!edge.is_needed || !edge.is_connected) {
    return;
  }
  edge.newest_ns = std::numeric_limits<std::int64_t>::max();
  for (const std::size_t frame : edge.moving_path) {
    edge.newest_ns = std::min(edge.newest_ns, records_[frame].newest_ns);
  }
  if (edge.newest_ns == 0) {
    return;
  }
  edge.age = edge.moving_path.empty() ? 0.0 : 1e-9 * static_cast<double>(now_ns - edge.newest_ns);
  const bool is_bad = std::any_of(edge.path.begin(), edge.path.end(),
                                  [&](std::size_t frame) { return records_[frame].is_bad; });
  if (is_bad) {
    edge.status = LinkStatus::not_finite;
  } else {
    edge.status = std::abs(edge.age) <= max_age_ ? LinkStatus::known : LinkStatus::stale;
  }
}

/// 0 when nothing of the robot moves and is known.
std::int64_t PoseReader::commonStamp(const Robot& robot) const {
  std::int64_t stamp_ns = std::numeric_limits<std::int64_t>::max();
  for (std::size_t i = robot.first_link; i < robot.first_link + robot.link_count; ++i) {
    const Edge& edge = edges_[i];
    if (edge.status == LinkStatus::known && !edge.moving_path.empty()) {
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

/// @return true when a transform was looked up.
bool PoseReader::readRobot(const Robot& robot, std::int64_t stamp_ns) {
  bool is_new = false;
  for (std::size_t i = robot.first_link; i < robot.first_link + robot.link_count; ++i) {
    Edge& edge = edges_[i];
    const std::int64_t wanted_ns = edge.moving_path.empty() ? 0 : stamp_ns;
    if (edge.status == LinkStatus::known && edge.read_ns != wanted_ns) {
      look(wanted_ns, edge);
      is_new = true;
    }
  }
  return is_new;
}

/// At a stamp that is not the newest, the data may begin later or have a gap there; tf2
/// throws in the first case, which is slow, and bridges the second with invented poses.
void PoseReader::look(std::int64_t stamp_ns, Edge& edge) const {
  ros::Time stamp;
  stamp.fromNSec(static_cast<std::uint64_t>(stamp_ns));
  const bool is_newest = stamp_ns == 0 || stamp_ns == edge.newest_ns;
  edge.read_ns = -1;
  edge.status = LinkStatus::missing;
  const tf2::BufferCore& buffer = store_.buffer();
  if (!is_newest && hasGapAt(edge, stamp_ns)) {
    edge.status = LinkStatus::stale;
    return;
  }
  if (edge.path.empty()) {
    edge.parent_from_child = Pose();
  } else {
    try {
      if (!is_newest && !buffer.canTransform(edge.parent_frame, edge.child_frame, stamp)) {
        return;
      }
      edge.parent_from_child =
          toPose(buffer.lookupTransform(edge.parent_frame, edge.child_frame, stamp).transform);
    } catch (const tf2::TransformException&) {
      return;  // the data went away in between, as when time jumps
    }
  }
  edge.read_ns = stamp_ns;
  edge.status = LinkStatus::known;
}

bool PoseReader::hasGapAt(const Edge& edge, std::int64_t stamp_ns) const {
  return std::any_of(edge.moving_path.begin(), edge.moving_path.end(), [&](std::size_t frame) {
    const FrameRecord& record = records_[frame];
    return record.previous_ns > 0 && record.previous_ns < stamp_ns && stamp_ns < record.newest_ns &&
           1e-9 * static_cast<double>(record.newest_ns - record.previous_ns) > max_age_;
  });
}

/// @return true when the status of a link changed.
bool PoseReader::placeLinks(LinkPoses& poses) const {
  bool has_changed = false;
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    const Edge& edge = edges_[i];
    LinkStatus status = edge.status;
    double age = edge.age;
    Pose world_from_parent;
    if (const auto& joint = model_.links[i].parent_joint) {
      const std::size_t parent = index(model_.joint(*joint).parent);
      world_from_parent = poses.world_from_link[parent];
      status = poses.status[parent] == LinkStatus::known ? status : poses.status[parent];
      age = std::max(age, poses.age[parent]);
    }
    if (status == LinkStatus::known) {
      poses.world_from_link[i] = world_from_parent * edge.parent_from_child;
    }
    has_changed = has_changed || status != poses.status[i];
    poses.status[i] = status;
    // Data of the near future, as of a localisation that dates its output ahead, are fresh.
    poses.age[i] = std::max(0.0, age);
  }
  return has_changed;
}

}  // namespace collision_monitor
