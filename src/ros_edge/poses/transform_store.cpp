// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/poses/transform_store.h"

#include <tf2/exceptions.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace collision_monitor {
namespace {

/// tf2 refuses quaternions farther than this from unit length and logs each one. Here the frame
/// becomes unknown instead.
constexpr double kQuaternionTolerance = 1e-2;

constexpr const char* kAuthority = "collision_monitor";

/// [ns] The length of the history in tf2's buffer.
constexpr std::int64_t kHistory = 1000000000LL * tf2::BufferCore::DEFAULT_CACHE_TIME;

bool isUsable(const geometry_msgs::Transform& transform) {
  const auto& t = transform.translation;
  const auto& q = transform.rotation;
  const double norm = q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w;
  // Comparisons with NaN are false.
  return std::abs(t.x) <= kFarthest && std::abs(t.y) <= kFarthest && std::abs(t.z) <= kFarthest &&
         std::abs(norm - 1.0) < kQuaternionTolerance;
}

bool hasLeadingSlash(const std::string& frame) { return !frame.empty() && frame.front() == '/'; }

geometry_msgs::TransformStamped withoutSlashes(geometry_msgs::TransformStamped transform) {
  transform.header.frame_id = stripLeadingSlash(transform.header.frame_id);
  transform.child_frame_id = stripLeadingSlash(transform.child_frame_id);
  return transform;
}

/// Signed: ros::Time cannot hold a negative difference.
std::int64_t nanoseconds(const ros::Time& time) { return static_cast<std::int64_t>(time.toNSec()); }

}  // namespace

Pose toPose(const geometry_msgs::Transform& transform) noexcept {
  const auto& q = transform.rotation;
  Pose pose;
  // The store accepts quaternions slightly off unit length.
  pose.rotation = Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized().toRotationMatrix();
  pose.translation = {transform.translation.x, transform.translation.y, transform.translation.z};
  return pose;
}

std::string stripLeadingSlash(const std::string& frame) {
  return hasLeadingSlash(frame) ? frame.substr(1) : frame;
}

/// Finds a frame's record. Messages mostly name frames in the order of their first appearance, so
/// the record after the last one is tried first.
std::size_t TransformStore::recordOf(const std::string& frame, std::size_t expected) {
  if (expected < records_.size() && records_[expected].name == frame) {
    return expected;
  }
  const auto [place, is_new] = places_.try_emplace(frame, records_.size());
  if (is_new) {
    records_.emplace_back();
    records_.back().name = frame;
    unbuffered_.emplace_back();
    stamps_.emplace_back();
    ++version_.topology;
  }
  return place->second;
}

TransformStore::TransformStore(TimeSource time_source)
    : time_source_(std::move(time_source)), history_ns_(kHistory) {}

void TransformStore::keepFor(double seconds) {
  const std::lock_guard<std::mutex> lock(mutex_);
  history_ns_ = static_cast<std::int64_t>(std::min(1e9 * seconds, static_cast<double>(kHistory)));
}

void TransformStore::keepOnly(const std::vector<std::string>& frames) {
  std::vector<std::string> names;
  std::transform(frames.begin(), frames.end(), std::back_inserter(names), stripLeadingSlash);
  const std::lock_guard<std::mutex> lock(mutex_);
  filter_.want(names);
  acceptHeldBack();
  ++version_.data;
}

void TransformStore::accept(const std::vector<geometry_msgs::TransformStamped>& transforms,
                            bool is_static, const std::string& publisher) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (transforms.size() > filter_.mostTransforms()) {
      ++too_long_;
      return;
    }
    readTimeLocked();
    publisher_ = publishers_.idOf(publisher);
    std::size_t expected = 0;
    for (const geometry_msgs::TransformStamped& transform : transforms) {
      if (hasLeadingSlash(transform.header.frame_id) || hasLeadingSlash(transform.child_frame_id)) {
        acceptOne(withoutSlashes(transform), is_static, expected);
      } else {
        acceptOne(transform, is_static, expected);
      }
    }
    acceptHeldBack();
    ++version_.data;
  }
  news_.notify_all();
}

/// Accepts held-back transforms of frames that are wanted by now. Each may make another frame
/// wanted.
void TransformStore::acceptHeldBack() {
  geometry_msgs::TransformStamped transform;
  std::size_t expected = 0;
  while (filter_.release(transform)) {
    acceptOne(transform, true, expected);
  }
}

/// @param expected the record to try first; on return, the one after this transform's
void TransformStore::acceptOne(const geometry_msgs::TransformStamped& transform, bool is_static,
                               std::size_t& expected) {
  const std::string& parent = transform.header.frame_id;
  const std::string& child = transform.child_frame_id;
  if (parent.empty() || child.empty() || parent == child) {
    return;
  }
  const bool is_expected = expected < records_.size() && records_[expected].name == child;
  if (!is_expected && !filter_.isWanted(child)) {
    if (is_static) {
      filter_.holdBack(transform);
    }
    return;
  }
  if (!is_static && transform.header.stamp.isZero()) {
    // tf2 would read it as "always", so the link would never grow old.
    without_stamp_ = {without_stamp_.count + 1, nanoseconds(last_time_)};
    return;
  }
  const std::size_t frame = recordOf(child, expected);
  expected = frame + 1;
  takeIn(transform, is_static, frame);
}

void TransformStore::takeIn(const geometry_msgs::TransformStamped& transform, bool is_static,
                            std::size_t frame) {
  FrameRecord& record = records_[frame];
  const std::string& parent = transform.header.frame_id;
  const std::int64_t stamp = nanoseconds(transform.header.stamp);
  version_.later += stamp > record.heard_ns ? 1 : 0;
  record.heard_ns = std::max(record.heard_ns, stamp);
  if (!is_static && isTooFarAhead(stamp, record)) {
    return;
  }
  record.is_bad = !isUsable(transform.transform);
  if (record.is_bad) {
    return;
  }
  if (!is_static && (isRepeated(transform, frame) || stamp < record.newest_ns - kHistory)) {
    return;  // repeated or too old; tf2 would log it
  }
  if (is_static || record.is_static || record.parent != parent) {
    attach(frame, parent, is_static);
  }
  if (is_static || stamp > record.newest_ns) {
    record.parent_from_frame = toPose(transform.transform);
    record.pose_ns = stamp;
    record.sent_by = publisher_;
  }
  if (is_static) {
    buffer_.setTransform(transform, kAuthority, true);
    return;
  }
  record.newest_ns = std::max(record.newest_ns, stamp);
  keepSample(frame, {stamp, transform.transform});
}

/// Whether a transform with that stamp was kept. Notes a contradiction if the two differ.
bool TransformStore::isRepeated(const geometry_msgs::TransformStamped& transform,
                                std::size_t frame) {
  const std::int64_t stamp_ns = nanoseconds(transform.header.stamp);
  const std::deque<std::int64_t>& stamps = stamps_[frame];
  FrameRecord& record = records_[frame];
  if (record.is_static || (!stamps.empty() && stamp_ns > stamps.back()) ||
      !std::binary_search(stamps.begin(), stamps.end(), stamp_ns)) {
    return false;
  }
  if (!isSameAsBefore(transform, frame)) {
    record.contradiction = {stamp_ns, record.sent_by, publisher_};
  }
  return true;
}

/// @pre a transform with its stamp is kept
bool TransformStore::isSameAsBefore(const geometry_msgs::TransformStamped& transform,
                                    std::size_t frame) const {
  const FrameRecord& record = records_[frame];
  const Pose now = toPose(transform.transform);
  Pose before = record.parent_from_frame;
  if (record.parent != transform.header.frame_id) {
    return false;
  }
  if (record.pose_ns != nanoseconds(transform.header.stamp)) {
    fillBuffer(frame);
    try {
      before = toPose(
          buffer_.lookupTransform(record.parent, record.name, transform.header.stamp).transform);
    } catch (const tf2::TransformException&) {
      return true;  // it was dropped, and newer data count
    }
  }
  constexpr double kSame = 1e-6;  // [m] and [rad] between two programs for the same state
  return (now.translation - before.translation).cwiseAbs().maxCoeff() <= kSame &&
         (now.rotation - before.rotation).cwiseAbs().maxCoeff() <= kSame;
}

/// Notes in the record whether it is.
bool TransformStore::isTooFarAhead(std::int64_t stamp_ns, FrameRecord& record) {
  const std::int64_t now_ns = nanoseconds(last_time_);
  const bool is_refused = stamp_ns - now_ns > history_ns_;
  record.refusal = Refusal();
  if (is_refused) {
    record.refusal = {stamp_ns - now_ns, now_ns};
    ahead_ = {ahead_.count + 1, now_ns};
  }
  return is_refused;
}

/// Sets the frame's parent. Earlier data belong to the former parent.
void TransformStore::attach(std::size_t frame, const std::string& parent, bool is_static) {
  fillBuffer(frame);
  records_[frame].is_static = is_static;
  records_[frame].parent = parent;
  records_[frame].pose_ns = -1;
  records_[frame].refusal = Refusal();
  filter_.wantParent(parent);
  ++version_.topology;
}

void TransformStore::keepSample(std::size_t frame, const Sample& sample) {
  std::deque<Sample>& unbuffered = unbuffered_[frame];
  unbuffered.push_back(sample);
  keepStamp(frame, sample.stamp_ns);
  // As many samples as stamps. The stamps decide, because old samples are no longer in the
  // processor's caches.
  while (unbuffered.size() > stamps_[frame].size()) {
    unbuffered.pop_front();
  }
}

void TransformStore::keepStamp(std::size_t frame, std::int64_t stamp_ns) {
  std::deque<std::int64_t>& stamps = stamps_[frame];
  if (stamps.empty() || stamps.back() < stamp_ns) {
    stamps.push_back(stamp_ns);
  } else {  // from several publishers, or over UDP
    stamps.insert(std::upper_bound(stamps.begin(), stamps.end(), stamp_ns), stamp_ns);
  }
  // Keeps the last stamp before the history: readers need it for the gap up to the next.
  while (stamps.size() > 1 && stamps[1] < stamps.back() - history_ns_) {
    stamps.pop_front();
  }
}

void TransformStore::fillBuffer(std::size_t frame) const {
  geometry_msgs::TransformStamped transform;
  transform.header.frame_id = records_[frame].parent;
  transform.child_frame_id = records_[frame].name;
  for (const Sample& sample : unbuffered_[frame]) {
    transform.header.stamp.fromNSec(static_cast<std::uint64_t>(sample.stamp_ns));
    transform.transform = sample.parent_from_frame;
    buffer_.setTransform(transform, kAuthority, false);
  }
  unbuffered_[frame].clear();
}

}  // namespace collision_monitor
