// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <urdf_model/model.h>

#include <string>
#include <vector>

#include "collision_monitor/model/problems.h"
#include "collision_monitor/model/robot_model.h"

namespace collision_monitor {

/// Collects the differences between two readings of one robot.
class Differences {
 public:
  Differences(std::string source, std::vector<Problem>& problems);
  Differences(const Differences&) = delete;
  Differences& operator=(const Differences&) = delete;

  /// Reports the first few and counts the others.
  /// @param element "link 'arm'"
  void add(const std::string& element, const std::string& ours, const std::string& theirs);
  void tellHowManyMore();

 private:
  static constexpr std::size_t kShown = 12;

  std::string source_;
  std::vector<Problem>& problems_;
  std::size_t count_{0};
};

/// Adds what urdfdom reads differently from us; askSecondReader says what is compared.
void compareReadings(const std::string& source, const RobotModel& model, RobotId robot,
                     const urdf::ModelInterface& theirs, std::vector<Problem>& problems);

/// Compares the shapes of one link.
/// @param element name of the link in messages
void compareShapes(const std::string& element, const std::vector<CollisionElement>& ours,
                   const std::vector<urdf::CollisionSharedPtr>& theirs, Differences& differences);

std::string plainText(const std::string& text);  ///< without blanks around it

/// A name as our reader takes it: without surrounding blanks and leading slashes.
std::string plainName(const std::string& name);

bool areSame(double ours, double theirs);
bool areSame(const Pose& ours, const urdf::Pose& theirs);

std::string numberText(double number);
std::string vectorText(const Eigen::Vector3d& vector);
std::string poseText(const Pose& pose);
Pose poseOf(const urdf::Pose& pose);
Eigen::Vector3d vectorOf(const urdf::Vector3& vector);

}  // namespace collision_monitor
