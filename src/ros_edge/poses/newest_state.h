// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "collision_monitor/model/kinematics.h"
#include "pipeline/data/cycle_data.h"

namespace collision_monitor {

/// Where robots are now, as far as it is known.
struct NewestState {
  LinkPoses poses;
  JointPositions positions;            ///< as joint states tell, by variable; NaN: they do not
  std::vector<std::string> reasons{};  ///< by LinkId: why a part begins there, where one does
};

/// Nothing is known.
NewestState makeNewestState(const RobotModel& model);

/// The position of a joint now: as joint states tell or, where they do not, as the poses of its two
/// links do. A continuous joint has the one from which the way to `target` is shorter, unless a
/// joint follows it that is elsewhere after a whole turn, as a slide on a screw.
///
/// Limits: poses do not tell whole turns. Of a joint that can turn farther than one they say
/// nothing, unless it is such a continuous one.
/// @pre the joint is revolute, continuous or prismatic, and follows no other
std::optional<double> newestPosition(const RobotModel& model, const NewestState& newest,
                                     JointId joint, double target);

}  // namespace collision_monitor
