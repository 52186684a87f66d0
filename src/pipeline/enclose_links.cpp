// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <stdexcept>
#include <string>

#include "collision_monitor/fitting/posed_shape.h"
#include "collision_monitor/geometry/bounds.h"
#include "setup_parts.h"

namespace collision_monitor {
namespace {

void addBody(LinkId link, const CollisionElement& element, double padding, CycleSetup& setup) {
  const Enclosure enclosure = encloseTightly(element.geometry);
  Body body;
  body.link = link;
  body.link_from_body = element.link_from_geometry * enclosure.geometry_from_body;
  body.shape = padding > 0.0 ? grown(enclosure.shape, padding) : enclosure.shape;
  body.bounding_radius = boundingRadius(body.shape);
  body.is_exact = enclosure.is_exact && padding == 0.0;
  setup.bodies.push_back(body);
  setup.labels.push_back(
      {element.name + "/" + kindName(body.shape), enclosure.overshoot, enclosure.widening});
}

}  // namespace

void encloseLinks(double padding, CycleSetup& setup, SetupReport& report) {
  for (std::size_t i = 0; i < setup.model.links.size(); ++i) {
    const Link& link = setup.model.links[i];
    for (const CollisionElement& element : link.collisions) {
      try {
        addBody(idAt<LinkId>(i), element, padding, setup);
      } catch (const std::invalid_argument& fault) {
        report.errors.push_back({"link '" + link.name + "', collision '" + element.name + "'",
                                 fault.what(), "geometry that a shape can enclose"});
      }
    }
  }
}

}  // namespace collision_monitor
