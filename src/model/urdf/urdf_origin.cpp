// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <algorithm>
#include <charconv>
#include <string_view>
#include <utility>

#include "geometry/rpy.h"
#include "model/urdf/urdf_elements.h"
#include "model/xml_document.h"

namespace collision_monitor {
namespace {

using tinyxml2::XMLElement;

/// Major and minor of `<robot version>`; 1.0 if it is missing or no version.
std::pair<int, int> versionOf(const XMLElement& element) {
  const char* text = element.GetDocument()->RootElement()->Attribute("version");
  const std::string_view version = text == nullptr ? "" : text;
  const std::size_t dot = std::min(version.find('.'), version.size());
  std::pair<int, int> read{1, 0};
  const auto [end, fault] = std::from_chars(version.data(), version.data() + dot, read.first);
  if (fault != std::errc() || end != version.data() + dot) {
    return {1, 0};
  }
  std::from_chars(version.data() + std::min(dot + 1, version.size()),
                  version.data() + version.size(), read.second);
  return read;
}

/// The rotation of `quat_xyzw`; identity after an error.
Eigen::Matrix3d readQuaternion(const XMLElement& origin, const Place& place) {
  const char* const kAccepted = "four finite numbers separated by spaces, not all 0: x y z w";
  const char* const text = origin.Attribute("quat_xyzw");
  if (versionOf(origin) < std::pair(1, 1)) {
    // Other readers ignore it there and turn nothing.
    place.addError(origin.GetLineNum(), "origin with quat_xyzw in a URDF of version 1.0",
                   "rpy, or <robot version=\"1.1\"> and later");
    return Eigen::Matrix3d::Identity();
  }
  if (origin.Attribute("rpy") != nullptr) {
    place.addError(origin.GetLineNum(), "origin with both rpy and quat_xyzw", "one of them");
    return Eigen::Matrix3d::Identity();
  }
  const auto numbers = readNumbers<4>(origin, {"quat_xyzw", kAccepted}, place);
  if (!numbers) {
    return Eigen::Matrix3d::Identity();
  }
  const Eigen::Vector4d unit = numbers->stableNormalized();
  if (!(unit.norm() > 0.5)) {
    place.addError(origin.GetLineNum(), "origin quat_xyzw " + quoted(text), kAccepted);
    return Eigen::Matrix3d::Identity();
  }
  return Eigen::Quaterniond(unit).normalized().toRotationMatrix();
}

}  // namespace

Pose readOrigin(const XMLElement& parent, const Place& place) {
  Pose pose;
  const XMLElement* origin = onlyChild(parent, "origin", place);
  if (origin == nullptr) {
    return pose;
  }
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
  pose.translation = readNumbersOr<3>(
      zero, *origin, {"xyz", "three finite numbers separated by spaces, in metres"}, place);
  const Eigen::Vector3d rpy = readNumbersOr<3>(
      zero, *origin, {"rpy", "three finite numbers separated by spaces, in radians"}, place);
  pose.rotation = origin->Attribute("quat_xyzw") == nullptr ? rotationOfRpy(rpy)
                                                            : readQuaternion(*origin, place);
  return pose;
}

}  // namespace collision_monitor
