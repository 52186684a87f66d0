// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/fitting/enclose.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

#include "collision_monitor/geometry/visit_held.h"
#include "fitting/candidate.h"
#include "fitting/surrounding_mesh.h"

namespace collision_monitor {
namespace {

// Cubes of lengths must be finite. [m]
constexpr double kMaxLength = 1e100;

void checkLength(const char* name, double value) {
  if (!(value >= 0.0 && value <= kMaxLength)) {
    std::ostringstream message;
    message << name << " is " << value << "; a number from 0 to " << kMaxLength << " is accepted";
    throw std::invalid_argument(message.str());
  }
}

/// Messages about single vertices come from TriangleBvh, which sees them all anyway.
void checkExtent(const TriangleMesh& mesh) {
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const double largest = mesh.vertices[i].cwiseAbs().maxCoeff();
    if (std::isfinite(largest) && largest > kMaxLength) {
      std::ostringstream message;
      message << "mesh: vertex " << i << " has a coordinate of " << largest << "; up to "
              << kMaxLength << " is accepted";
      throw std::invalid_argument(message.str());
    }
  }
}

Enclosure passThrough(const Shape& shape) {
  Enclosure enclosure;
  enclosure.shape = shape;
  enclosure.is_exact = true;
  return enclosure;
}

struct Enclose {
  const ShapeKinds& kinds;

  Enclosure operator()(const Sphere& sphere) const {
    checkLength("sphere radius", sphere.radius);
    return kinds.sphere ? passThrough(sphere) : choose(encloseCapsule({0.0, sphere.radius}));
  }
  Enclosure operator()(const Capsule& capsule) const {
    checkLength("capsule half length", capsule.half_length);
    checkLength("capsule radius", capsule.radius);
    return kinds.capsule ? passThrough(capsule) : choose(encloseCapsule(capsule));
  }
  Enclosure operator()(const Box& box) const {
    checkLength("box half extent along x", box.half_extents.x());
    checkLength("box half extent along y", box.half_extents.y());
    checkLength("box half extent along z", box.half_extents.z());
    return kinds.box ? passThrough(box) : choose(encloseMesh(surroundingMesh(box)));
  }
  Enclosure operator()(const Cylinder& cylinder) const {
    checkLength("cylinder half length", cylinder.half_length);
    checkLength("cylinder radius", cylinder.radius);
    return choose(encloseCylinder(cylinder));
  }
  Enclosure operator()(const TriangleMesh& mesh) const {
    checkExtent(mesh);
    return choose(encloseMesh(mesh));
  }

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

Enclosure encloseTightly(const Geometry& geometry, const ShapeKinds& kinds) {
  if (!kinds.sphere && !kinds.capsule && !kinds.box && !kinds.rounded_box) {
    throw std::invalid_argument(
        "no kind of shape is allowed; at least one of sphere, capsule, box and rounded_box is "
        "needed");
  }
  return std::visit(Enclose{kinds}, geometry);
}

}  // namespace collision_monitor
