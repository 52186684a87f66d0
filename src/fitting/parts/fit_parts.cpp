// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/fitting/fit_parts.h"

#include <algorithm>
#include <memory>
#include <sstream>
#include <stdexcept>

#include "fitting/parts/mesh_fitter.h"
#include "fitting/proofs/check_geometry.h"
#include "fitting/proofs/surrounding_mesh.h"
#include "fitting/shapes/candidate.h"
#include "geometry/interruption.h"

namespace collision_monitor {
namespace {

void checkLimits(const FitLimits& limits) {
  checkKinds(limits.kinds);
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

/// One geometry and its shapes so far.
struct GeometryFit {
  Fit whole;                           ///< the fit with a single shape
  TriangleMesh polyhedron;             ///< that replaces a round geometry
  std::unique_ptr<MeshFitter> fitter;  ///< for a mesh from the start, for others once they are cut

  const Fit& best() const { return fitter ? fitter->best() : whole; }
  double worstOvershoot() const { return fitter ? fitter->worstOvershoot() : whole.overshoot.max; }
};

TriangleMesh surround(const Geometry& geometry) {
  struct {
    TriangleMesh operator()(const Sphere& sphere) {
      return surroundingMesh(Capsule{0.0, sphere.radius});
    }
    TriangleMesh operator()(const Capsule& capsule) { return surroundingMesh(capsule); }
    TriangleMesh operator()(const Box& box) { return surroundingMesh(box); }
    TriangleMesh operator()(const Cylinder& cylinder) { return surroundingMesh(cylinder); }
    TriangleMesh operator()(const TriangleMesh& mesh) { return mesh; }
  } visitor;
  return std::visit(visitor, geometry);
}

GeometryFit fitInOne(const Geometry& geometry, const ShapeKinds& kinds) {
  GeometryFit fit;
  if (const auto* mesh = std::get_if<TriangleMesh>(&geometry)) {
    fit.fitter = std::make_unique<MeshFitter>(*mesh, kinds);
    fit.whole = fit.fitter->best();
  } else {
    fit.whole.shapes.push_back(encloseTightly(geometry, kinds));
    fit.whole.overshoot = fit.whole.shapes.front().overshoot;
  }
  return fit;
}

/// Cuts the worst part of all geometries until a limit is reached.
void cutParts(const std::vector<Geometry>& geometries, const FitLimits& limits,
              std::vector<GeometryFit>& fits) {
  for (std::size_t shapes = fits.size(); shapes < limits.max_shapes; ++shapes) {
    throwIfInterrupted();
    const auto worst =
        std::max_element(fits.begin(), fits.end(), [](const GeometryFit& a, const GeometryFit& b) {
          return a.worstOvershoot() < b.worstOvershoot();
        });
    if (worst == fits.end() || !(worst->worstOvershoot() > limits.target_overshoot)) {
      return;
    }
    if (!worst->fitter) {
      worst->polyhedron = surround(geometries[static_cast<std::size_t>(worst - fits.begin())]);
      worst->fitter = std::make_unique<MeshFitter>(worst->polyhedron, worst->whole.shapes.front(),
                                                   limits.kinds);
    }
    worst->fitter->cutWorst();
  }
}

/// Tries other cuts for geometries that are still coarse.
void joinParts(const FitLimits& limits, std::vector<GeometryFit>& fits) {
  std::size_t shapes = 0;
  for (const auto& fit : fits) {
    shapes += fit.best().shapes.size();
  }
  for (auto& fit : fits) {
    if (fit.fitter && fit.fitter->isCoarse() &&
        fit.best().overshoot.max > limits.target_overshoot) {
      const std::size_t others = shapes - fit.best().shapes.size();
      // Each geometry has a shape, even if there are more geometries than shapes.
      const std::size_t most = std::max(std::size_t{limits.max_shapes}, others + 1) - others;
      fit.fitter->cutAndJoin(most, limits.target_overshoot);
      shapes = others + fit.best().shapes.size();
    }
  }
}

}  // namespace

std::vector<Fit> fitGeometries(const std::vector<Geometry>& geometries, const FitLimits& limits) {
  checkLimits(limits);
  std::vector<GeometryFit> fits;
  for (const auto& geometry : geometries) {
    checkGeometry(geometry);
    fits.push_back(fitInOne(geometry, limits.kinds));
  }
  cutParts(geometries, limits, fits);
  joinParts(limits, fits);
  std::vector<Fit> result;
  result.reserve(fits.size());
  for (const auto& fit : fits) {
    result.push_back(fit.best());
  }
  return result;
}

}  // namespace collision_monitor
