// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/model/srdf_reader.h"
#include "model/xml_document.h"

namespace collision_monitor {

/// The groups of an SRDF below `root`; readSrdf says what they hold. Unknown names are one warning.
std::vector<LinkGroup> readGroups(const tinyxml2::XMLElement& root, RobotId robot,
                                  const RobotModel& model, const Place& place);

}  // namespace collision_monitor
