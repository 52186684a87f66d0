// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/fitting/fit_parts.h"

#include <algorithm>
#include <memory>
#include <sstream>
#include <stdexcept>

#include "fitting/mesh_fitter.h"
#include "fitting/surrounding_mesh.h"

namespace collision_monitor {
namespace {

void checkLimits(const FitLimits& limits) {
  if (limits.max_shapes == 0) {
    throw std::invalid_argument("max_shapes is 0; at least 1 is accepted");
  }
  if (!(limits.target_overshoot >= 0.0)) {
    std::ostringstream message;
    message << "target_overshoot is " << limits.target_overshoot
            << "; a number not below 0 is accepted, in metres";
    throw std::invalid_argument(message.str());
  }
}

/// One geometry with one shape, which becomes several once it is cut.
struct GeometryFit {
  Fit whole;
  TriangleMesh polyhedron;  ///< of a round geometry
  std::unique_ptr<MeshFitter> parts;

  double worstOvershoot() const { return parts ? parts->worstOvershoot() : whole.overshoot.max; }
};

const TriangleMesh& surfaceOf(const Geometry& geometry, TriangleMesh& polyhedron) {
  struct {
    TriangleMesh operator()(const Sphere& sphere) {
      return surroundingMesh(Capsule{0.0, sphere.radius});
    }
    TriangleMesh operator()(const Capsule& capsule) { return surroundingMesh(capsule); }
    TriangleMesh operator()(const Box& box) { return surroundingMesh(box); }
    TriangleMesh operator()(const Cylinder& cylinder) { return surroundingMesh(cylinder); }
    TriangleMesh operator()(const TriangleMesh&) { return {}; }
  } surround;
  if (const auto* mesh = std::get_if<TriangleMesh>(&geometry)) {
    return *mesh;
  }
  polyhedron = std::visit(surround, geometry);
  return polyhedron;
}

/// Cuts the worst part of all geometries until the limits are reached.
void cutParts(const std::vector<Geometry>& geometries, const FitLimits& limits,
              std::vector<GeometryFit>& fits) {
  for (std::size_t shapes = fits.size(); shapes < limits.max_shapes; ++shapes) {
    const auto worst =
        std::max_element(fits.begin(), fits.end(), [](const GeometryFit& a, const GeometryFit& b) {
          return a.worstOvershoot() < b.worstOvershoot();
        });
    if (worst == fits.end() || !(worst->worstOvershoot() > limits.target_overshoot)) {
      return;
    }
    if (!worst->parts) {
      const auto& geometry = geometries[static_cast<std::size_t>(worst - fits.begin())];
      worst->parts = std::make_unique<MeshFitter>(surfaceOf(geometry, worst->polyhedron),
                                                  worst->whole.shapes.front(), limits.kinds);
    }
    worst->parts->cutWorst();
  }
}

}  // namespace

std::vector<Fit> fitGeometries(const std::vector<Geometry>& geometries, const FitLimits& limits) {
  checkLimits(limits);
  std::vector<GeometryFit> fits(geometries.size());
  for (std::size_t i = 0; i < geometries.size(); ++i) {
    fits[i].whole.shapes.push_back(encloseTightly(geometries[i], limits.kinds));
    fits[i].whole.overshoot = fits[i].whole.shapes.front().overshoot;
  }
  cutParts(geometries, limits, fits);
  std::vector<Fit> result;
  for (auto& fit : fits) {
    result.push_back(fit.parts ? fit.parts->best() : std::move(fit.whole));
  }
  return result;
}

}  // namespace collision_monitor
