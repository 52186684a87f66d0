// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "model/urdf/urdf_elements.h"

namespace collision_monitor {

/// The links of a robot from the root outwards: every parent before its
/// children, children in the order of their joints in the URDF.
struct LinkTree {
  std::vector<std::size_t> links;  ///< indices into UrdfRobot::links, the root first
  std::vector<std::size_t>
      joints;  ///< indices into UrdfRobot::joints: joints[i] moves links[i + 1]
  std::vector<std::size_t> parents;  ///< positions in `links`: of links[i + 1]
};

/// Adds an error for every name used twice, joint to an unknown link, link with
/// two parents, for several roots and none, and for loops. Nothing is returned then.
std::optional<LinkTree> sortLinks(const UrdfRobot& robot, const Place& place);

/// The joint that each joint of the robot follows, mimic of mimic resolved to
/// the joint that has the variable. By joint, as in UrdfRobot::joints.
struct ResolvedMimic {
  std::size_t source{0};  ///< index into UrdfRobot::joints
  double multiplier{1.0};
  double offset{0.0};
};

/// Adds an error for unknown joints, joints with several variables, and for
/// loops; mimic of a joint that cannot move is an oddity and dropped.
std::vector<std::optional<ResolvedMimic>> resolveMimics(const UrdfRobot& robot, const Place& place);

}  // namespace collision_monitor
