// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/check_geometry.h"

#include <sstream>
#include <stdexcept>
#include <string>

namespace collision_monitor {
namespace {

constexpr double kMaxLength = 1e100;  // [m]

void checkLength(const char* name, double value) {
  if (!(value >= 0.0 && value <= kMaxLength)) {
    std::ostringstream message;
    message << name << " is " << value << "; a number from 0 to " << kMaxLength << " is accepted";
    throw std::invalid_argument(message.str());
  }
}

void checkIndices(const TriangleMesh& mesh) {
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (const auto corner : mesh.triangles[i]) {
      if (corner >= mesh.vertices.size()) {
        throw std::invalid_argument("mesh: triangle " + std::to_string(i) + " names vertex " +
                                    std::to_string(corner) + "; there are " +
                                    std::to_string(mesh.vertices.size()) + ", counted from 0");
      }
    }
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
  void operator()(const TriangleMesh& mesh) const {
    if (mesh.vertices.empty()) {
      throw std::invalid_argument("mesh: no vertices; at least one is needed");
    }
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
      const Eigen::Vector3d& vertex = mesh.vertices[i];
      if (!(vertex.array().abs() <= kMaxLength).all()) {
        std::ostringstream message;
        message << "mesh: vertex " << i << " is (" << vertex.transpose() << "); coordinates up to "
                << kMaxLength << " are accepted";
        throw std::invalid_argument(message.str());
      }
    }
    checkIndices(mesh);
  }
};

}  // namespace

void checkGeometry(const Geometry& geometry) { std::visit(Check{}, geometry); }

}  // namespace collision_monitor
