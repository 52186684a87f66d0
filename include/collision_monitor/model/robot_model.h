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

enum class RobotId : std::uint32_t {};
enum class LinkId : std::uint32_t {};
enum class JointId : std::uint32_t {};

enum class JointType : unsigned char { fixed, revolute, continuous, prismatic, planar, floating };

/// position = multiplier * position of `source` + offset.
struct Mimic {
  JointId source{};
  double multiplier{1.0};
  double offset{0.0};
};

/// Number of joint variables: 1 for revolute, continuous and prismatic; 3 for planar (x, y in the
/// joint's plane [m], angle [rad]); 7 for floating (x, y, z [m], unit quaternion x, y, z, w); 0 for
/// fixed. A mimic joint has none of its own.
struct Joint {
  std::string name;
  JointType type{JointType::fixed};
  LinkId parent{};
  LinkId child{};
  Pose parent_from_joint;  ///< `<origin>`
  Eigen::Vector3d axis{
      Eigen::Vector3d::UnitX()};  ///< unit, in the joint frame; normal of a planar joint
  double lower{-std::numeric_limits<double>::infinity()};  ///< [rad] or [m]; infinite if unlimited
  double upper{std::numeric_limits<double>::infinity()};
  double max_velocity{std::numeric_limits<double>::infinity()};  ///< [rad/s] or [m/s]
  std::optional<Mimic> mimic;
  std::size_t first_variable{0};  ///< a mimic joint has that of its source
};

struct CollisionElement {
  std::string name;  ///< unique within the link: the URDF's name, or "collision_0", ...
  Pose link_from_geometry;
  Geometry geometry;
  std::string mesh_name{};  ///< as written in the URDF; empty for other shapes
  Eigen::Vector3d mesh_scale{Eigen::Vector3d::Ones()};
};

struct Link {
  std::string name;   ///< as in messages: the robot's prefix, then the URDF's name
  std::string frame;  ///< tf frame
  RobotId robot{};
  std::optional<JointId> parent_joint;  ///< none for a root
  std::vector<CollisionElement> collisions;
  bool has_given_shapes{false};  ///< a rule gives shapes that replace those of `collisions`
};

/// Whether the link can touch anything: it has geometry, or a rule gives it shapes.
inline bool hasShapes(const Link& link) noexcept {
  return link.has_given_shapes || !link.collisions.empty();
}

struct Robot {
  std::string name;
  std::string tf_prefix;
  LinkId root{};
  std::size_t first_link{0}, link_count{0};
  std::size_t first_joint{0}, joint_count{0};
  bool is_world{false};  ///< its links are objects of the world, or the frame that carries them
};

/// All monitored robots as one forest of links. The links and joints of a robot are contiguous, and
/// every parent comes before its children, so one pass computes all poses. readRobots builds it;
/// buildSetup marks given shapes; nothing changes afterwards.
struct RobotModel {
  std::vector<Robot> robots;
  std::vector<Link> links;
  std::vector<Joint> joints;
  std::size_t variable_count{0};

  const Link& link(LinkId id) const { return links[index(id)]; }
  const Joint& joint(JointId id) const { return joints[index(id)]; }
  /// Finds a link by its name in messages. Slow (linear): for set-up and services only.
  std::optional<LinkId> findLink(const std::string& name) const;
  /// Finds a joint by the robot's prefix and its name in the URDF.
  std::optional<JointId> findJoint(const std::string& name) const;
};

}  // namespace collision_monitor
