// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/ros_edge/transform_store.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace collision_monitor {
namespace {

/// tf2 refuses quaternions farther than this from unit length, with a line in the log each
/// time; here the frame becomes unknown instead.
constexpr double kQuaternionTolerance = 1e-2;

constexpr const char* kAuthority = "collision_monitor";

/// [ns] What tf2's buffer keeps.
constexpr std::int64_t kHistory = 1000000000LL * tf2::BufferCore::DEFAULT_CACHE_TIME;

bool isUsable(const geometry_msgs::Transform& transform) {
  const auto& t = transform.translation;
  const auto& q = transform.rotation;
  const double norm = q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w;
  // NaN is not less than anything.
  return std::abs(t.x) <= kFarthest && std::abs(t.y) <= kFarthest && std::abs(t.z) <= kFarthest &&
         std::abs(norm - 1.0) < kQuaternionTolerance;
}

bool hasLeadingSlash(const std::string& frame) { return !frame.empty() && frame.front() == '/'; }

geometry_msgs::TransformStamped withoutSlashes(geometry_msgs::TransformStamped transform) {
  transform.header.frame_id = stripLeadingSlash(transform.header.frame_id);
  transform.child_frame_id = stripLeadingSlash(transform.child_frame_id);
  return transform;
}

/// Signed: ros::Time cannot hold the difference of two times in the wrong order.
std::int64_t nanoseconds(const ros::Time& time) { return static_cast<std::int64_t>(time.toNSec()); }

}  // namespace

Pose toPose(const geometry_msgs::Transform& transform) noexcept {
  const auto& q = transform.rotation;
  Pose pose;
  // The store lets quaternions pass that are a little off unit length.
  pose.rotation = Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized().toRotationMatrix();
  pose.translation = {transform.translation.x, transform.translation.y, transform.translation.z};
  return pose;
}

std::string stripLeadingSlash(const std::string& frame) {
  return hasLeadingSlash(frame) ? frame.substr(1) : frame;
}

/// Messages mostly name frames in the order in which they were first seen: the one after the last
/// is looked at first.
std::size_t TransformStore::recordOf(const std::string& frame, std::size_t expected) {
  if (expected < records_.size() && records_[expected].name == frame) {
    return expected;
  }
  const auto [place, is_new] = places_.try_emplace(frame, records_.size());
  if (is_new) {
    records_.emplace_back();
    records_.back().name = frame;
    waiting_.emplace_back();
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

void TransformStore::accept(const std::vector<geometry_msgs::TransformStamped>& transforms,
                            bool is_static) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    readTimeLocked();
    std::size_t expected = 0;
    for (const geometry_msgs::TransformStamped& transform : transforms) {
      if (hasLeadingSlash(transform.header.frame_id) || hasLeadingSlash(transform.child_frame_id)) {
        acceptOne(withoutSlashes(transform), is_static, expected);
      } else {
        acceptOne(transform, is_static, expected);
      }
    }
    ++version_.data;
  }
  news_.notify_all();
}

/// @param expected the record to look at first; the one after this transform's when it returns
void TransformStore::acceptOne(const geometry_msgs::TransformStamped& transform, bool is_static,
                               std::size_t& expected) {
  const std::string& parent = transform.header.frame_id;
  if (parent.empty() || transform.child_frame_id.empty() || parent == transform.child_frame_id) {
    return;
  }
  if (!is_static && transform.header.stamp.isZero()) {
    // tf2 would read it as "always", so the link would never be old.
    ++without_stamp_;
    return;
  }
  const std::size_t frame = recordOf(transform.child_frame_id, expected);
  expected = frame + 1;
  FrameRecord& record = records_[frame];
  const std::int64_t stamp = nanoseconds(transform.header.stamp);
  if (!is_static && isTooFarAhead(stamp, record)) {
    return;
  }
  record.is_bad = !isUsable(transform.transform);
  if (record.is_bad) {
    return;
  }
  if (!is_static && (stamp == record.newest_ns || stamp < record.newest_ns - kHistory)) {
    return;  // sent again, or too old; tf2 would complain of it
  }
  if (is_static || record.is_static || record.parent != parent) {
    attach(frame, parent, is_static);
  }
  if (is_static || stamp > record.newest_ns) {
    record.parent_from_frame = toPose(transform.transform);
    record.pose_ns = stamp;
  }
  if (is_static) {
    buffer_.setTransform(transform, kAuthority, true);
    return;
  }
  record.newest_ns = std::max(record.newest_ns, stamp);
  keepSample(frame, {stamp, transform.transform});
}

/// Notes it in the record, and that it is no more.
bool TransformStore::isTooFarAhead(std::int64_t stamp_ns, FrameRecord& record) {
  const std::int64_t ahead_ns = stamp_ns - nanoseconds(last_time_);
  const bool is_refused = ahead_ns > history_ns_;
  record.refused_ahead_ns = is_refused ? ahead_ns : 0;
  ahead_ += is_refused ? 1 : 0;
  return is_refused;
}

/// What came before is of the former parent.
void TransformStore::attach(std::size_t frame, const std::string& parent, bool is_static) {
  fillBuffer(frame);
  records_[frame].is_static = is_static;
  records_[frame].parent = parent;
  records_[frame].pose_ns = -1;
  records_[frame].refused_ahead_ns = 0;
  ++version_.topology;
}

void TransformStore::keepSample(std::size_t frame, const Sample& sample) {
  std::deque<Sample>& waiting = waiting_[frame];
  waiting.push_back(sample);
  keepStamp(frame, sample.stamp_ns);
  // As many as there are stamps: the old samples themselves have long left the processor's caches.
  while (waiting.size() > stamps_[frame].size()) {
    waiting.pop_front();
  }
}

void TransformStore::keepStamp(std::size_t frame, std::int64_t stamp_ns) {
  std::deque<std::int64_t>& stamps = stamps_[frame];
  if (stamps.empty() || stamps.back() < stamp_ns) {
    stamps.push_back(stamp_ns);
  } else {  // of several publishers, or over UDP
    stamps.insert(std::upper_bound(stamps.begin(), stamps.end(), stamp_ns), stamp_ns);
  }
  // The last one before the history stays: what lies between it and the next is asked for.
  while (stamps.size() > 1 && stamps[1] < stamps.back() - history_ns_) {
    stamps.pop_front();
  }
}

void TransformStore::fillBuffer(std::size_t frame) const {
  geometry_msgs::TransformStamped transform;
  transform.header.frame_id = records_[frame].parent;
  transform.child_frame_id = records_[frame].name;
  for (const Sample& sample : waiting_[frame]) {
    transform.header.stamp.fromNSec(static_cast<std::uint64_t>(sample.stamp_ns));
    transform.transform = sample.parent_from_frame;
    buffer_.setTransform(transform, kAuthority, false);
  }
  waiting_[frame].clear();
}

const tf2::BufferCore& TransformStore::bufferOf(const std::vector<std::size_t>& frames) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const std::size_t frame : frames) {
    fillBuffer(frame);
  }
  return buffer_;
}

double TransformStore::gapAt(std::size_t frame, std::int64_t stamp_ns) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const std::deque<std::int64_t>& stamps = stamps_[frame];
  const auto after = std::lower_bound(stamps.begin(), stamps.end(), stamp_ns);
  if (after == stamps.begin() || after == stamps.end() || *after == stamp_ns) {
    return 0.0;
  }
  return 1e-9 * static_cast<double>(*after - *std::prev(after));
}

ros::Time TransformStore::readTime() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return readTimeLocked();
}

/// The clock is read under the lock: between two threads that read it before, the later one
/// could come first, and time would seem to jump back.
ros::Time TransformStore::readTimeLocked() {
  const ros::Time now = time_source_();
  if (now < last_time_) {
    buffer_.clear();
    for (std::deque<Sample>& waiting : waiting_) {
      waiting.clear();
    }
    for (std::deque<std::int64_t>& stamps : stamps_) {
      stamps.clear();
    }
    for (FrameRecord& record : records_) {
      record.newest_ns = 0;
      record.refused_ahead_ns = 0;
      record.pose_ns = record.is_static ? record.pose_ns : -1;
      record.is_bad = false;
    }
    ++version_.jumps;
    ++version_.data;
  }
  last_time_ = now;
  return now;
}

TransformStore::Version TransformStore::version() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return version_;
}

void TransformStore::waitForNews(std::uint64_t seen,
                                 std::chrono::steady_clock::time_point deadline) const {
  std::unique_lock<std::mutex> lock(mutex_);
  news_.wait_until(lock, deadline, [&] { return version_.data != seen; });
}

void TransformStore::wake() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++version_.data;
  }
  news_.notify_all();
}

void TransformStore::copyRecords(std::vector<FrameRecord>& records) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  records = records_;
}

void TransformStore::refreshRecords(std::vector<FrameRecord>& records) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (std::size_t i = 0; i < records.size() && i < records_.size(); ++i) {
    records[i].is_bad = records_[i].is_bad;
    records[i].newest_ns = records_[i].newest_ns;
    records[i].refused_ahead_ns = records_[i].refused_ahead_ns;
    records[i].parent_from_frame = records_[i].parent_from_frame;
    records[i].pose_ns = records_[i].pose_ns;
  }
}

std::uint64_t TransformStore::refusedWithoutStamp() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return without_stamp_;
}

std::uint64_t TransformStore::refusedAhead() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return ahead_;
}

}  // namespace collision_monitor
