// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "collision_monitor/model/robot_model.h"
#include "collision_monitor/model/urdf_reader.h"

namespace collision_monitor {

/// What an SRDF says about pairs, with names resolved to links of the model.
struct SrdfPairs {
  struct Entry {
    LinkId a{};
    LinkId b{};
    std::string reason;  ///< the attribute as written, may be empty
  };
  RobotId robot{};
  std::vector<Entry> disabled;              ///< `<disable_collisions>`
  std::vector<Entry> enabled;               ///< `<enable_collisions>`
  std::vector<LinkId> disabled_by_default;  ///< `<disable_default_collisions>`
};

/// Reads the SRDF of one robot of the model. Unknown links are warnings; XML that
/// cannot be read, an SRDF of another robot's links only, is an error.
SrdfPairs readSrdf(const RobotDescription& description, RobotId robot, const RobotModel& model,
                   SetupReport& report);

}  // namespace collision_monitor
