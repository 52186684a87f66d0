// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/poses/joint_store.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "collision_monitor/geometry/pose.h"
#include "ros_edge/to_seconds.h"

namespace collision_monitor {
namespace {

/// NaN if the message has no valid value there.
double valueOr(const std::vector<double>& values, std::size_t place) {
  return place < values.size() && std::abs(values[place]) <= kFarthest
             ? values[place]
             : std::numeric_limits<double>::quiet_NaN();
}

JointSample newestOf(const std::deque<JointSample>& samples) {
  return samples.empty() ? JointSample() : samples.back();
}

/// Far more joints than any robot has.
constexpr std::size_t kMostJoints = 10000;

/// [rad] or [m] Tolerance between two programs that compute the same state.
constexpr double kSame = 1e-6;

/// NaN equals only NaN.
bool isSame(double one, double other) {
  return std::abs(one - other) <= kSame || (std::isnan(one) && std::isnan(other));
}

struct Moment {
  std::int64_t stamp_ns;
  double longest_gap;
  bool wraps;
};

/// No stamp if the two samples are too far apart.
/// @pre the moment is between them
JointSample sampleBetween(const JointSample& before, const JointSample& after,
                          const Moment& moment) {
  const double gap = toSeconds(after.stamp_ns - before.stamp_ns);
  if (gap > moment.longest_gap) {
    return {};
  }
  constexpr double kTurn = 6.283185307179586;
  const double delta = after.position - before.position;
  const double share = toSeconds(moment.stamp_ns - before.stamp_ns) / gap;
  return {moment.stamp_ns,
          before.position + share * (moment.wraps ? std::remainder(delta, kTurn) : delta),
          before.velocity + share * (after.velocity - before.velocity)};
}

}  // namespace

JointStore::JointStore(TimeSource time_source)
    : time_source_(std::move(time_source)), most_joints_(kMostJoints) {}

void JointStore::keepOnly(const std::string& topic, const std::vector<std::string>& joints) {
  const std::lock_guard<std::mutex> lock(mutex_);
  wants_all_ = false;
  Topic& known = topics_[topic];
  known.wanted.insert(joints.begin(), joints.end());
  known.names.clear();  // names of the last message may have become wanted
  most_joints_ = std::max(most_joints_, 2 * known.wanted.size());
}

void JointStore::keepFor(double seconds) {
  const std::lock_guard<std::mutex> lock(mutex_);
  history_ns_ = static_cast<std::int64_t>(1e9 * seconds);
}

void JointStore::accept(const std::string& topic, const sensor_msgs::JointState& message,
                        const std::string& publisher) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (message.header.stamp.isZero()) {  // it would never grow old
    without_stamp_ = {without_stamp_.count + 1, static_cast<std::int64_t>(time_source_().toNSec())};
    return;
  }
  if (message.name.size() > most_joints_) {
    ++too_long_;
    return;
  }
  const auto stamp_ns = static_cast<std::int64_t>(message.header.stamp.toNSec());
  // Read under the lock: data from before a jump back must not be stored after `forget`.
  const auto now_ns = static_cast<std::int64_t>(time_source_().toNSec());
  const bool is_too_far_ahead = stamp_ns - now_ns > history_ns_;
  const PublisherId sent_by = publishers_.idOf(publisher);
  Topic& known = topics_[topic];
  if (known.names != message.name) {
    findRecords(message.name, known);
  }
  for (std::size_t i = 0; i < message.name.size(); ++i) {
    if (known.records[i] == kNoRecord) {
      continue;
    }
    History& history = histories_[known.records[i]];
    later_ += stamp_ns > history.heard_ns ? 1 : 0;
    history.heard_ns = std::max(history.heard_ns, stamp_ns);
    history.refusal = is_too_far_ahead ? Refusal{stamp_ns - now_ns, now_ns} : Refusal();
    if (!is_too_far_ahead) {
      keepSample({stamp_ns, valueOr(message.position, i), valueOr(message.velocity, i)}, sent_by,
                 history);
    }
  }
}

void JointStore::keepSample(const JointSample& sample, PublisherId publisher,
                            History& history) const {
  std::deque<JointSample>& samples = history.samples;
  const JointSample newest = newestOf(samples);
  if (sample.stamp_ns == newest.stamp_ns && !isSame(sample.position, newest.position)) {
    history.contradiction = {sample.stamp_ns, history.sent_by, publisher};
  }
  if (sample.stamp_ns == newest.stamp_ns && !isSame(sample.velocity, newest.velocity)) {
    samples.back().velocity = std::numeric_limits<double>::quiet_NaN();
  }
  if (sample.stamp_ns <= newest.stamp_ns) {
    return;
  }
  samples.push_back(sample);
  history.sent_by = publisher;
  // Keeps the last sample before the history: readers need it to interpolate to the next.
  while (samples.size() > 1 && samples[1].stamp_ns < sample.stamp_ns - history_ns_) {
    samples.pop_front();
  }
}

void JointStore::findRecords(const std::vector<std::string>& names, Topic& topic) {
  topic.names = names;
  topic.records.clear();
  for (const std::string& name : names) {
    if (!wants_all_ && topic.wanted.count(name) == 0) {
      topic.records.push_back(kNoRecord);
      continue;
    }
    const auto [place, is_new] = topic.places.try_emplace(name, histories_.size());
    if (is_new) {
      histories_.emplace_back();
    }
    topic.records.push_back(place->second);
  }
}

void JointStore::forget() {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (History& history : histories_) {
    history = History();
  }
  without_stamp_ = Refusals();
}

std::size_t JointStore::recordCount() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return histories_.size();
}

std::optional<JointStore::Record> JointStore::find(const std::string& topic,
                                                   const std::string& joint) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto known = topics_.find(topic);
  if (known == topics_.end()) {
    return std::nullopt;
  }
  const auto place = known->second.places.find(joint);
  return place == known->second.places.end() ? std::nullopt : std::optional(place->second);
}

Refusal JointStore::refusedAhead(Record record) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return histories_[record].refusal;
}

void JointStore::readNewest(const std::vector<Wanted>& wanted,
                            std::vector<NewestSample>& samples) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  samples.clear();
  for (const Wanted& one : wanted) {
    const History& history = histories_[one.record];
    samples.push_back({newestOf(history.samples), history.contradiction});
  }
}

std::uint64_t JointStore::laterCount() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return later_;
}

Refusals JointStore::refusedWithoutStamp() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return without_stamp_;
}

std::uint64_t JointStore::refusedTooLong() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return too_long_;
}

std::string JointStore::publisher(PublisherId id) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return publishers_.nameOf(id);
}

void JointStore::readAt(const std::vector<Wanted>& wanted, std::int64_t stamp_ns,
                        double longest_gap, std::vector<JointSample>& samples) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  samples.clear();
  for (const Wanted& one : wanted) {
    const std::deque<JointSample>& history = histories_[one.record].samples;
    const auto after = std::lower_bound(
        history.begin(), history.end(), stamp_ns,
        [](const JointSample& sample, std::int64_t stamp) { return sample.stamp_ns < stamp; });
    if (after != history.end() && after->stamp_ns == stamp_ns) {
      samples.push_back(*after);
    } else if (after == history.begin() || after == history.end()) {
      samples.emplace_back();
    } else {
      samples.push_back(
          sampleBetween(*std::prev(after), *after, {stamp_ns, longest_gap, one.wraps}));
    }
  }
}

}  // namespace collision_monitor
