// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>
#include <sensor_msgs/JointState.h>

#include <cstdint>
#include <deque>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "ros_edge/publisher_names.h"
#include "ros_edge/refusal.h"
#include "ros_edge/threads/inheriting_mutex.h"

namespace collision_monitor {

/// One message's data about one joint. Units: [rad] or [m], [rad/s] or [m/s]; NaN: not given.
struct JointSample {
  std::int64_t stamp_ns{0};  ///< 0: no message yet
  double position{std::numeric_limits<double>::quiet_NaN()};
  double velocity{std::numeric_limits<double>::quiet_NaN()};
};

/// The newest sample of a joint, and whether another one contradicts it.
struct NewestSample : JointSample {
  Contradiction contradiction;  ///< the latest one
};

/// The latest samples of every joint, by topic and name. Refuses messages without stamp, samples
/// older than an earlier one, and samples farther ahead of now than the history is long, which
/// would outlive all that follow. If two positions of a joint at one time differ, neither is
/// trusted more: the record keeps their senders. Does not keep joints that nothing needs
/// (keepOnly), and refuses messages with more joints than any robot has. Safe for several feeders
/// and readers at once.
class JointStore {
 public:
  using TimeSource = std::function<ros::Time()>;

  explicit JointStore(TimeSource time_source = &ros::Time::now);

  /// Index of a joint's record; valid as long as the store.
  using Record = std::size_t;

  /// [s] Length of the history that readers use, before the newest sample of a joint. Older samples
  /// are dropped. Default: ten.
  void keepFor(double seconds);
  /// From now on keeps only these joints of the topic, and those of earlier calls. Before the first
  /// call for any topic, all joints are kept.
  void keepOnly(const std::string& topic, const std::vector<std::string>& joints);
  /// Takes one message of a topic.
  /// @param publisher name of the node that sent it, if known
  void accept(const std::string& topic, const sensor_msgs::JointState& message,
              const std::string& publisher = "");
  /// Forgets all samples, after time jumped back.
  void forget();

  /// Number of joints heard of. When it changes, a joint that was missing may be found.
  std::size_t recordCount() const;
  std::optional<Record> find(const std::string& topic, const std::string& joint) const;
  /// The refusal of the last sample, if it was too far ahead of now.
  Refusal refusedAhead(Record record) const;

  /// A record to be read.
  struct Wanted {
    Record record{0};
    bool wraps{false};  ///< an angle that may jump by whole turns, as for a continuous joint
  };
  /// The newest sample of each record.
  void readNewest(const std::vector<Wanted>& wanted, std::vector<NewestSample>& samples) const;
  /// The samples at a stamp. Between two received samples it interpolates linearly, and by the
  /// shorter direction for an angle that wraps. A sample has no stamp if it is unknown: the record
  /// begins later, ends earlier, or has a gap there longer than `longest_gap` [s].
  void readAt(const std::vector<Wanted>& wanted, std::int64_t stamp_ns, double longest_gap,
              std::vector<JointSample>& samples) const;
  /// A count that grows with each sample later than the joint's last, refused or not.
  std::uint64_t laterCount() const;
  /// Messages refused because they had no stamp.
  Refusals refusedWithoutStamp() const;
  /// Number of messages refused because they were too long.
  std::uint64_t refusedTooLong() const;
  /// "" if unknown.
  std::string publisher(PublisherId id) const;

 private:
  struct History {
    /// By stamp. Another joint or robot may lag by up to `max_age`.
    std::deque<JointSample> samples;
    Refusal refusal;              ///< of the last sample
    std::int64_t heard_ns{0};     ///< the latest stamp, including refused data
    PublisherId sent_by{};        ///< sender of the newest sample
    Contradiction contradiction;  ///< the latest one
  };
  struct Topic {
    std::unordered_set<std::string> wanted;
    std::unordered_map<std::string, Record> places;  ///< by name
    // Messages of a topic mostly have the same names: those of the last message and their records.
    std::vector<std::string> names;
    std::vector<Record> records;  ///< kNoRecord: not wanted
  };
  static constexpr Record kNoRecord = static_cast<Record>(-1);

  void findRecords(const std::vector<std::string>& names, Topic& topic);
  void keepSample(const JointSample& sample, PublisherId publisher, History& history) const;

  TimeSource time_source_;
  mutable InheritingMutex mutex_;
  std::map<std::string, Topic> topics_;
  bool wants_all_{true};
  std::size_t most_joints_;  ///< limit per message
  std::uint64_t later_{0};
  Refusals without_stamp_;
  std::uint64_t too_long_{0};
  PublisherNames publishers_;
  std::vector<History> histories_;
  std::int64_t history_ns_{10'000'000'000};
};

}  // namespace collision_monitor
