// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/fitting/enclose.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

#include "fitting/candidate.h"

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
  Enclosure operator()(const Sphere& sphere) const {
    checkLength("sphere radius", sphere.radius);
    return passThrough(sphere);
  }
  Enclosure operator()(const Capsule& capsule) const {
    checkLength("capsule half length", capsule.half_length);
    checkLength("capsule radius", capsule.radius);
    return passThrough(capsule);
  }
  Enclosure operator()(const Box& box) const {
    checkLength("box half extent along x", box.half_extents.x());
    checkLength("box half extent along y", box.half_extents.y());
    checkLength("box half extent along z", box.half_extents.z());
    return passThrough(box);
  }
  Enclosure operator()(const Cylinder& cylinder) const {
    checkLength("cylinder half length", cylinder.half_length);
    checkLength("cylinder radius", cylinder.radius);
    return chooseTightest(encloseCylinder(cylinder));
  }
  Enclosure operator()(const TriangleMesh& mesh) const {
    checkExtent(mesh);
    return chooseTightest(encloseMesh(mesh));
  }
};

}  // namespace

Enclosure encloseTightly(const Geometry& geometry) { return std::visit(Enclose{}, geometry); }

}  // namespace collision_monitor
