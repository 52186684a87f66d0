// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "collision_monitor/model/mesh_reading.h"
#include "collision_monitor/model/problems.h"
#include "collision_monitor/model/robot_model.h"

namespace collision_monitor {

/// One robot as the user gives it.
struct RobotDescription {
  std::string source;       ///< its name in messages: a file name or "parameter /robot_description"
  std::string urdf_xml;     ///< the whole text
  std::string srdf_xml;     ///< empty if there is none
  std::string srdf_source;  ///< its name in messages; empty: "SOURCE (SRDF)"
  /// "" or "left": tf frames and link names become "left/NAME". Slashes around it are dropped;
  /// names that have it already do not get it again.
  std::string tf_prefix;
  std::string directory;  ///< base of relative mesh names: the URDF's folder, "" if unknown
  /// Turn meshes that declare an up axis other than z. docs/decisions/mesh-up-axis.md says why this
  /// is not the default.
  bool obeys_up_axis{false};
  bool is_strict{false};  ///< names in the SRDF that are not in the URDF are errors
};

/// Returns the bytes behind a URI (package://, file://, a plain path).
/// @throws std::runtime_error with a sentence if it cannot.
using ResourceLoader = std::function<std::string(const std::string& uri)>;

/// Reads all robots into one model: every `<collision>` of every link (box,
/// sphere, cylinder, capsule, mesh with scale), all joint types, mimic.
///
/// Shapes: of a `<capsule radius length>`, `length` is the distance between the centers of its
/// caps, as in Bullet and since URDF 1.1. It is read in any version. A cylinder with spheres of its
/// radius on both ends, all in one link, becomes one capsule. Meshes are scaled, also by negative
/// and non-uniform scales.
/// Frames: `rpy` turns about fixed axes, R = Rz(yaw) Ry(pitch) Rx(roll). From `<robot
/// version="1.1">` on, `quat_xyzw` may stand in its place; it is normalised.
/// Names: leading slashes are dropped. A link written "/base" keeps the tf frame "base" without
/// prefix, as robot_state_publisher publishes it; its name in messages has the prefix.
/// Joints: axes are normalised; the default axis is x, as in URDF. Missing limits mean no limits. A
/// mimic joint follows the joint at the end of its chain.
/// Ignored: elements and attributes outside URDF's geometry and kinematics.
///
/// Adds every fault of all robots to `report`, each with its line. Links without geometry and
/// harmless oddities are warnings, one per kind and robot.
/// @param reading how meshes are read: by default, by a program of this package
/// @return an empty model if an error was added, so that nobody monitors part of a model
/// unknowingly
/// @throws Interrupted
RobotModel readRobots(const std::vector<RobotDescription>& descriptions,
                      const ResourceLoader& load_resource, SetupReport& report,
                      const MeshReading& reading = {});

}  // namespace collision_monitor
