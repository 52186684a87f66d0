// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/fitting/enclose.h"

#include <stdexcept>

#include "fitting/proofs/check_geometry.h"
#include "fitting/proofs/surrounding_mesh.h"
#include "fitting/shapes/candidate.h"
#include "geometry/bvh/visit_held.h"

namespace collision_monitor {
namespace {

Enclosure passThrough(const Shape& shape) {
  Enclosure enclosure;
  enclosure.shape = shape;
  enclosure.is_exact = true;
  return enclosure;
}

struct Enclose {
  const ShapeKinds& kinds;

  Enclosure operator()(const Sphere& sphere) const {
    return kinds.sphere ? passThrough(sphere) : choose(encloseCapsule({0.0, sphere.radius}));
  }
  Enclosure operator()(const Capsule& capsule) const {
    return kinds.capsule ? passThrough(capsule) : choose(encloseCapsule(capsule));
  }
  Enclosure operator()(const Box& box) const {
    return kinds.box ? passThrough(box) : choose(encloseMesh(surroundingMesh(box), kinds));
  }
  Enclosure operator()(const Cylinder& cylinder) const { return choose(encloseCylinder(cylinder)); }
  Enclosure operator()(const TriangleMesh& mesh) const { return choose(encloseMesh(mesh, kinds)); }

 private:
  Enclosure choose(const std::vector<Enclosure>& candidates) const {
    return chooseTightest(candidates, kinds);
  }
};

}  // namespace

bool isAmong(const ShapeKinds& kinds, const Shape& shape) noexcept {
  struct {
    const ShapeKinds& kinds;
    bool operator()(const Sphere&) const { return kinds.sphere; }
    bool operator()(const Capsule&) const { return kinds.capsule; }
    bool operator()(const Box&) const { return kinds.box; }
    bool operator()(const RoundedBox&) const { return kinds.rounded_box; }
  } is_allowed{kinds};
  return visitHeld(is_allowed, shape);
}

void checkKinds(const ShapeKinds& kinds) {
  if (!kinds.sphere && !kinds.capsule && !kinds.box && !kinds.rounded_box) {
    throw std::invalid_argument(
        "no kind of shape is allowed; at least one of sphere, capsule, box and rounded_box is "
        "needed");
  }
}

Enclosure encloseTightly(const Geometry& geometry, const ShapeKinds& kinds) {
  checkKinds(kinds);
  checkGeometry(geometry);
  return std::visit(Enclose{kinds}, geometry);
}

}  // namespace collision_monitor
