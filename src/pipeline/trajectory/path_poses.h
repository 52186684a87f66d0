// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "model/kinematics/joint_path.h"
#include "pipeline/data/cycle_data.h"

namespace collision_monitor {

/// Places links along a path: those that it moves by their joints, the others as they stand to
/// their parents at the start.
class PathPoses {
 public:
  /// @pre `start` is sized for the model; all three outlive this.
  PathPoses(const RobotModel& model, const JointPath& path, const LinkPoses& start);

  /// Links that are unknown at the start get poses that mean nothing.
  void place(std::size_t segment, double share, std::vector<Pose>& world_from_link);

 private:
  struct LinkPlace {
    std::size_t parent;
    const Joint* joint;  ///< that the path moves, or nullptr
    Pose parent_from_child;
  };

  const RobotModel& model_;
  const JointPath& path_;
  const LinkPoses& start_;
  JointPositions positions_;
  std::vector<LinkPlace> places_;  ///< by LinkId; a root, or top of a part, is its own parent
};

}  // namespace collision_monitor
