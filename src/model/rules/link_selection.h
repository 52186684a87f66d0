// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "collision_monitor/model/srdf_reader.h"
#include "model/place.h"

namespace collision_monitor {

/// Whether the whole name matches a pattern: * stands for any characters or none, ? for one.
bool matches(const std::string& pattern, const std::string& name);

/// The link's name without its robot's prefix.
std::string urdfNameOf(const RobotModel& model, LinkId link);

/// Links whose name in messages or in the URDF matches.
std::vector<LinkId> findMatching(const std::string& pattern, const RobotModel& model);

/// Links of every group with this name, with or without the robot's prefix; nothing if there is no
/// such group. Groups of other sources than SRDFs join here and in groupNames.
std::optional<std::vector<LinkId>> findGroup(const std::string& name, const RobotModel& model,
                                             const std::vector<SrdfPairs>& srdfs);

/// "'arm' and 'hand'", for messages; only a few if there are many.
std::string groupNames(const std::vector<SrdfPairs>& srdfs);
std::string linkNames(const RobotModel& model);

}  // namespace collision_monitor
