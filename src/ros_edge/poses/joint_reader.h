// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

#include <optional>
#include <string>
#include <vector>

#include "collision_monitor/model/kinematics.h"
#include "pipeline/look_ahead/link_velocities.h"
#include "ros_edge/poses/joint_store.h"

namespace collision_monitor {

/// Reads what a store has about a model's joints with one variable. A mimic joint follows its
/// source, whatever is published for it. All arrays are by variable.
class JointReader {
 public:
  /// @param topics one per robot; "": no topic
  /// @pre `model` and `store` outlive the reader
  JointReader(const RobotModel& model, const JointStore& store, std::vector<std::string> topics);

  /// Reads the newest samples.
  void refresh();
  /// The newest sample of a variable at the last refresh; no stamp if there is none.
  const NewestSample& newest(std::size_t variable) const { return newest_[variable]; }
  /// As JointStore::publisher.
  std::string publisher(PublisherId id) const { return store_.publisher(id); }

  /// As JointStore::refusedWithoutStamp.
  Refusals refusedWithoutStamp() const { return store_.refusedWithoutStamp(); }
  /// As JointStore::refusedAhead, by variable.
  Refusal refusedAhead(std::size_t variable) const;

  /// Positions at a stamp; NaN if JointStore::readAt has none.
  void readPositions(std::int64_t stamp_ns, double longest_gap, JointPositions& positions);
  /// The newest positions at the last refresh; NaN unless finite and no older than `max_age` [s].
  void readNewestPositions(const ros::Time& now, double max_age, JointPositions& positions) const;
  /// The newest velocities at the last refresh; NaN unless finite and no older than `max_age` [s].
  void readVelocities(const ros::Time& now, double max_age, JointVelocities& velocities) const;

 private:
  void findJoints();
  std::optional<JointStore::Record> find(std::size_t robot, const Joint& joint) const;
  bool hasOtherRobotJoint(std::size_t robot, const std::string& bare_name) const;

  const RobotModel& model_;
  const JointStore& store_;
  std::vector<std::string> topics_;
  std::size_t known_records_{0};
  std::vector<std::size_t> variables_;        ///< of the joints that the store has
  std::vector<JointStore::Wanted> records_;   ///< same order as variables_
  std::vector<NewestSample> newest_samples_;  ///< same order as variables_
  std::vector<JointSample> samples_;          ///< same order as variables_, at a stamp
  std::vector<NewestSample> newest_;          ///< by variable
};

/// The names that joint states may use for a robot's joints: with its prefix or without.
std::vector<std::string> jointNames(const RobotModel& model, RobotId robot);

}  // namespace collision_monitor
