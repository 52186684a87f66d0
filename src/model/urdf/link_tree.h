// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "model/urdf/urdf_elements.h"

namespace collision_monitor {

/// The links of a robot from the root outwards: every parent before its children, and children in
/// the order of their joints in the URDF.
struct LinkTree {
  std::vector<std::size_t> links;    ///< indices into UrdfRobot::links, the root first
  std::vector<std::size_t> joints;   ///< into UrdfRobot::joints: joints[i] moves links[i + 1]
  std::vector<std::size_t> parents;  ///< into `links`: parents[i] is the parent of links[i + 1]
};

/// Adds an error for every name used twice, every joint to an unknown link, every link with two
/// parents, several roots, no root, and loops. Then returns nothing.
std::optional<LinkTree> sortLinks(const UrdfRobot& robot, const Place& place);

/// The joint that a joint follows at the end of its chain of mimic joints. It has the variable.
struct ResolvedMimic {
  std::size_t source{0};  ///< index into UrdfRobot::joints
  double multiplier{1.0};
  double offset{0.0};
};

/// For each joint of UrdfRobot::joints, what it follows. Adds errors for joints with several
/// variables and for loops. Drops a mimic of an unknown joint or of one that cannot move, and notes
/// an oddity.
std::vector<std::optional<ResolvedMimic>> resolveMimics(const UrdfRobot& robot, const Place& place);

}  // namespace collision_monitor
