// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <string>

#include "collision_monitor/fitting/posed_shape.h"
#include "collision_monitor/geometry/bounds.h"
#include "setup_parts.h"

namespace collision_monitor {
namespace {

/// The shapes of one geometry, and its name in the link.
struct NamedShapes {
  std::string name;
  Pose link_from_geometry;
  const std::vector<Enclosure>& shapes;
};

void addBodies(const LinkFit& fit, const NamedShapes& named, CycleSetup& setup) {
  for (std::size_t i = 0; i < named.shapes.size(); ++i) {
    const Enclosure& enclosure = named.shapes[i];
    Body body;
    body.link = fit.link;
    body.link_from_body = named.link_from_geometry * enclosure.geometry_from_body;
    body.shape = fit.padding > 0.0 ? grown(enclosure.shape, fit.padding) : enclosure.shape;
    body.bounding_radius = boundingRadius(body.shape);
    body.is_exact = enclosure.is_exact && fit.padding == 0.0;
    setup.bodies.push_back(body);
    BodyLabel label;
    label.shape_name = named.name + "/" + kindName(body.shape);
    if (named.shapes.size() > 1) {
      label.shape_name += "_" + std::to_string(i + 1);
    }
    label.overshoot = enclosure.overshoot;
    label.widening = enclosure.widening;
    label.is_proven = fit.is_proven;
    setup.labels.push_back(label);
  }
}

}  // namespace

void makeBodies(const std::vector<LinkFit>& fits, CycleSetup& setup) {
  for (const LinkFit& fit : fits) {
    const Link& link = setup.model.link(fit.link);
    if (fit.source == FitSource::given) {
      setup.model.links[index(fit.link)].has_given_shapes = true;
      addBodies(fit, {fit.is_proven ? "given" : "unproven", Pose(), fit.given}, setup);
      continue;
    }
    for (std::size_t i = 0; i < fit.fits.size(); ++i) {
      const CollisionElement& element = link.collisions[i];
      addBodies(fit, {element.name, element.link_from_geometry, fit.fits[i].shapes}, setup);
    }
  }
}

}  // namespace collision_monitor
