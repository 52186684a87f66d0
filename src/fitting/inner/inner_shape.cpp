// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/fitting/inner_shape.h"

#include <algorithm>
#include <limits>

#include "fitting/inner/inscribe_mesh.h"
#include "fitting/proofs/check_geometry.h"

namespace collision_monitor {
namespace {

/// A capsule that extends `reach` along an axis and `radius` across. Unless it is a sphere, it is
/// shorter by a hair, because the difference is rounded.
PosedShape capsuleAlong(Eigen::Index axis, double reach, double radius) {
  constexpr double kShorter = 1.0 - 2.0 * std::numeric_limits<double>::epsilon();
  PosedShape fit{Capsule{std::max(0.0, reach * kShorter - radius), radius}, {}};
  if (axis != 2) {
    // A cyclic change of axes that takes z to the requested axis.
    fit.geometry_from_body.rotation.setZero();
    for (Eigen::Index i = 0; i < 3; ++i) {
      fit.geometry_from_body.rotation((axis + 1 + i) % 3, i) = 1.0;
    }
  }
  return fit;
}

struct Inscribe {
  InnerShapes operator()(const Sphere& sphere) const { return shapes(sphere.radius, 2, 0.0); }
  InnerShapes operator()(const Capsule& capsule) const {
    InnerShapes inner = shapes(capsule.radius, 2, 0.0);
    if (inner.capsule) {
      inner.capsule->shape = capsule;
    }
    return inner;
  }
  InnerShapes operator()(const Box& box) const {
    Eigen::Index longest = 0;
    const double reach = box.half_extents.maxCoeff(&longest);
    return shapes(box.half_extents.minCoeff(), longest, reach);
  }
  InnerShapes operator()(const Cylinder& cylinder) const {
    // A flat cylinder holds a longer capsule across its axis.
    return cylinder.half_length >= cylinder.radius
               ? shapes(cylinder.radius, 2, cylinder.half_length)
               : shapes(cylinder.half_length, 0, cylinder.radius);
  }
  InnerShapes operator()(const TriangleMesh& mesh) const { return inscribeMesh(mesh); }

 private:
  static InnerShapes shapes(double radius, Eigen::Index axis, double reach) {
    InnerShapes inner;
    if (radius > 0.0) {
      inner.sphere = PosedShape{Sphere{radius}, {}};
      inner.capsule = capsuleAlong(axis, reach, radius);
    }
    return inner;
  }
};

}  // namespace

InnerShapes inscribeShapes(const Geometry& geometry) {
  checkGeometry(geometry);
  return std::visit(Inscribe{}, geometry);
}

}  // namespace collision_monitor
