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

/// One robot as the user hands it over.
struct RobotDescription {
  std::string source;  ///< what messages call it: a file name or "parameter /robot_description"
  std::string urdf_xml;
  std::string srdf_xml;     ///< empty if there is none
  std::string srdf_source;  ///< what messages call it; empty: "SOURCE (SRDF)"
  std::string tf_prefix;    ///< "" or "left": tf frames and link names become "left/NAME";
                            ///< slashes around it do not count, and no name gets it twice
  std::string directory;    ///< for relative mesh names: the URDF's folder, "" if unknown
  /// Turn meshes that declare another up axis than z; docs/decisions/mesh-up-axis.md says why
  /// this is not the rule.
  bool obeys_up_axis{false};
  bool is_strict{false};  ///< names in the SRDF that the URDF lacks are errors
};

/// Returns the bytes behind a URI (package://, file://, a plain path).
/// @throws std::runtime_error with a sentence when it cannot.
using ResourceLoader = std::function<std::string(const std::string& uri)>;

/// Reads all robots into one model: every `<collision>` of every link (box,
/// sphere, cylinder, capsule, mesh with scale), all joint types, mimic.
///
/// Shapes: a `<capsule radius length>` is read as Bullet does, `length` being the
/// distance between the centers of its caps; it is not part of the URDF specification.
/// A cylinder with spheres of its radius on both ends, all in one link, becomes one
/// capsule. Meshes are scaled, also by negative and non-uniform scales.
/// Frames: `rpy` turns about fixed axes, R = Rz(yaw) Ry(pitch) Rx(roll).
/// Names: leading slashes are dropped. A link written "/base" keeps the tf frame "base" without
/// prefix, as robot_state_publisher publishes it; its name in messages has the prefix.
/// Joints: axes are normalised; a missing one is x, as URDF has it. Missing limits are no
/// limits. A mimic joint follows the joint at the end of its chain.
/// Ignored: elements and attributes that are none of URDF's geometry and kinematics.
///
/// Adds every fault found, in all robots, to `report`, each with its line; links without geometry
/// and oddities that do no harm are warnings, one per kind and robot.
/// @param reading how meshes are read: by a program of this package, unless it says otherwise
/// @return an empty model if an error was added: half a model would be checked without a word.
/// @throws Interrupted
RobotModel readRobots(const std::vector<RobotDescription>& descriptions,
                      const ResourceLoader& load_resource, SetupReport& report,
                      const MeshReading& reading = {});

}  // namespace collision_monitor
