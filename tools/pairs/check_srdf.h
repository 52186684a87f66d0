// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "collision_monitor/model/urdf_reader.h"
#include "collision_monitor/pipeline/search_pairs.h"

namespace collision_monitor::pairs_tool {

/// What is wrong with an SRDF; one sentence for each pair.
struct SrdfCheck {
  std::vector<std::string> touching;  ///< disabled, but they touch in the state that is told
  std::vector<std::string> unclear;   ///< disabled, and what encloses them touches in that state
  std::vector<std::string> needless;  ///< checked, but proven to touch never, or always
};

/// Holds an SRDF against what was found. Pairs that always touch may be disabled: their contact
/// says nothing.
/// @param description of the only robot of the model, with its SRDF
/// @param report gets what readSrdf finds
SrdfCheck checkSrdf(const RobotDescription& description, const RobotModel& model,
                    const std::vector<PairFound>& pairs, SetupReport& report);

/// All of it, each list under its heading.
std::string textOf(const SrdfCheck& check);

}  // namespace collision_monitor::pairs_tool
