// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "model/object_links.h"
#include "pipeline/data/cycle_data.h"

/// Velocities of links for a cycle: from the poses of two stamps or, where known, from joint
/// velocities, which are newer and less noisy. Nothing allocates after set-up.
namespace collision_monitor {

struct VelocityOptions {
  double time_constant{0.02};  ///< [s] of the filter of velocities from stamps; 0: none
  double longest_gap{0.5};     ///< [s] > 0; stamps farther apart give no velocity
};

/// The last stamp of each robot, and the velocities from it.
struct VelocityTracker {
  std::vector<std::int64_t> stamp_ns;    ///< by RobotId
  std::vector<Pose> world_from_link;     ///< by LinkId
  std::vector<unsigned char> was_known;  ///< by LinkId
  std::vector<PartId> part;              ///< by LinkId: the part at that stamp
  LinkVelocities filtered;
  std::vector<ObjectRun> objects;  ///< these have the velocities of their carriers
};

VelocityTracker makeVelocityTracker(const RobotModel& model);

/// Forgets all stamps: after a jump in time.
void resetTracker(VelocityTracker& tracker) noexcept;

/// Fills `poses.velocities` from these poses and those of the last stamp. A link's velocity is
/// known after two stamps in a row in the same part, at most the longest gap apart. It stays as it
/// is until a new stamp comes. The top link of a part that floats has velocity zero.
void trackVelocities(const RobotModel& model, const VelocityOptions& options,
                     VelocityTracker& tracker, LinkPoses& poses) noexcept;

/// Velocities of joints by variable, [rad/s] or [m/s], in the sense of jointTwist; NaN: unknown.
using JointVelocities = std::vector<double>;

/// Replaces the velocities of links whose joint and parent link have known velocities. Roots, links
/// of joints without velocities, top links of parts and objects keep theirs.
/// @pre `velocities` has RobotModel::variable_count entries
void applyJointVelocities(const RobotModel& model, const JointVelocities& velocities,
                          LinkPoses& poses) noexcept;

}  // namespace collision_monitor
