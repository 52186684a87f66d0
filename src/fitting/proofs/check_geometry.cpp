// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/proofs/check_geometry.h"

#include <sstream>
#include <stdexcept>

#include "geometry/meshes/check_mesh.h"

namespace collision_monitor {
namespace {

void checkLength(const char* name, double value) {
  if (!(value >= 0.0 && value <= kMaxLength)) {
    std::ostringstream message;
    message << name << " is " << value << "; a number from 0 to " << kMaxLength << " is accepted";
    throw std::invalid_argument(message.str());
  }
}

struct Check {
  void operator()(const Sphere& sphere) const { checkLength("sphere radius", sphere.radius); }
  void operator()(const Capsule& capsule) const {
    checkLength("capsule half length", capsule.half_length);
    checkLength("capsule radius", capsule.radius);
  }
  void operator()(const Box& box) const {
    checkLength("box half extent along x", box.half_extents.x());
    checkLength("box half extent along y", box.half_extents.y());
    checkLength("box half extent along z", box.half_extents.z());
  }
  void operator()(const Cylinder& cylinder) const {
    checkLength("cylinder half length", cylinder.half_length);
    checkLength("cylinder radius", cylinder.radius);
  }
  void operator()(const TriangleMesh& mesh) const { checkMesh(mesh); }
};

}  // namespace

void checkGeometry(const Geometry& geometry) { std::visit(Check{}, geometry); }

}  // namespace collision_monitor
