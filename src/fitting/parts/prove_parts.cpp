// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "collision_monitor/fitting/fit_parts.h"
#include "fitting/proofs/check_geometry.h"
#include "fitting/proofs/proof.h"
#include "fitting/proofs/surrounding_mesh.h"
#include "fitting/shapes/candidate.h"
#include "fitting/shapes/mesh_part.h"
#include "geometry/constants.h"

namespace collision_monitor {
namespace {

/// Refuses huge normals, whose heights overflow: a corner with a NaN height is on neither side.
bool isPlane(const PartCut& cut) {
  constexpr double kUnit = 1e-6;
  return std::abs(cut.normal.squaredNorm() - 1.0) <= kUnit && std::isfinite(cut.offset);
}

bool isSound(const Fit& fit) {
  const std::size_t parts = fit.shape_of.empty() ? fit.shapes.size() : fit.shape_of.size();
  if (fit.shapes.empty() || fit.cuts.size() + 1 != parts) {
    return false;
  }
  if (std::any_of(fit.shape_of.begin(), fit.shape_of.end(),
                  [&](std::uint32_t shape) { return shape >= fit.shapes.size(); })) {
    return false;
  }
  for (std::size_t i = 0; i < fit.cuts.size(); ++i) {
    if (fit.cuts[i].part > i || !isPlane(fit.cuts[i])) {
      return false;
    }
  }
  return std::all_of(fit.shapes.begin(), fit.shapes.end(), [](const Enclosure& enclosure) {
    const Eigen::Vector3d core = coreHalfExtents(enclosure.shape);
    const double radius = radiusOf(enclosure.shape);
    return core.allFinite() && (core.array() >= 0.0).all() && std::isfinite(radius) &&
           radius >= 0.0 && isRigid(enclosure.geometry_from_body);
  });
}

/// Repeats the cuts and tests each part against its shape.
double excessOfParts(const TriangleMesh& mesh, const Fit& fit) {
  PartedSurface surface(mesh);
  std::vector<MeshPart> parts{surface.whole()};
  std::vector<double> slack{0.0};
  for (const auto& cut : fit.cuts) {
    MeshPart below;
    MeshPart above;
    surface.split(parts[cut.part], {cut.normal, cut.offset}, below, above);
    parts[cut.part] = std::move(below);
    parts.push_back(std::move(above));
    slack[cut.part] += surface.cutError();
    slack.push_back(slack[cut.part]);
  }
  double excess = -kInfinity;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Points corners = surface.cornersOf(parts[i]);
    if (!corners.empty()) {
      const Enclosure& shape = fit.shapes[fit.shape_of.empty() ? i : fit.shape_of[i]];
      excess = std::max(excess, provenExcess(posedShapeOf(shape), corners) + slack[i]);
    }
  }
  return excess;
}

bool isInPlace(const PosedShape& shape) {
  return shape.geometry_from_body.rotation.isIdentity(0.0) &&
         shape.geometry_from_body.translation.isZero(0.0);
}

/// If the shape is the geometry itself, nothing is computed, so there is no rounding.
bool isIn(const Sphere& sphere, const PosedShape& shape) {
  const auto* other = std::get_if<Sphere>(&shape.shape);
  return isInPlace(shape) && other != nullptr && sphere.radius <= other->radius;
}

bool isIn(const Capsule& capsule, const PosedShape& shape) {
  const auto* other = std::get_if<Capsule>(&shape.shape);
  return isInPlace(shape) && other != nullptr && capsule.half_length <= other->half_length &&
         capsule.radius <= other->radius;
}

bool isIn(const Box& box, const PosedShape& shape) {
  const auto* other = std::get_if<Box>(&shape.shape);
  return isInPlace(shape) && other != nullptr &&
         (box.half_extents.array() <= other->half_extents.array()).all();
}

struct Prove {
  const Fit& fit;

  double operator()(const TriangleMesh& mesh) const { return excessOfParts(mesh, fit); }
  double operator()(const Box& box) const {
    return isIn(box, whole()) ? 0.0 : excessOfParts(surroundingMesh(box), fit);
  }
  double operator()(const Sphere& sphere) const {
    return isIn(sphere, whole()) ? 0.0 : excessOfRound(Capsule{0.0, sphere.radius});
  }
  double operator()(const Capsule& capsule) const {
    return isIn(capsule, whole()) ? 0.0 : excessOfRound(capsule);
  }
  double operator()(const Cylinder& cylinder) const { return excessOfRound(cylinder); }

 private:
  PosedShape whole() const {
    return fit.cuts.empty() ? posedShapeOf(fit.shapes.front()) : PosedShape{Sphere{0.0}, {}};
  }
  template <class Round>
  double excessOfRound(const Round& round) const {
    return fit.cuts.empty() && isInPlace(whole()) ? provenExcess(whole(), round)
                                                  : excessOfParts(surroundingMesh(round), fit);
  }
};

}  // namespace

double provenExcess(const Geometry& geometry, const Fit& fit) {
  checkGeometry(geometry);
  return isSound(fit) ? std::visit(Prove{fit}, geometry) : kInfinity;
}

}  // namespace collision_monitor
