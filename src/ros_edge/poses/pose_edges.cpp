// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <tf2/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/constants.h"
#include "ros_edge/poses/pose_reader.h"

/// The edges of a PoseReader: finds what places each link, in tf or among the joints, then judges
/// and reads it.
namespace collision_monitor {

void PoseReader::makeEdges() {
  edges_.resize(model_.links.size());
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    const Link& link = model_.links[i];
    edges_[i].child_frame = stripLeadingSlash(link.frame);
    edges_[i].parent_frame = world_frame_;
    if (link.parent_joint) {
      const Joint& joint = model_.joint(*link.parent_joint);
      edges_[i].parent_frame = stripLeadingSlash(model_.link(joint.parent).frame);
      // tf does not know objects.
      const bool is_object = isObject(model_, idAt<LinkId>(i));
      const bool places = is_object || (joints_ != nullptr && freedomOf(joint) <= 1);
      edges_[i].joint = places ? &joint : nullptr;
      edges_[i].status = is_object ? LinkStatus::known : LinkStatus::missing;  // for good
    }
  }
  // Children come after their parents.
  for (std::size_t i = edges_.size(); i-- > 0;) {
    const Link& link = model_.links[i];
    edges_[i].is_needed = edges_[i].is_needed || hasShapes(link);
    if (edges_[i].is_needed && link.parent_joint) {
      edges_[index(model_.joint(*link.parent_joint).parent)].is_needed = true;
    }
  }
}

void PoseReader::refresh() {
  const TransformStore::Version version = store_.version();
  const bool are_new =
      !has_records_ || version.topology != seen_.topology || version.jumps != seen_.jumps;
  if (are_new) {
    store_.copyRecords(records_);
    places_.clear();
    for (std::size_t i = 0; i < records_.size(); ++i) {
      places_.emplace(records_[i].name, i);
    }
    has_records_ = true;
  } else if (version.data != seen_.data) {
    store_.refreshRecords(records_);
  }
  if (are_new || haveLoopsChanged()) {
    connectAll();
  }
  seen_ = version;
  if (joints_ != nullptr) {
    joints_->refresh();
  }
}

void PoseReader::connectAll() {
  loop_frames_.clear();
  noteLoop(world_frame_);
  for (Edge& edge : edges_) {
    connect(edge);
    noteLoop(edge.child_frame);
  }
}

void PoseReader::connect(Edge& edge) const {
  edge.read_ns = -1;
  edge.path.clear();
  edge.moving_path.clear();
  edge.up_count = 0;
  if (edge.joint != nullptr) {
    edge.is_connected = true;
    return;
  }
  std::vector<std::string> up = chainAbove(edge.child_frame);
  std::vector<std::string> down = chainAbove(edge.parent_frame);
  // Around a loop, several paths connect two frames, and none is the right one.
  edge.is_connected = edge.child_frame == edge.parent_frame ||
                      (!up.empty() && !down.empty() && up.back() == down.back());
  if (!edge.is_connected) {
    return;
  }
  while (!up.empty() && !down.empty() && up.back() == down.back()) {
    up.pop_back();
    down.pop_back();
  }
  edge.up_count = up.size();
  up.insert(up.end(), down.begin(), down.end());
  for (const std::string& frame : up) {
    const std::size_t place = places_.at(frame);
    edge.path.push_back(place);
    if (!records_[place].is_static) {
      edge.moving_path.push_back(place);
    }
  }
}

bool PoseReader::isMoving(const Edge& edge) {
  return edge.joint != nullptr ? edge.joint->type != JointType::fixed : !edge.moving_path.empty();
}

/// The largest number for what does not move, 0 if no data came yet.
std::int64_t PoseReader::newestOf(const Edge& edge) const {
  std::int64_t newest_ns = std::numeric_limits<std::int64_t>::max();
  if (edge.joint != nullptr) {
    return isMoving(edge) ? joints_->newest(edge.joint->first_variable).stamp_ns : newest_ns;
  }
  for (const std::size_t frame : edge.moving_path) {
    newest_ns = std::min(newest_ns, records_[frame].newest_ns);
  }
  return newest_ns;
}

bool PoseReader::isBad(const Edge& edge) const {
  if (edge.joint != nullptr) {
    return isMoving(edge) && !std::isfinite(joints_->newest(edge.joint->first_variable).position);
  }
  return std::any_of(edge.path.begin(), edge.path.end(),
                     [&](std::size_t frame) { return records_[frame].is_bad; });
}

/// A contradiction counts for as long as a pose is trusted. With two contradicting publishers, the
/// newest stamp often has only the first one's data.
bool PoseReader::isContradicted(const Edge& edge) const {
  if (edge.joint != nullptr) {
    if (!isMoving(edge)) {
      return false;
    }
    const NewestSample& newest = joints_->newest(edge.joint->first_variable);
    return isRecent(newest.contradiction, newest.stamp_ns, max_age_);
  }
  return std::any_of(edge.moving_path.begin(), edge.moving_path.end(), [&](std::size_t frame) {
    return isRecent(records_[frame].contradiction, records_[frame].newest_ns, max_age_);
  });
}

void PoseReader::judge(std::int64_t now_ns, Edge& edge) const {
  edge.status = LinkStatus::missing;
  edge.age = kInfinity;
  if (!edge.is_needed || !edge.is_connected) {
    return;
  }
  edge.newest_ns = newestOf(edge);
  if (edge.newest_ns == 0) {
    return;
  }
  edge.age = isMoving(edge) ? 1e-9 * static_cast<double>(now_ns - edge.newest_ns) : 0.0;
  if (isBad(edge)) {
    edge.status = LinkStatus::not_finite;
  } else if (isContradicted(edge)) {
    edge.status = LinkStatus::contradicted;
  } else {
    edge.status = std::abs(edge.age) <= max_age_ ? LinkStatus::known : LinkStatus::stale;
  }
}

void PoseReader::look(std::int64_t stamp_ns, Edge& edge) const {
  if (edge.joint == nullptr) {
    lookUpTransform(stamp_ns, edge);
    return;
  }
  const bool is_known = !isMoving(edge) || std::isfinite(positions_[edge.joint->first_variable]);
  edge.read_ns = is_known ? stamp_ns : -1;
  edge.status = is_known ? LinkStatus::known : LinkStatus::stale;
  if (is_known) {
    edge.parent_from_child = parentFromChild(*edge.joint, positions_);
  }
}

void PoseReader::lookUpTransform(std::int64_t stamp_ns, Edge& edge) const {
  const bool is_newest = stamp_ns == 0 || stamp_ns == edge.newest_ns;
  edge.read_ns = -1;
  edge.status = LinkStatus::missing;
  if (!is_newest && hasGapAt(edge, stamp_ns)) {
    edge.status = LinkStatus::stale;
  } else if (compose(stamp_ns, edge) || askBuffer(stamp_ns, is_newest, edge)) {
    edge.read_ns = stamp_ns;
    edge.status = LinkStatus::known;
  }
}

/// Composes the poses of the records, many times faster than look-ups by name.
/// @return false if a record has no pose at the stamp.
bool PoseReader::compose(std::int64_t stamp_ns, Edge& edge) const {
  const bool has_poses = std::all_of(edge.path.begin(), edge.path.end(), [&](std::size_t frame) {
    const FrameRecord& record = records_[frame];
    return record.is_static ? record.pose_ns >= 0 : record.pose_ns == stamp_ns;
  });
  if (!has_poses) {
    return false;
  }
  const auto climb = [&](std::size_t first, std::size_t last) {
    Pose top_from_bottom;
    for (std::size_t i = first; i < last; ++i) {
      top_from_bottom = records_[edge.path[i]].parent_from_frame * top_from_bottom;
    }
    return top_from_bottom;
  };
  edge.parent_from_child = climb(0, edge.up_count);
  if (edge.up_count < edge.path.size()) {
    edge.parent_from_child =
        inverse(climb(edge.up_count, edge.path.size())) * edge.parent_from_child;
  }
  return true;
}

/// Asks tf2. At a stamp that is not the newest, data may begin later or have a gap. In the first
/// case tf2 throws, which is slow; in the second it interpolates across the gap.
bool PoseReader::askBuffer(std::int64_t stamp_ns, bool is_newest, Edge& edge) const {
  ros::Time stamp;
  stamp.fromNSec(static_cast<std::uint64_t>(stamp_ns));
  const tf2::BufferCore& buffer = store_.bufferOf(edge.moving_path);
  try {
    if (!is_newest && !buffer.canTransform(edge.parent_frame, edge.child_frame, stamp)) {
      return false;
    }
    edge.parent_from_child =
        toPose(buffer.lookupTransform(edge.parent_frame, edge.child_frame, stamp).transform);
  } catch (const tf2::TransformException&) {
    return false;  // the data disappeared in between, as after a jump in time
  }
  return true;
}

bool PoseReader::hasGapAt(const Edge& edge, std::int64_t stamp_ns) const {
  return std::any_of(edge.moving_path.begin(), edge.moving_path.end(),
                     [&](std::size_t frame) { return store_.gapAt(frame, stamp_ns) > max_age_; });
}

}  // namespace collision_monitor
