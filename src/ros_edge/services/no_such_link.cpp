// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/services/no_such_link.h"

#include <vector>

#include "model/nearest_name.h"
#include "model/place.h"

namespace collision_monitor {

std::string noSuchLink(const RobotModel& model, const std::string& field, const std::string& name) {
  std::vector<std::string> accepted;
  for (const Link& link : model.links) {
    if (hasShapes(link)) {
      accepted.push_back(link.name);
    }
  }
  const std::string similar = suggestion(name, accepted);
  return field + ": there is no link " + quoted(name) +
         (similar.empty() && !accepted.empty() ? "; accepted: " + someOf(accepted) : similar);
}

}  // namespace collision_monitor
