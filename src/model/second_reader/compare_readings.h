// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <urdf_model/model.h>

#include <string>
#include <vector>

#include "collision_monitor/model/problems.h"
#include "collision_monitor/model/robot_model.h"

namespace collision_monitor {

/// Where two readings of one robot differ.
class Differences {
 public:
  Differences(std::string source, std::vector<Problem>& problems);
  Differences(const Differences&) = delete;
  Differences& operator=(const Differences&) = delete;

  /// The first few are told, the others counted.
  /// @param element "link 'arm'"
  void add(const std::string& element, const std::string& ours, const std::string& theirs);
  void tellHowManyMore();

 private:
  static constexpr std::size_t kShown = 12;

  std::string source_;
  std::vector<Problem>& problems_;
  std::size_t count_{0};
};

/// Adds what urdfdom reads otherwise than we do; askSecondReader says what.
void compareReadings(const std::string& source, const RobotModel& model, RobotId robot,
                     const urdf::ModelInterface& theirs, std::vector<Problem>& problems);

/// The shapes of one link.
/// @param element what messages call the link
void compareShapes(const std::string& element, const std::vector<CollisionElement>& ours,
                   const std::vector<urdf::CollisionSharedPtr>& theirs, Differences& differences);

std::string plainText(const std::string& text);  ///< without blanks around it

/// A name as we read it: without blanks around it and slashes before it.
std::string plainName(const std::string& name);

bool areSame(double ours, double theirs);
bool areSame(const Pose& ours, const urdf::Pose& theirs);

std::string numberText(double number);
std::string vectorText(const Eigen::Vector3d& vector);
std::string poseText(const Pose& pose);
Pose poseOf(const urdf::Pose& pose);
Eigen::Vector3d vectorOf(const urdf::Vector3& vector);

}  // namespace collision_monitor
