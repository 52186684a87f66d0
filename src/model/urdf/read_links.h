// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/model/urdf_reader.h"

namespace collision_monitor {

/// As readRobots, but after an error it returns what could be read, for further checks of names. If
/// the links of a robot are not known, the report awaits names.
RobotModel readLinks(const std::vector<RobotDescription>& descriptions,
                     const ResourceLoader& load_resource, SetupReport& report,
                     const MeshReading& reading);

}  // namespace collision_monitor
