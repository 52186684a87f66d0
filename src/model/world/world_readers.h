// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <yaml-cpp/yaml.h>

#include <optional>
#include <string>
#include <vector>

#include "model/mesh_loading/mesh_store.h"
#include "model/place.h"
#include "model/world/world_text.h"

/// The readers of readWorld, one for each format.
namespace collision_monitor {

/// What all objects of a text share.
struct WorldSource {
  const DocumentText& text;
  MeshStore& meshes;

  /// "cell.yaml line 12"
  std::string at(int line) const {
    return line > 0 ? text.source + " line " + std::to_string(line) : text.source;
  }
};

/// The pose of a position and a quaternion x, y, z, w, which is normalised.
/// @return nothing if the quaternion is not of unit length, up to a hundredth
std::optional<Pose> poseOf(const Eigen::Vector3d& position, const Eigen::Vector4d& quat_xyzw);

/// The mesh of a file; nothing, after an error at the place, if there is none.
SharedMesh loadMesh(const std::string& name, const Eigen::Vector3d& scale, int line,
                    const WorldSource& source, const Place& place);

void readObjectList(const YAML::Node& list, const WorldSource& source, const Place& place,
                    std::vector<WorldObject>& objects);

/// @param document has `world` with `collision_objects`, or `robot_state`
void readPlanningScene(const YAML::Node& document, const WorldSource& source, const Place& place,
                       std::vector<WorldObject>& objects);

void readSceneText(const WorldSource& source, const Place& place,
                   std::vector<WorldObject>& objects);

}  // namespace collision_monitor
