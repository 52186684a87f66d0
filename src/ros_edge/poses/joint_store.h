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
#include <mutex>
#include <optional>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "ros_edge/publisher_names.h"
#include "ros_edge/refusal.h"

namespace collision_monitor {

/// What one message said of one joint. Units: [rad] or [m], [rad/s] or [m/s]; NaN: it did not.
struct JointSample {
  std::int64_t stamp_ns{0};  ///< 0: no message yet
  double position{std::numeric_limits<double>::quiet_NaN()};
  double velocity{std::numeric_limits<double>::quiet_NaN()};
};

/// The newest sample of a joint, and whether something else was said of its time.
struct NewestSample : JointSample {
  Contradiction contradiction;  ///< the last
};

/// The last samples of every joint that was heard of, by topic and name. Messages without stamp are
/// refused, and so are samples older than one that came before, and those farther ahead of now than
/// the history is long: they would outlive all that follow. Of two different positions of a joint
/// at one time neither is more true: its record keeps who sent them. Joints that nothing needs are
/// not kept (keepOnly), and messages of more joints than any robot has are refused. Safe for
/// several feeders and readers at once.
class JointStore {
 public:
  using TimeSource = std::function<ros::Time()>;

  explicit JointStore(TimeSource time_source = &ros::Time::now);

  /// Index of a joint's record; valid for the life of the store.
  using Record = std::size_t;

  /// [s] How long before the newest sample of a joint readers ask for it: what is older is let go.
  /// Ten unless told.
  void keepFor(double seconds);
  /// From now on keeps only these joints of the topic, and those that were told before. All are
  /// kept until this is called for any topic.
  void keepOnly(const std::string& topic, const std::vector<std::string>& joints);
  /// Takes in one message of a topic.
  /// @param publisher name of the node that sent it, if that is known
  void accept(const std::string& topic, const sensor_msgs::JointState& message,
              const std::string& publisher = "");
  /// Forgets all samples: time jumped back.
  void forget();

  /// How many joints were heard of; a joint that was not found may be once this changes.
  std::size_t recordCount() const;
  std::optional<Record> find(const std::string& topic, const std::string& joint) const;
  /// Of the last sample, if it was too far ahead of now.
  Refusal refusedAhead(Record record) const;

  /// A record that is to be read.
  struct Wanted {
    Record record{0};
    bool wraps{false};  ///< an angle that may jump by whole turns, as of a continuous joint
  };
  /// The newest sample of each record.
  void readNewest(const std::vector<Wanted>& wanted, std::vector<NewestSample>& samples) const;
  /// The samples at a stamp, between two that were received as the straight line has it, for an
  /// angle that wraps the shorter way round. Such that are not known then have no stamp: the record
  /// begins later, ends earlier, or has a gap there longer than `longest_gap` [s].
  void readAt(const std::vector<Wanted>& wanted, std::int64_t stamp_ns, double longest_gap,
              std::vector<JointSample>& samples) const;
  /// A count that grows with each sample later than the last of its joint, refused or not.
  std::uint64_t laterCount() const;
  /// Messages that were refused because they were too long.
  std::uint64_t refusedTooLong() const;
  /// "" if it is not known.
  std::string publisher(PublisherId id) const;

 private:
  struct History {
    /// By stamp. Another joint, or another robot's, may be as far behind as `max_age` lets it.
    std::deque<JointSample> samples;
    Refusal refusal;              ///< of the last sample
    std::int64_t heard_ns{0};     ///< the latest stamp, of what was refused too
    PublisherId sent_by{};        ///< the newest sample
    Contradiction contradiction;  ///< the last
  };
  struct Topic {
    std::unordered_set<std::string> wanted;
    std::unordered_map<std::string, Record> places;  ///< by name
    // Messages of a topic mostly name the same joints: what the last one named, and where they are.
    std::vector<std::string> names;
    std::vector<Record> records;  ///< kNoRecord: not wanted
  };
  static constexpr Record kNoRecord = static_cast<Record>(-1);

  void findRecords(const std::vector<std::string>& names, Topic& topic);
  void keepSample(const JointSample& sample, PublisherId publisher, History& history) const;

  TimeSource time_source_;
  mutable std::mutex mutex_;
  std::map<std::string, Topic> topics_;
  bool wants_all_{true};
  std::size_t most_joints_;  ///< of a message
  std::uint64_t later_{0};
  std::uint64_t too_long_{0};
  PublisherNames publishers_;
  std::vector<History> histories_;
  std::int64_t history_ns_{10'000'000'000};
};

}  // namespace collision_monitor
