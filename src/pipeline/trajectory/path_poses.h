// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "model/kinematics/joint_path.h"
#include "pipeline/data/cycle_data.h"

namespace collision_monitor {

/// Places links along a path: by joint values where the path moves a joint, else fixed to the
/// parent link as at the start.
class PathPoses {
 public:
  /// @pre `start` is sized for the model; all arguments outlive this object.
  PathPoses(const RobotModel& model, const JointPath& path, const LinkPoses& start);

  /// Places the links. Links that are unknown at the start get meaningless poses.
  void place(std::size_t segment, double share, std::vector<Pose>& world_from_link);

  /// Marks two links and those that carry them.
  void mark(LinkId a, LinkId b, std::vector<unsigned char>& is_wanted) const noexcept;
  /// Places marked links; leaves others alone. @return how many.
  std::size_t place(std::size_t segment, double share, const std::vector<unsigned char>& is_wanted,
                    std::vector<Pose>& world_from_link);

 private:
  void placeLink(std::size_t link, std::vector<Pose>& world_from_link) const noexcept;

  struct LinkPlace {
    std::size_t parent;
    const Joint* joint;  ///< the joint, if the path moves it; else nullptr
    Pose parent_from_child;
  };

  const RobotModel& model_;
  const JointPath& path_;
  const LinkPoses& start_;
  JointPositions positions_;
  std::vector<LinkPlace> places_;  ///< by LinkId; roots and top links are their own parents
};

}  // namespace collision_monitor
