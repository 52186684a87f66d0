// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "collision_monitor/geometry/geometry.h"
#include "collision_monitor/geometry/ids.h"
#include "collision_monitor/geometry/pose.h"

namespace collision_monitor {

/// Index into RobotModel::robots.
enum class RobotId : std::uint32_t {};
/// Index into RobotModel::links.
enum class LinkId : std::uint32_t {};
/// Index into RobotModel::joints.
enum class JointId : std::uint32_t {};

/// What a joint of a URDF lets move.
enum class JointType : unsigned char { fixed, revolute, continuous, prismatic, planar, floating };

/// position = multiplier * position of `source` + offset.
struct Mimic {
  JointId source{};        ///< the joint that is followed; no mimic joint itself
  double multiplier{1.0};  ///< change of position by that of the source
  double offset{0.0};      ///< [rad] or [m]
};

/// Number of joint variables: 1 for revolute, continuous and prismatic; 3 for planar (x, y in the
/// joint's plane [m], angle [rad]); 7 for floating (x, y, z [m], unit quaternion x, y, z, w); 0 for
/// fixed. A mimic joint has none of its own.
struct Joint {
  std::string name;                  ///< the robot's prefix, then the URDF's name
  JointType type{JointType::fixed};  ///< how it moves
  LinkId parent{};                   ///< of the same robot
  LinkId child{};                    ///< of the same robot
  Pose parent_from_joint;            ///< `<origin>`
  Eigen::Vector3d axis{
      Eigen::Vector3d::UnitX()};  ///< unit, in the joint frame; normal of a planar joint
  double lower{-std::numeric_limits<double>::infinity()};  ///< [rad] or [m]; infinite if unlimited
  double upper{std::numeric_limits<double>::infinity()};   ///< [rad] or [m]; likewise
  double max_velocity{std::numeric_limits<double>::infinity()};  ///< [rad/s] or [m/s]
  std::optional<Mimic> mimic;     ///< none: the joint moves by itself
  std::size_t first_variable{0};  ///< a mimic joint has that of its source
};

/// One `<collision>` of a link.
struct CollisionElement {
  std::string name;         ///< unique within the link: the URDF's name, or "collision_0", ...
  Pose link_from_geometry;  ///< `<origin>`
  Geometry geometry;        ///< in its own frame; meshes are scaled already
  std::string mesh_name{};  ///< as written in the URDF; empty for other shapes
  Eigen::Vector3d mesh_scale{Eigen::Vector3d::Ones()};  ///< by axis, as written in the URDF
};

/// A link, with all that the URDF says of its geometry.
struct Link {
  std::string name;   ///< as in messages: the robot's prefix, then the URDF's name
  std::string frame;  ///< tf frame
  RobotId robot{};    ///< whose URDF names it
  std::optional<JointId> parent_joint;       ///< none for a root
  std::vector<CollisionElement> collisions;  ///< in the order of the URDF; empty: no geometry
  bool has_given_shapes{false};  ///< a rule gives shapes that replace those of `collisions`
};

/// Whether the link can touch anything: it has geometry, or a rule gives it shapes.
inline bool hasShapes(const Link& link) noexcept {
  return link.has_given_shapes || !link.collisions.empty();
}

/// One robot of the model: where its links and joints stand.
struct Robot {
  std::string name;            ///< as its URDF says
  std::string tf_prefix;       ///< without slashes around it; may be empty
  LinkId root{};               ///< the link without a parent
  std::size_t first_link{0};   ///< index into RobotModel::links
  std::size_t link_count{0};   ///< its links follow each other
  std::size_t first_joint{0};  ///< index into RobotModel::joints
  std::size_t joint_count{0};  ///< its joints follow each other
  bool is_world{false};  ///< its links are objects of the world, or the frame that carries them
};

/// All monitored robots as one forest of links. The links and joints of a robot are contiguous, and
/// every parent comes before its children, so one pass computes all poses. readRobots builds it;
/// buildSetup marks given shapes; nothing changes afterwards.
struct RobotModel {
  std::vector<Robot> robots;      ///< by RobotId
  std::vector<Link> links;        ///< by LinkId
  std::vector<Joint> joints;      ///< by JointId
  std::size_t variable_count{0};  ///< of all joints of all robots: the length of a state

  /// @pre `id` names a link of this model.
  const Link& link(LinkId id) const { return links[index(id)]; }
  /// @pre `id` names a joint of this model.
  const Joint& joint(JointId id) const { return joints[index(id)]; }
  /// Finds a link by its name in messages. Slow (linear): for set-up and services only.
  std::optional<LinkId> findLink(const std::string& name) const;
  /// Finds a joint by the robot's prefix and its name in the URDF.
  std::optional<JointId> findJoint(const std::string& name) const;
};

}  // namespace collision_monitor
