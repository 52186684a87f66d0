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
#include <mutex>
#include <string>
#include <unordered_map>
#include <vector>

#include "collision_monitor/geometry/pose.h"
#include "ros_edge/poses/frame_filter.h"
#include "ros_edge/publisher_names.h"
#include "ros_edge/refusal.h"

namespace collision_monitor {

/// What is known of the transforms that name one frame as their child.
struct FrameRecord {
  std::string name;
  std::string parent;           ///< "" until a transform came
  bool is_static{false};        ///< from tf_static
  bool is_bad{false};           ///< the last transform was NaN, infinite or no rotation
  std::int64_t newest_ns{0};    ///< stamp; 0 until a transform with a stamp came
  Refusal refusal;              ///< of the last transform
  std::int64_t heard_ns{0};     ///< the latest stamp, of what was refused too
  PublisherId sent_by{};        ///< what is newest
  Contradiction contradiction;  ///< the last
  /// As of pose_ns, which is the newest stamp unless data came out of order. Static: at all times.
  Pose parent_from_frame;
  std::int64_t pose_ns{-1};  ///< -1: no pose
};

/// tf2's buffer, and beside it what the buffer does not tell: how new each frame's data are, where
/// they have gaps, which were no transforms at all. The newest pose of each frame stands there,
/// too, so that poses at the newest stamp need no look-up by name; and as these are nearly all that
/// is asked for, the buffer takes a frame's moving transforms in only when it is asked for the
/// frame.
///
/// A transform that is not finite, no rotation or (unless static) without stamp never enters the
/// buffer, nor does one that is farther ahead of now than the history is long: it would outlive all
/// that follow. Frame names lose a leading slash. When time jumps back, all moving data are
/// forgotten.
///
/// Of two different transforms of a frame with one stamp neither is more true: the record keeps who
/// sent them. Frames that nothing needs are not kept (keepOnly), and messages of more transforms
/// than any robot has are refused.
/// Safe for one feeder and several readers at once.
class TransformStore {
 public:
  /// Two numbers that tell a reader what to do again.
  struct Version {
    std::uint64_t data{0};      ///< changes with every message
    std::uint64_t topology{0};  ///< changes with new frames, other parents, static transforms
    std::uint64_t jumps{0};     ///< of time, backwards
    std::uint64_t later{0};     ///< changes with a transform later than the last of its frame
  };

  using TimeSource = std::function<ros::Time()>;

  explicit TransformStore(TimeSource time_source = &ros::Time::now);

  /// [s] How long before the newest transform of a frame readers ask for it: what is older is let
  /// go. Ten, as tf2's buffer has it, unless told; never more.
  void keepFor(double seconds);

  /// From now on keeps only these frames, those that were told before, and what is above them in
  /// tf. All are kept until this is called.
  void keepOnly(const std::vector<std::string>& frames);

  /// Takes in one message of tf or tf_static.
  /// @param publisher name of the node that sent it, if that is known
  void accept(const std::vector<geometry_msgs::TransformStamped>& transforms, bool is_static,
              const std::string& publisher = "");

  /// The time now. Forgets all moving data if that is before the last time read.
  ros::Time readTime();

  Version version() const;
  /// Waits until the version of the data is not `seen`, or time is up.
  void waitForNews(std::uint64_t seen, std::chrono::steady_clock::time_point deadline) const;
  /// Ends all waits, as if a message had come.
  void wake();

  /// A copy of all records, in the order in which their frames were first seen; indices
  /// stay valid for the life of the store.
  void copyRecords(std::vector<FrameRecord>& records) const;
  /// Poses, stamps and faults only, for records copied before with the same topology.
  void refreshRecords(std::vector<FrameRecord>& records) const;

  /// tf2's buffer, with all that came of these frames, which are indices of records.
  const tf2::BufferCore& bufferOf(const std::vector<std::size_t>& frames) const;
  /// [s] Between the two stamps of a frame, an index of records, that this one lies between; 0 if
  /// it was received, or if nothing came before or after it. tf2 interpolates across any gap and
  /// tells nobody how wide it is.
  double gapAt(std::size_t frame, std::int64_t stamp_ns) const;
  /// Transforms that were refused because they had no stamp, since time last jumped back.
  Refusals refusedWithoutStamp() const;
  /// Transforms that were refused because they were too far ahead of now, since then.
  Refusals refusedAhead() const;
  /// Messages that were refused because they were too long, and frames because they were too many.
  std::uint64_t refusedTooMany() const;
  /// "" if it is not known.
  std::string publisher(PublisherId id) const;

 private:
  /// A moving transform that the buffer did not take in yet.
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
  mutable std::mutex mutex_;
  mutable std::condition_variable news_;
  mutable tf2::BufferCore buffer_;
  mutable std::vector<std::deque<Sample>> unbuffered_;  ///< for the buffer; by record
  std::vector<std::deque<std::int64_t>> stamps_;        ///< of the history, sorted; by record
  std::vector<FrameRecord> records_;
  std::unordered_map<std::string, std::size_t> places_;
  Version version_;
  ros::Time last_time_;
  Refusals without_stamp_;
  Refusals ahead_;
  std::uint64_t too_long_{0};
  FrameFilter filter_;
  PublisherNames publishers_;
  PublisherId publisher_{};  ///< of the message at hand
};

/// Of a quaternion that may be a little off unit length.
Pose toPose(const geometry_msgs::Transform& transform) noexcept;

/// As tf2 does: "/base" and "base" are the same frame.
std::string stripLeadingSlash(const std::string& frame);

}  // namespace collision_monitor
