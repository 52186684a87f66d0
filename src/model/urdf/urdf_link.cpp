// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <set>

#include "model/urdf/merge_capsules.h"
#include "model/urdf/urdf_elements.h"
#include "model/xml_document.h"

namespace collision_monitor {
namespace {

using tinyxml2::XMLElement;

std::string nameOf(const XMLElement& collision) {
  const char* name = collision.Attribute("name");
  return name == nullptr ? "" : name;
}

/// Makes names unique by a number: messages tell the shapes of a link apart by them.
void nameCollisions(std::vector<CollisionElement>& collisions) {
  std::set<std::string> taken;
  for (std::size_t i = 0; i < collisions.size(); ++i) {
    std::string& name = collisions[i].name;
    const std::string wanted = name.empty() ? "collision_" + std::to_string(i) : name;
    name = wanted;
    for (int number = 2; !taken.insert(name).second; ++number) {
      name = wanted + "_" + std::to_string(number);
    }
  }
}

std::optional<CollisionElement> readCollision(const XMLElement& element, const MeshSource& meshes,
                                              const Place& place) {
  CollisionElement collision;
  collision.name = nameOf(element);
  collision.link_from_geometry = readOrigin(element, place);
  const XMLElement* geometry = element.FirstChildElement("geometry");
  if (geometry == nullptr) {
    place.addError(element.GetLineNum(), "<collision> without <geometry>",
                   "one <geometry> with one shape");
    return std::nullopt;
  }
  if (const XMLElement* second = geometry->NextSiblingElement("geometry")) {
    place.addError(second->GetLineNum(), "<collision> with a second <geometry>",
                   "one <geometry>; further ones in <collision> elements of their own");
  }
  std::optional<Geometry> shape = readGeometry(*geometry, meshes, place);
  if (!shape) {
    return std::nullopt;
  }
  collision.geometry = std::move(*shape);
  if (const XMLElement* mesh = geometry->FirstChildElement("mesh")) {
    collision.mesh_name = readText(*mesh, "filename", place).value_or("");
    collision.mesh_scale = readMeshScale(*mesh, place).value_or(collision.mesh_scale);
  }
  return collision;
}

}  // namespace

std::optional<UrdfLink> readUrdfLink(const XMLElement& element, const MeshSource& meshes,
                                     const Place& place) {
  const auto name = readName(element, "name", place);
  const Place here = place.within("link " + quoted(name.value_or("?")));
  UrdfLink link;
  link.line = element.GetLineNum();
  int number = 0;
  for (const XMLElement* e = element.FirstChildElement("collision"); e != nullptr;
       e = e->NextSiblingElement("collision")) {
    ++number;
    const std::string label = nameOf(*e).empty() ? std::to_string(number) : quoted(nameOf(*e));
    auto collision = readCollision(*e, meshes, here.within("collision " + label));
    if (collision) {
      link.collisions.push_back(std::move(*collision));
    }
  }
  nameCollisions(link.collisions);
  mergeCapsules(link.collisions);
  // A link without visual geometry is just a frame, such as that of a tool or sensor.
  if (number == 0 && element.FirstChildElement("visual") != nullptr) {
    here.note(Oddity::link_without_geometry);
  }
  if (!name) {
    return std::nullopt;
  }
  link.name = *name;
  link.is_absolute_frame = *readText(element, "name", place) != *name;
  return link;
}

}  // namespace collision_monitor
