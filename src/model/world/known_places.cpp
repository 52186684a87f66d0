// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "collision_monitor/model/world.h"

namespace collision_monitor {

bool KnownPlaces::mayCome(const std::string& link) const {
  const auto prefixOf = [](const std::string& name) { return name.substr(0, name.rfind('/') + 1); };
  const std::string prefix = prefixOf(link);
  return awaits_links &&
         (prefix.empty() || std::none_of(links.begin(), links.end(), [&](const std::string& known) {
            return prefixOf(known) == prefix;
          }));
}

KnownPlaces placesOf(const RobotModel& robots, const std::string& world_frame) {
  KnownPlaces places;
  for (const Link& link : robots.links) {
    places.links.push_back(link.name);
    places.link_frames.push_back(link.frame);
  }
  places.world_frame = world_frame;
  return places;
}

}  // namespace collision_monitor
