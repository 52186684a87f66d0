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

/// Makes the tree of a mesh that is no closed surface. Turning triangles and dropping copies may
/// close it; otherwise winding numbers tell what is inside.
MeshTree treeOfOpen(const TriangleMesh& mesh);

/// Collects one warning for all meshes whose openness is at least kTooOpen.
class OpenMeshes {
 public:
  /// @param openness from opennessOf
  void look(const std::string& link, const std::string& collision, double openness);
  /// The warning; nothing if there is no such mesh.
  std::optional<Problem> warning() const;

 private:
  std::string names_;
};

/// The warning for all meshes of a model.
std::optional<Problem> warnOfOpenMeshes(const RobotModel& model);

}  // namespace collision_monitor
