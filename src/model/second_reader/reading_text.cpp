// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "model/second_reader/compare_readings.h"

namespace collision_monitor {

void Differences::add(const std::string& element, const std::string& ours,
                      const std::string& theirs) {
  if (++count_ <= kShown) {
    problems_.push_back({source_ + ", " + element,
                         ours + " as it is read here, " + theirs + " as urdfdom reads it", "",
                         "write it so that both read it alike"});
  }
}

void Differences::tellHowManyMore() {
  if (count_ > kShown) {
    problems_.push_back(
        {source_, std::to_string(count_ - kShown) + " more that urdfdom reads otherwise", "", ""});
  }
}

std::string plainText(const std::string& text) {
  const char* const blanks = " \t\r\n";
  const std::size_t begin = text.find_first_not_of(blanks);
  return begin == std::string::npos ? ""
                                    : text.substr(begin, text.find_last_not_of(blanks) + 1 - begin);
}

std::string plainName(const std::string& name) {
  const std::string plain = plainText(name);
  return plain.substr(std::min(plain.find_first_not_of('/'), plain.size()));
}

bool areSame(double ours, double theirs) {
  constexpr double kTolerance = 1e-9;
  return ours == theirs ||
         std::abs(ours - theirs) <= kTolerance * std::max(1.0, std::abs(theirs)) ||
         (std::isnan(ours) && std::isnan(theirs));
}

Eigen::Vector3d vectorOf(const urdf::Vector3& vector) { return {vector.x, vector.y, vector.z}; }

Pose poseOf(const urdf::Pose& pose) {
  return {Eigen::Quaterniond(pose.rotation.w, pose.rotation.x, pose.rotation.y, pose.rotation.z)
              .toRotationMatrix(),
          vectorOf(pose.position)};
}

bool areSame(const Pose& ours, const urdf::Pose& theirs) {
  constexpr double kTolerance = 1e-6;  // an angle may be some thousand turns
  const Pose other = poseOf(theirs);
  // Written so that NaN counts as a difference.
  return (ours.rotation - other.rotation).cwiseAbs().maxCoeff() <= kTolerance &&
         areSame(ours.translation.x(), other.translation.x()) &&
         areSame(ours.translation.y(), other.translation.y()) &&
         areSame(ours.translation.z(), other.translation.z());
}

std::string numberText(double number) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.10g", number + 0.0);  // no -0
  return text.data();
}

std::string vectorText(const Eigen::Vector3d& vector) {
  return numberText(vector.x()) + " " + numberText(vector.y()) + " " + numberText(vector.z());
}

std::string poseText(const Pose& pose) {
  // Roll, pitch and yaw as in a URDF.
  const Eigen::Matrix3d& r = pose.rotation;
  const double pitch = std::atan2(-r(2, 0), std::hypot(r(0, 0), r(1, 0)));
  const Eigen::Vector3d rpy(std::atan2(r(2, 1), r(2, 2)), pitch, std::atan2(r(1, 0), r(0, 0)));
  return "xyz " + vectorText(pose.translation) + " rpy " + vectorText(rpy);
}

}  // namespace collision_monitor
