// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "pipeline/data/cycle_data.h"

/// Velocities of links for a cycle: from the poses of two stamps, and where joints say how fast
/// they move, from these, which are newer and have less noise. Nothing here allocates after
/// set-up.
namespace collision_monitor {

struct VelocityOptions {
  double time_constant{0.02};  ///< [s] of the filter of what two stamps tell; 0: none
  double longest_gap{0.5};     ///< [s] > 0; stamps farther apart tell nothing
};

/// The last stamp of each robot and what it told.
struct VelocityTracker {
  std::vector<std::int64_t> stamp_ns;    ///< by RobotId
  std::vector<Pose> world_from_link;     ///< by LinkId
  std::vector<unsigned char> was_known;  ///< by LinkId
  std::vector<PartId> part;              ///< by LinkId: that it was known in
  LinkVelocities filtered;
};

VelocityTracker makeVelocityTracker(const RobotModel& model);

/// Forgets all stamps: after a jump in time.
void resetTracker(VelocityTracker& tracker) noexcept;

/// Fills `poses.velocities` from these poses and those of the stamp before. A link's velocity is
/// unknown until it was known at two stamps in a row, in the same part and no farther apart than
/// the longest gap, and stays as it is while no new stamp comes. The top link of a part that floats
/// rests.
void trackVelocities(const RobotModel& model, const VelocityOptions& options,
                     VelocityTracker& tracker, LinkPoses& poses) noexcept;

/// Velocities of joints by variable, [rad/s] or [m/s], as jointTwist counts them; NaN: not known.
using JointVelocities = std::vector<double>;

/// Replaces the velocities of links whose joint and parent link move at known velocities; roots,
/// links behind joints that say nothing, and those where a part begins keep what they have.
/// @pre `velocities` has RobotModel::variable_count entries
void applyJointVelocities(const RobotModel& model, const JointVelocities& velocities,
                          LinkPoses& poses) noexcept;

}  // namespace collision_monitor
