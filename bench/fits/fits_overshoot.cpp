// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "fits_solids.h"
#include "fitting/proofs/closed_surface.h"
#include "fitting/search/point_cloud.h"
#include "geometry/point_triangle.h"

namespace collision_monitor::test {
namespace {

using Eigen::Vector3d;

bool isInAnother(const std::vector<Solid>& solids, std::size_t own, const Vector3d& point) {
  for (std::size_t i = 0; i < solids.size(); ++i) {
    if (i != own && signedDistance(solids[i], point) < 0.0) {
      return true;
    }
  }
  return false;
}

bool isInside(const TriangleBvh& surface, const Vector3d& point) {
  const Aabb& bounds = surface.bounds();
  return (point.array() > bounds.min.array()).all() && (point.array() < bounds.max.array()).all() &&
         std::abs(windingNumber(surface, point)) > 0.5;
}

/// Where a ray from the center leaves the solid.
Vector3d rayEnd(const Solid& solid, const Vector3d& direction) {
  const Vector3d& middle = solid.link_from_body.translation;
  const Vector3d along = solid.link_from_body.rotation * direction.normalized();
  double inside = 0.0;
  double outside = 2.0 * (solid.half_extents.norm() + solid.rim + solid.radius);
  for (int i = 0; i < 60; ++i) {
    const double half = 0.5 * (inside + outside);
    (signedDistance(solid, middle + half * along) < 0.0 ? inside : outside) = half;
  }
  return middle + outside * along;
}

double bruteDistance(const TriangleBvh& surface, const Vector3d& point) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& t : surface.triangles()) {
    least = std::min(least, (closestPointOnTriangle(point, t[0], t[1], t[2]) - point).norm());
  }
  return least;
}

}  // namespace

Overshoot overshootOf(const std::vector<Solid>& solids, const TriangleBvh& surface, int count) {
  OvershootSum sum;
  for (std::size_t i = 0; i < solids.size(); ++i) {
    for (const auto& sample : samplesOf(solids[i], count)) {
      if (!isInAnother(solids, i, sample.point)) {
        const bool is_inside = isInside(surface, sample.point);
        sum.add(is_inside ? 0.0 : surface.nearestTo(sample.point).distance, sample.area);
      }
    }
  }
  return sum.total();
}

double bruteOvershoot(const std::vector<Solid>& solids, const TriangleBvh& surface, int rays) {
  const Points directions = spreadDirections(rays);
  double worst = 0.0;
  for (std::size_t i = 0; i < solids.size(); ++i) {
    // Stretched, so that the far ends of long shapes get their share.
    const Vector3d reach =
        solids[i].half_extents + Vector3d::Constant(solids[i].radius + solids[i].rim);
    const auto look = [&](const Vector3d& direction) {
      const Vector3d point = rayEnd(solids[i], direction);
      if (!isInAnother(solids, i, point) && !isInside(surface, point)) {
        worst = std::max(worst, bruteDistance(surface, point));
      }
    };
    for (const auto& direction : directions) {
      look(reach.cwiseProduct(direction));
      look(-reach.cwiseProduct(direction));
    }
    for (int signs = 0; signs < 8; ++signs) {
      const Vector3d corner((signs & 1) != 0 ? 1.0 : -1.0, (signs & 2) != 0 ? 1.0 : -1.0,
                            (signs & 4) != 0 ? 1.0 : -1.0);
      look(solids[i].half_extents.cwiseProduct(corner));
    }
  }
  return worst;
}

}  // namespace collision_monitor::test
