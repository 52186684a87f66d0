// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "collision_monitor/geometry/mesh_tree.h"
#include "collision_monitor/model/problems.h"
#include "collision_monitor/model/robot_model.h"

namespace collision_monitor {

/// A mesh that is no closed surface. Turning triangles and leaving out copies may make it one; else
/// winding numbers tell what is inside.
MeshTree treeOfOpen(const TriangleMesh& mesh);

/// Warns of meshes from kTooOpen on, in one line.
class OpenMeshes {
 public:
  /// @param openness as opennessOf measures it
  void look(const std::string& link, const std::string& collision, double openness);
  /// Nothing where there is none.
  std::optional<Problem> warning() const;

 private:
  std::string names_;
};

/// The same for all of a robot.
std::optional<Problem> warnOfOpenMeshes(const RobotModel& model);

}  // namespace collision_monitor
