// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <iterator>

#include "ros_edge/poses/transform_store.h"

/// What readers ask a store, and its time.
namespace collision_monitor {

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

/// Reads the clock under the lock. Otherwise, of two threads that read it before, the later could
/// come first, and time would seem to jump back.
ros::Time TransformStore::readTimeLocked() {
  const ros::Time now = time_source_();
  if (now < last_time_) {
    buffer_.clear();
    for (std::deque<Sample>& unbuffered : unbuffered_) {
      unbuffered.clear();
    }
    for (std::deque<std::int64_t>& stamps : stamps_) {
      stamps.clear();
    }
    for (FrameRecord& record : records_) {
      record.newest_ns = record.heard_ns = 0;
      record.contradiction = Contradiction();
      record.refusal = Refusal();
      record.pose_ns = record.is_static ? record.pose_ns : -1;
      record.is_bad = false;
    }
    without_stamp_ = ahead_ = Refusals();
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
    records[i].refusal = records_[i].refusal;
    records[i].parent_from_frame = records_[i].parent_from_frame;
    records[i].pose_ns = records_[i].pose_ns;
    records[i].contradiction = records_[i].contradiction;
  }
}

Refusals TransformStore::refusedWithoutStamp() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return without_stamp_;
}

Refusals TransformStore::refusedAhead() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return ahead_;
}

std::uint64_t TransformStore::refusedTooMany() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return too_long_ + filter_.refusedCount();
}

std::string TransformStore::publisher(PublisherId id) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return publishers_.nameOf(id);
}

}  // namespace collision_monitor
