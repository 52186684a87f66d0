// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "collision_monitor/model/kinematics.h"
#include "pipeline/data/cycle_data.h"

namespace collision_monitor {

/// The newest known poses and positions of the robots.
struct NewestState {
  LinkPoses poses;
  JointPositions positions;            ///< from joint states, by variable; NaN: not given
  std::vector<std::string> reasons{};  ///< by LinkId: why a part begins at this link, if one does
};

/// A state in which nothing is known.
NewestState makeNewestState(const RobotModel& model);

/// The position of a joint now: from joint states or, if they lack it, from the poses of its two
/// links. For a continuous joint, it is the position nearest to `target`, unless a joint that
/// mimics it is elsewhere after a whole turn, such as a slide on a screw.
///
/// Limits: poses do not show whole turns. If a joint can turn farther than one turn, they give no
/// position, unless it is such a continuous joint.
/// @pre the joint is revolute, continuous or prismatic, and no mimic joint
std::optional<double> newestPosition(const RobotModel& model, const NewestState& newest,
                                     JointId joint, double target);

}  // namespace collision_monitor
