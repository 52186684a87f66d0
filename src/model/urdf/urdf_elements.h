// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tinyxml2.h>

#include <optional>
#include <string>
#include <vector>

#include "collision_monitor/model/robot_model.h"
#include "model/mesh_loading/mesh_store.h"
#include "model/place.h"

/// The elements of one URDF as written, with names not yet resolved.
namespace collision_monitor {

struct UrdfLink {
  std::string name;               ///< without leading slash
  bool is_absolute_frame{false};  ///< the name began with a slash
  int line{0};
  std::vector<CollisionElement> collisions;
};

struct UrdfMimic {
  std::string source;
  double multiplier{1.0};
  double offset{0.0};
};

struct UrdfJoint {
  std::string parent;
  std::string child;
  std::optional<UrdfMimic> mimic;
  int line{0};
  Joint joint;  ///< everything that depends on no other element; name without prefix
};

struct UrdfRobot {
  std::string name;
  std::vector<UrdfLink> links;
  std::vector<UrdfJoint> joints;
};

/// What the geometry of a robot needs beside its XML.
struct MeshSource {
  MeshStore& store;
  const RobotDescription& description;  ///< gives the folder and the up axis rule
};

/// Readers add an error for every fault and return what they can, so that further faults are found.
UrdfRobot readUrdfRobot(const tinyxml2::XMLElement& robot, const MeshSource& meshes,
                        const Place& place);
std::optional<UrdfLink> readUrdfLink(const tinyxml2::XMLElement& link, const MeshSource& meshes,
                                     const Place& place);
std::optional<UrdfJoint> readUrdfJoint(const tinyxml2::XMLElement& joint, const Place& place);

/// The one shape of a `<geometry>`: box, sphere, cylinder, capsule or mesh.
///
/// A capsule's length is the distance between the centers of its caps, as in Bullet, so its total
/// length is 2 radius + length.
/// Source: Bullet's URDF importer passes radius and length to btCapsuleShapeZ, whose height
/// excludes the caps.
std::optional<Geometry> readGeometry(const tinyxml2::XMLElement& geometry, const MeshSource& meshes,
                                     const Place& place);

/// The scale of a `<mesh>`: 1 by default, nothing after an error.
std::optional<Eigen::Vector3d> readMeshScale(const tinyxml2::XMLElement& mesh, const Place& place);

/// The `<origin>` of an element: identity by default.
/// Rotation: fixed axes, R = Rz(yaw) Ry(pitch) Rx(roll); from version 1.1 on also a quaternion,
/// which is normalised.
Pose readOrigin(const tinyxml2::XMLElement& parent, const Place& place);

}  // namespace collision_monitor
