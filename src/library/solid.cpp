// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/solid.h"

#include <string>
#include <utility>

#include "collision_monitor/fitting/inner_shape.h"
#include "fitting/shapes/fit_box.h"
#include "fitting/shapes/fit_capsule.h"
#include "fitting/shapes/fit_rounded_box.h"
#include "fitting/shapes/fit_sphere.h"
#include "geometry/hulls/cone_corners.h"
#include "geometry/hulls/convex_hull.h"
#include "geometry/meshes/check_mesh.h"
#include "library/solid_parts.h"
#include "model/mesh_files/regular_file.h"
#include "model/mesh_loading/mesh_process.h"
#include "model/mesh_loading/mesh_store.h"
#include "model/number_text.h"
#include "pipeline/setup/fill_element.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

/// Gathers lengths that cannot be used.
struct LengthFaults {
  std::vector<std::string> texts;

  void check(const char* name, double length) {
    if (!(length >= 0.0 && length <= kMaxMeasured)) {
      texts.push_back(std::string(name) + " is " + shortText(length) +
                      " m; accepted: from 0 to 1e6 m");
    }
  }
  void operator()(const Sphere& sphere) { check("radius", sphere.radius); }
  void operator()(const Capsule& capsule) {
    check("radius", capsule.radius);
    check("half length", capsule.half_length);
  }
  void operator()(const Box& box) {
    for (const double half_extent : box.half_extents) {
      check("half extent", half_extent);
    }
  }
  void operator()(const Cylinder& cylinder) {
    check("radius", cylinder.radius);
    check("half length", cylinder.half_length);
  }
  void operator()(const TriangleMesh&) {}

  void throwIfAny() {
    if (!texts.empty()) {
      throw ArgumentError(std::move(texts));
    }
  }
};

/// Faults of points and triangles become ArgumentErrors.
template <class Make>
auto orArgumentError(const Make& make) {
  try {
    return make();
  } catch (const std::invalid_argument& fault) {
    throw ArgumentError({fault.what()});
  }
}

std::shared_ptr<SolidParts> makeParts(const Geometry& geometry) {
  LengthFaults faults;
  std::visit(faults, geometry);
  faults.throwIfAny();
  return orArgumentError([&] {
    auto parts = std::make_shared<SolidParts>();
    fillElement(geometry, RefineGeometry::mesh, parts->element);
    parts->element.inner = inscribeShapes(geometry);
    return parts;
  });
}

TriangleMesh readMeshFile(const std::filesystem::path& file, const MeshReading& reading) try {
  return MeshProcess(reading).read(readRegularFile(file), file.string());
} catch (const std::runtime_error& fault) {
  throw ArgumentError({fault.what()});
}

}  // namespace

Solid::Solid(std::shared_ptr<const SolidParts> parts) : parts_(std::move(parts)) {}

Solid::Solid(const Geometry& geometry) : parts_(makeParts(geometry)) {}

Solid Solid::sphere(double radius) { return Solid(Geometry(Sphere{radius})); }

Solid Solid::capsule(double radius, double length) {
  return Solid(Geometry(Capsule{0.5 * length, radius}));
}

Solid Solid::box(const Vector3d& size) { return Solid(Geometry(Box{0.5 * size})); }

Solid Solid::cylinder(double radius, double length) {
  return Solid(Geometry(Cylinder{0.5 * length, radius}));
}

Solid Solid::cone(double radius, double length) {
  LengthFaults faults;
  faults.check("radius", radius);
  faults.check("length", length);
  faults.throwIfAny();
  const auto parts = makeParts(convexHullOf(cornersAroundCone(radius, 0.5 * length)));
  parts->element.is_exact = false;
  parts->element.inner = InnerShapes();  // these may be outside of the cone itself
  return Solid(std::shared_ptr<const SolidParts>(parts));
}

Solid Solid::hull(const std::vector<Vector3d>& points) {
  return Solid(Geometry(orArgumentError([&] { return convexHullOf(points); })));
}

Solid Solid::mesh(const TriangleMesh& mesh) { return Solid(Geometry(mesh)); }

Solid Solid::mesh(const std::filesystem::path& file, const Vector3d& scale,
                  const MeshReading& reading) {
  if (!scale.allFinite()) {
    throw ArgumentError({"scale is not finite; accepted: three finite numbers"});
  }
  return mesh(scaled(readMeshFile(file, reading), scale));
}

PosedShape leastShape(ShapeKind kind, const std::vector<Vector3d>& points) {
  if (points.empty()) {
    throw ArgumentError({"there are no points; accepted: one or more"});
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!(points[i].cwiseAbs().maxCoeff() <= kMaxMeasured) || points[i].hasNaN()) {
      throw ArgumentError({"points[" + std::to_string(i) +
                           "] is not finite or too far away; accepted: up to 1e6 m"});
    }
  }
  switch (kind) {
    case ShapeKind::sphere:
      return fitSphere(points);
    case ShapeKind::capsule:
      return fitCapsule(points);
    case ShapeKind::box:
      return fitBox(points);
    case ShapeKind::rounded_box:
      break;
  }
  return fitRoundedBox(points);
}

}  // namespace collision_monitor
