// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/model/world.h"

namespace collision_monitor {

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
