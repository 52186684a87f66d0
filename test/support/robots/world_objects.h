// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "collision_monitor/model/world.h"
#include "support/pose_at.h"

namespace collision_monitor::test {

/// An object of one shape, in the world frame.
inline WorldObject objectOf(const std::string& name, const ObjectGeometry& geometry,
                            const Pose& pose = Pose()) {
  WorldObject object;
  object.name = name;
  object.frame_from_object = pose;
  object.shapes = std::make_shared<const ObjectShapes>(ObjectShapes{{Pose(), geometry}});
  return object;
}

inline WorldObject attached(WorldObject object, const std::string& link,
                            const std::vector<std::string>& touch_links = {}) {
  object.is_attached = true;
  object.frame = link;
  object.touch_links = touch_links;
  return object;
}

/// What an object is called in a change that needs no more.
inline WorldObject named(const std::string& name, const std::string& frame = "") {
  WorldObject object;
  object.name = name;
  object.frame = frame;
  return object;
}

/// The links base, arm, hand and finger, whose frames have the same names, in the world "map".
inline KnownPlaces armPlaces() {
  KnownPlaces places;
  places.links = places.link_frames = {"base", "arm", "hand", "finger"};
  places.world_frame = "map";
  places.has_frame = [](const std::string& frame) { return frame == "camera"; };
  return places;
}

inline std::vector<std::string> textsOf(const std::vector<Problem>& problems) {
  std::vector<std::string> texts;
  for (const Problem& problem : problems) {
    texts.push_back(toString(problem));
  }
  return texts;
}

/// A world of these objects. @pre they have no fault
inline World worldOf(const std::vector<WorldObject>& objects,
                     const KnownPlaces& places = armPlaces()) {
  SetupReport report;
  World world = applyChanges(World(), {{ChangeKind::replace_all, objects, true}}, places, report);
  throwIfErrors(report);
  return world;
}

}  // namespace collision_monitor::test
