// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstring>

#include "model/urdf/urdf_elements.h"
#include "model/xml_document.h"

namespace collision_monitor {

UrdfRobot readUrdfRobot(const tinyxml2::XMLElement& robot, const MeshSource& meshes,
                        const Place& place) {
  UrdfRobot read;
  // A robot without a name is odd but harmless: nothing uses the name for look-up.
  const char* name = robot.Attribute("name");
  read.name = name == nullptr ? "" : name;
  for (const tinyxml2::XMLElement* e = robot.FirstChildElement(); e != nullptr;
       e = e->NextSiblingElement()) {
    if (std::strcmp(e->Name(), "link") == 0) {
      if (auto link = readUrdfLink(*e, meshes, place)) {
        read.links.push_back(std::move(*link));
      }
    } else if (std::strcmp(e->Name(), "joint") == 0) {
      if (auto joint = readUrdfJoint(*e, place)) {
        read.joints.push_back(std::move(*joint));
      }
    }
  }
  return read;
}

}  // namespace collision_monitor
