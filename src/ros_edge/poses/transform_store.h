// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <tf2/buffer_core.h>

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <unordered_map>
#include <vector>

#include "collision_monitor/geometry/pose.h"
#include "ros_edge/poses/frame_filter.h"
#include "ros_edge/publisher_names.h"
#include "ros_edge/refusal.h"
#include "ros_edge/threads/inheriting_mutex.h"

namespace collision_monitor {

/// The known transforms with one frame as their child.
struct FrameRecord {
  std::string name;
  std::string parent;           ///< "" before the first transform
  bool is_static{false};        ///< from tf_static
  bool is_bad{false};           ///< the last transform was NaN, infinite or no rotation
  std::int64_t newest_ns{0};    ///< stamp; 0 until a transform with a stamp came
  Refusal refusal;              ///< of the last transform
  std::int64_t heard_ns{0};     ///< the latest stamp, including refused data
  PublisherId sent_by{};        ///< sender of the newest transform
  Contradiction contradiction;  ///< the latest one
  /// At pose_ns, which is the newest stamp unless data came out of order. Static: at all times.
  Pose parent_from_frame;
  std::int64_t pose_ns{-1};  ///< -1: no pose
};

/// tf2's buffer, plus what the buffer does not tell: how new each frame's data are, where they have
/// gaps, and which were invalid. It also has the newest pose of each frame, so poses at the newest
/// stamp need no look-up by name. These are nearly all that readers ask for. So the buffer gets a
/// frame's moving transforms only when a reader asks for that frame.
///
/// A transform that is not finite, is no rotation, or (unless static) has no stamp never enters the
/// buffer. Neither does one farther ahead of now than the history is long: it would outlive all
/// that follow. Frame names lose a leading slash. When time jumps back, all moving data are
/// forgotten.
///
/// If two transforms of a frame with one stamp differ, neither is trusted more: the record keeps
/// their senders. Does not keep frames that nothing needs (keepOnly), and refuses messages with
/// more transforms than any robot has.
/// Safe for one feeder and several readers at once.
class TransformStore {
 public:
  /// Counts that tell a reader what to read again.
  struct Version {
    std::uint64_t data{0};      ///< changes with every message
    std::uint64_t topology{0};  ///< changes with new frames, other parents, static transforms
    std::uint64_t jumps{0};     ///< changes with jumps of time backwards
    std::uint64_t later{0};     ///< changes with a transform later than the last of its frame
  };

  using TimeSource = std::function<ros::Time()>;

  explicit TransformStore(TimeSource time_source = &ros::Time::now);

  /// [s] Length of the history that readers use, before the newest transform of a frame. Older ones
  /// are dropped. Default and maximum: ten, as in tf2's buffer.
  void keepFor(double seconds);

  /// From now on keeps only these frames, those of earlier calls, and frames above them in tf.
  /// Before the first call, all frames are kept.
  void keepOnly(const std::vector<std::string>& frames);

  /// Takes one message of tf or tf_static.
  /// @param publisher name of the node that sent it, if known
  void accept(const std::vector<geometry_msgs::TransformStamped>& transforms, bool is_static,
              const std::string& publisher = "");

  /// The time now. Forgets all moving data if it is before the last time read.
  ros::Time readTime();

  Version version() const;
  /// Waits until the data version differs from `seen`, or the deadline.
  void waitForNews(std::uint64_t seen, std::chrono::steady_clock::time_point deadline) const;
  /// Ends all waits, like a new message.
  void wake();

  /// A copy of all records, in the order in which their frames first appeared. Indices stay valid
  /// as long as the store.
  void copyRecords(std::vector<FrameRecord>& records) const;
  /// Updates poses, stamps and faults of records that were copied with the same topology.
  void refreshRecords(std::vector<FrameRecord>& records) const;

  /// tf2's buffer with all data of these frames, given as indices of records.
  const tf2::BufferCore& bufferOf(const std::vector<std::size_t>& frames) const;
  /// [s] The distance between the two stamps of a frame (an index of records) on either side of
  /// this one. 0 if it was received itself, or has no data before or after it. tf2 interpolates
  /// across any gap without reporting its width.
  double gapAt(std::size_t frame, std::int64_t stamp_ns) const;
  /// Transforms refused for having no stamp, since time last jumped back.
  Refusals refusedWithoutStamp() const;
  /// Transforms refused for being too far ahead of now, since then.
  Refusals refusedAhead() const;
  /// Number of messages refused for being too long, and of frames beyond the limit.
  std::uint64_t refusedTooMany() const;
  /// "" if unknown.
  std::string publisher(PublisherId id) const;

 private:
  /// A moving transform that is not in the buffer yet.
  struct Sample {
    std::int64_t stamp_ns;
    geometry_msgs::Transform parent_from_frame;
  };

  std::size_t recordOf(const std::string& frame, std::size_t expected);
  void acceptOne(const geometry_msgs::TransformStamped& transform, bool is_static,
                 std::size_t& expected);
  void acceptHeldBack();
  void takeIn(const geometry_msgs::TransformStamped& transform, bool is_static, std::size_t frame);
  bool isTooFarAhead(std::int64_t stamp_ns, FrameRecord& record);
  bool isRepeated(const geometry_msgs::TransformStamped& transform, std::size_t frame);
  bool isSameAsBefore(const geometry_msgs::TransformStamped& transform, std::size_t frame) const;
  void attach(std::size_t frame, const std::string& parent, bool is_static);
  void keepSample(std::size_t frame, const Sample& sample);
  void keepStamp(std::size_t frame, std::int64_t stamp_ns);
  void fillBuffer(std::size_t frame) const;
  ros::Time readTimeLocked();

  TimeSource time_source_;
  std::int64_t history_ns_;
  mutable InheritingMutex mutex_;
  mutable std::condition_variable news_;
  mutable tf2::BufferCore buffer_;
  mutable std::vector<std::deque<Sample>> unbuffered_;  ///< not in tf2's buffer yet; by record
  std::vector<std::deque<std::int64_t>> stamps_;        ///< the history, sorted; by record
  std::vector<FrameRecord> records_;
  std::unordered_map<std::string, std::size_t> places_;
  Version version_;
  ros::Time last_time_;
  Refusals without_stamp_;
  Refusals ahead_;
  std::uint64_t too_long_{0};
  FrameFilter filter_;
  PublisherNames publishers_;
  PublisherId publisher_{};  ///< of the current message
};

/// For a quaternion that may be slightly off unit length.
Pose toPose(const geometry_msgs::Transform& transform) noexcept;

/// Same rule as tf2: "/base" and "base" are the same frame.
std::string stripLeadingSlash(const std::string& frame);

}  // namespace collision_monitor
