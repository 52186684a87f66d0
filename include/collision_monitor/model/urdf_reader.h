// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "collision_monitor/model/problems.h"
#include "collision_monitor/model/robot_model.h"

namespace collision_monitor {

/// One robot as the user hands it over.
struct RobotDescription {
  std::string source;  ///< what messages call it: a file name or "parameter /robot_description"
  std::string urdf_xml;
  std::string srdf_xml;   ///< empty if there is none
  std::string tf_prefix;  ///< "" or "left": tf frames and link names become "left/NAME"
  std::string directory;  ///< for relative mesh names: the URDF's folder, "" if unknown
};

/// Returns the bytes behind a URI (package://, file://, a plain path).
/// @throws std::runtime_error with a sentence when it cannot.
using ResourceLoader = std::function<std::string(const std::string& uri)>;

/// Reads all robots into one model: every `<collision>` of every link (box,
/// sphere, cylinder, capsule, mesh with scale), all joint types, mimic. A link
/// whose geometry is a cylinder with two spheres of its radius on its ends gets
/// one capsule instead.
///
/// Adds every fault found, in all robots, to `report`; links without geometry
/// and oddities that do no harm are warnings, one per kind and robot. The model is usable only if
/// no error was added.
RobotModel readRobots(const std::vector<RobotDescription>& descriptions,
                      const ResourceLoader& load_resource, SetupReport& report);

}  // namespace collision_monitor
