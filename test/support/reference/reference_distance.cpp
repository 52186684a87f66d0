// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/reference/reference_distance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace collision_monitor::test {
namespace {

using Real = long double;
using Vector = Eigen::Matrix<Real, 3, 1>;

// Smaller sines count as parallel. So thin a facet moves the depth by 1e-18 of its length.
constexpr Real kParallelSine = 1e-18L;

// The set b - a of the cores. Its generators are the half edges of both.
struct Zonotope {
  Vector center;
  std::vector<Vector> generators;
  std::vector<Vector> pose_axes;
};

Zonotope differenceOfCores(const Shape& a, const Pose& world_from_a, const Shape& b,
                           const Pose& world_from_b) {
  Zonotope zonotope;
  zonotope.center = world_from_b.translation.cast<Real>() - world_from_a.translation.cast<Real>();
  const auto add = [&](const Shape& shape, const Pose& pose) {
    const Eigen::Vector3d half_extents = coreHalfExtents(shape);
    for (Eigen::Index k = 0; k < 3; ++k) {
      const Vector axis = pose.rotation.col(k).cast<Real>();
      zonotope.pose_axes.push_back(axis);
      if (half_extents[k] > 0.0) {
        zonotope.generators.push_back(static_cast<Real>(half_extents[k]) * axis);
      }
    }
  };
  add(a, world_from_a);
  add(b, world_from_b);
  return zonotope;
}

// Distance of the origin to the supporting plane that faces it; > 0 if the origin is outside.
Real gapAlong(const Zonotope& zonotope, const Vector& unit_normal) {
  Real gap = std::abs(unit_normal.dot(zonotope.center));
  for (const Vector& generator : zonotope.generators) {
    gap -= std::abs(unit_normal.dot(generator));
  }
  return gap;
}

Vector facing(const Zonotope& zonotope, const Vector& normal) {
  return normal.dot(zonotope.center) < 0 ? Vector(-normal) : normal;
}

struct Answer {
  Real distance{0};
  Vector normal{Vector::UnitX()};
};

// The largest gap over all possible facet normals: the signed distance if it is <= 0.
Answer largestGap(const Zonotope& zonotope) {
  Answer best{-std::numeric_limits<Real>::infinity(), Vector::UnitX()};
  const auto offer = [&](const Vector& unit_normal) {
    const Real gap = gapAlong(zonotope, unit_normal);
    if (gap > best.distance) {
      best = {gap, facing(zonotope, unit_normal)};
    }
  };
  for (const Vector& axis : zonotope.pose_axes) {
    offer(axis.normalized());
  }
  for (std::size_t i = 0; i < zonotope.generators.size(); ++i) {
    const Vector first = zonotope.generators[i].normalized();
    for (std::size_t j = i + 1; j < zonotope.generators.size(); ++j) {
      // Made orthogonal before the cross product, so that the normal is perpendicular to both
      // generators even at tiny angles.
      const Vector direction = zonotope.generators[j].normalized();
      const Vector second = direction - first.dot(direction) * first;
      if (second.norm() > kParallelSine) {
        offer(first.cross(second.normalized()).normalized());
      }
    }
  }
  return best;
}

Real clampToOne(Real value) { return std::max(Real(-1), std::min(Real(1), value)); }

// The part of `vector` across `g`. Done twice: when the two are nearly parallel, the first pass
// leaves mostly rounding along g.
Vector across(const Vector& g, const Vector& vector) {
  const Vector once = vector - g.dot(vector) / g.squaredNorm() * g;
  return once - g.dot(once) / g.squaredNorm() * g;
}

// The point nearest to the origin in { start + u g + v h, |u|, |v| <= 1 }. It clamps the plane's
// nearest point; a clamped answer is a point of the set all the same.
Vector nearestInTile(const Vector& start, const Vector& g, const Vector& h) {
  const Vector h_across = across(g, h);
  Real v = 0;
  if (h_across.norm() > kParallelSine * h.norm()) {
    v = clampToOne(-across(g, start).dot(h_across) / h_across.squaredNorm());
  }
  const Real u = clampToOne(-(start + v * h).dot(g) / g.squaredNorm());
  return start + u * g + v * h;
}

struct Nearest {
  Vector point;
  Real squared{std::numeric_limits<Real>::infinity()};

  void offer(const Vector& candidate) {
    const Real candidate_squared = candidate.squaredNorm();
    if (candidate_squared < squared) {
      squared = candidate_squared;
      point = candidate;
    }
  }
};

// Tests every corner, edge and tile of the zonotope, and inner ones, which do no harm.
Vector nearestToOrigin(const Zonotope& zonotope) {
  const std::vector<Vector>& g = zonotope.generators;
  Nearest nearest;
  for (unsigned signs = 0; signs < (1U << g.size()); ++signs) {
    Vector corner = zonotope.center;
    for (std::size_t k = 0; k < g.size(); ++k) {
      corner += ((signs >> k) & 1U) != 0U ? g[k] : Vector(-g[k]);
    }
    nearest.offer(corner);
    // Counts a free variable once, from the corner where it is at its lower bound.
    for (std::size_t i = 0; i < g.size(); ++i) {
      if (((signs >> i) & 1U) != 0U) {
        continue;
      }
      const Vector on_edge = corner + g[i];
      nearest.offer(on_edge + clampToOne(-on_edge.dot(g[i]) / g[i].squaredNorm()) * g[i]);
      for (std::size_t j = i + 1; j < g.size(); ++j) {
        if (((signs >> j) & 1U) == 0U) {
          nearest.offer(nearestInTile(on_edge + g[j], g[i], g[j]));
        }
      }
    }
  }
  return nearest.point;
}

}  // namespace

Reference referenceDistance(const Shape& a, const Pose& world_from_a, const Shape& b,
                            const Pose& world_from_b) {
  const Zonotope zonotope = differenceOfCores(a, world_from_a, b, world_from_b);
  Answer cores = largestGap(zonotope);
  Real certified_gap = 0;
  if (cores.distance > 0) {
    const Vector nearest = nearestToOrigin(zonotope);
    const Real distance = nearest.norm();
    // If the origin nearly touches, rounding may put either bound on the wrong side.
    if (distance > cores.distance) {
      const Vector normal = nearest / distance;
      certified_gap = distance - std::max(cores.distance, gapAlong(zonotope, normal));
      cores = {distance, normal};
    }
  }
  const Real radii = static_cast<Real>(radiusOf(a)) + static_cast<Real>(radiusOf(b));
  return {static_cast<double>(cores.distance - radii), cores.normal.cast<double>(),
          static_cast<double>(certified_gap)};
}

}  // namespace collision_monitor::test
