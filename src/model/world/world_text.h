// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "collision_monitor/model/document_text.h"
#include "collision_monitor/model/urdf_reader.h"
#include "collision_monitor/model/world.h"

namespace collision_monitor {

/// Reads objects from one of three formats:
///
/// - A list of objects in YAML, alone or under `world`. An object has a `name`; `frame` (default:
///   the world frame) or `attach` (a link) with `touch_links`; `xyz` and `rpy` or `quat_xyzw`;
///   `padding`, `group`, `colour`. It has one shape, whose fields stand beside these, or a list
///   `shapes`, each with its own `xyz` and `rpy`. A shape has a `kind` and its dimensions: sphere
///   (radius), capsule (radius, length between the centers of its caps), box (size), cylinder
///   (radius, length), cone (radius, length), mesh (file, scale), plane (normal, offset; the half
///   space below).
/// - A planning scene of MoveIt in YAML: `world` with `collision_objects`, and `robot_state` with
///   `attached_collision_objects`.
/// - A scene of MoveIt as text, if the name of the source ends in ".scene" or the second line
/// begins
///   with "* ", in the older format (shapes alone) or the newer one (with a pose of the object and
///   subframes, which are skipped).
///
/// Names, sizes, frames and links are checked by applyChanges. Faults of the text are added with
/// their line, all at once.
/// @return what could be read
/// @throws Interrupted
std::vector<WorldObject> readWorld(const DocumentText& text, const ResourceLoader& load_resource,
                                   const MeshReading& reading, SetupReport& report);

}  // namespace collision_monitor
