// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/world/held_back.h"

#include <algorithm>
#include <memory>
#include <string>

namespace collision_monitor {

World worldBefore(const std::vector<ObjectChange>& changes, const MonitorSetup& current,
                  std::vector<WorldObject>& held_back) {
  World world = current.world;
  held_back = current.held_back;
  for (const ObjectChange& change : changes) {
    if (change.kind == ChangeKind::clear || change.kind == ChangeKind::replace_all) {
      held_back.clear();
    }
    for (const WorldObject& object : change.objects) {
      const auto held =
          std::find_if(held_back.begin(), held_back.end(),
                       [&](const WorldObject& one) { return one.name == object.name; });
      if (change.kind == ChangeKind::remove && held != held_back.end()) {
        world.objects.emplace(object.name, std::make_shared<const WorldObject>(*held));
        held_back.erase(held);
      }
    }
  }
  return world;
}

}  // namespace collision_monitor
