// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/epa/epa.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "narrow_phase/closed_form/core_distance.h"
#include "narrow_phase/epa/polytope.h"

namespace collision_monitor {
namespace {

using Face = ConvexWorkspace::Face;

SupportVertex farthestAlong(const Eigen::Vector3d& direction, ConvexPair& pair) noexcept {
  return leastAlong(-direction, pair);
}

// Up to four points of the Minkowski difference, each as far from the others' span as it gets.
struct Tetrahedron {
  std::array<SupportVertex, 4> corners;
  int size{0};
  Eigen::Vector3d across{Eigen::Vector3d::UnitX()};  ///< unit, perpendicular to their span
};

// Adds the support point farthest from the span of the corners, which `distance` measures. Adds
// none if all are off the span by rounding alone.
template <class Distance>
bool addFarthest(const std::array<Eigen::Vector3d, 3>& directions, const Distance& distance,
                 ConvexPair& pair, Tetrahedron& found) noexcept {
  double farthest = 8.0 * roundingOf(pair);
  const int before = found.size;
  for (const Eigen::Vector3d& direction : directions) {
    for (const double sign : {1.0, -1.0}) {
      const SupportVertex vertex = farthestAlong(sign * direction, pair);
      const double away = distance(vertex.difference);
      if (away > farthest) {
        farthest = away;
        found.corners[static_cast<std::size_t>(before)] = vertex;
        found.size = before + 1;
      }
    }
  }
  return found.size > before;
}

// Returns false if the difference has no volume; `across` is then a direction in which it is flat.
bool span(ConvexPair& pair, Tetrahedron& found) noexcept {
  const auto point = [&](std::size_t i) -> const Eigen::Vector3d& {
    return found.corners[i].difference;
  };
  if (found.size == 1) {
    const auto away = [&](const Eigen::Vector3d& p) { return (p - point(0)).norm(); };
    if (!addFarthest({Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ()},
                     away, pair, found)) {
      return false;
    }
  }
  if (found.size == 2) {
    const Eigen::Vector3d along = (point(1) - point(0)).normalized();
    found.across = perpendicularTo(along);
    const auto away = [&](const Eigen::Vector3d& p) { return along.cross(p - point(0)).norm(); };
    const Eigen::Vector3d other = along.cross(found.across);
    if (!addFarthest({found.across, other, (found.across + other) * std::sqrt(0.5)}, away, pair,
                     found)) {
      return false;
    }
  }
  if (found.size == 3) {
    found.across = (point(1) - point(0)).cross(point(2) - point(0)).normalized();
    const auto away = [&](const Eigen::Vector3d& p) {
      return std::abs(found.across.dot(p - point(0)));
    };
    return addFarthest({found.across, found.across, found.across}, away, pair, found);
  }
  return true;
}

Penetration flatContact(const Simplex& simplex, const Eigen::Vector3d& across) noexcept {
  Penetration flat;
  flat.depth = 0.0;
  flat.outward = across;
  flat.on_a = simplex.pointOnA();
  flat.on_b = simplex.pointOnB();
  flat.is_settled = true;
  return flat;
}

std::size_t nearestFace(const ConvexWorkspace& polytope) noexcept {
  const auto first = polytope.keys.begin();
  const auto last = first + static_cast<std::ptrdiff_t>(polytope.face_count);
  return static_cast<std::size_t>(std::min_element(first, last) - first);
}

// Rounding may ask for a vertex that the polytope already has.
bool isVertex(const SupportVertex& vertex, const ConvexWorkspace& polytope) noexcept {
  const auto last = polytope.vertices.begin() + static_cast<std::ptrdiff_t>(polytope.vertex_count);
  return std::any_of(polytope.vertices.begin(), last, [&](const SupportVertex& known) {
    return known.difference == vertex.difference;
  });
}

// Grows until the bounds meet: at a face that the difference exceeds by at most the tolerance, or,
// if rounding keeps the nearest face from being refined, at the best plane.
void refine(ConvexPair& pair, double tolerance, ConvexWorkspace& polytope,
            Penetration& best) noexcept {
  // On a curved surface another plane may be as good, but its normal would not fit the points of
  // the nearest face.
  const double tie = pair.isSmooth() ? 0.0 : tolerance;
  // A vertex farther out than this is certainly new.
  const double certain = 1e-9 * pair.size;
  for (;;) {
    const std::size_t nearest = nearestFace(polytope);
    if (polytope.keys[nearest] >= best.depth - tie) {
      best.is_settled = true;
      return;
    }
    const Face& face = polytope.faces[nearest];
    const SupportVertex vertex = farthestAlong(face.normal, pair);
    const double plane = face.normal.dot(vertex.difference);
    const double beyond = plane - face.offset;
    if (plane < best.depth || beyond <= tolerance) {
      best.depth = plane;
      best.outward = face.normal;
    }
    if (beyond <= tolerance) {
      best.is_settled = true;
      return;
    }
    const bool is_known = beyond < certain && isVertex(vertex, polytope);
    const Growth growth =
        is_known ? Growth::refused : grow(vertex, nearest, roundingOf(pair), polytope);
    if (growth == Growth::full) {
      best.at_least = polytope.keys[nearest];
      return;
    }
    if (growth == Growth::refused) {
      polytope.keys[nearest] = plane;
    }
  }
}

using Corners = std::array<Eigen::Vector3d, 3>;

// Weights of the corners at the projection of the origin, none negative. Returns false if it lies
// outside the triangle.
bool weighInside(const Corners& p, Eigen::Vector3d& weights) noexcept {
  const Eigen::Vector3d first = p[1] - p[0];
  const Eigen::Vector3d second = p[2] - p[0];
  const Eigen::Vector3d normal = first.cross(second);
  const double squared = normal.squaredNorm();
  const double u = -p[0].cross(second).dot(normal);
  const double v = -first.cross(p[0]).dot(normal);
  if (!(squared > 0.0) || u < 0.0 || v < 0.0 || u + v > squared) {
    return false;
  }
  weights = {(squared - u - v) / squared, u / squared, v / squared};
  return true;
}

// Weights of the corners at the triangle's closest point to the origin.
Eigen::Vector3d weightsOf(const Corners& p) noexcept {
  Eigen::Vector3d weights;
  if (weighInside(p, weights)) {
    return weights;
  }
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t other = (k + 1) % 3;
    const Eigen::Vector3d edge = p[other] - p[k];
    const double squared = edge.squaredNorm();
    const double share = squared > 0.0 ? std::clamp(-p[k].dot(edge) / squared, 0.0, 1.0) : 0.0;
    const double away = (p[k] + share * edge).squaredNorm();
    if (away < least) {
      least = away;
      weights.setZero();
      weights[static_cast<Eigen::Index>(k)] = 1.0 - share;
      weights[static_cast<Eigen::Index>(other)] = share;
    }
  }
  return weights;
}

// The point of a face that is closest to the origin's projection, and what it comes from.
struct ClosestPoint {
  double defect{std::numeric_limits<double>::infinity()};  // squared
  Eigen::Vector3d on_a{Eigen::Vector3d::Zero()};
  Eigen::Vector3d on_b{Eigen::Vector3d::Zero()};
  std::size_t face{0};
};

ClosestPoint closestOn(std::size_t index, const Eigen::Vector3d& closest,
                       const ConvexWorkspace& polytope) noexcept {
  const Face& face = polytope.faces[index];
  Corners corners;
  for (std::size_t k = 0; k < 3; ++k) {
    corners[k] = polytope.vertices[face.corners[k]].difference - closest;
  }
  const Eigen::Vector3d weights = weightsOf(corners);
  Eigen::Vector3d away = Eigen::Vector3d::Zero();
  ClosestPoint found;
  for (std::size_t k = 0; k < 3; ++k) {
    const double weight = weights[static_cast<Eigen::Index>(k)];
    away += weight * corners[k];
    found.on_a += weight * polytope.vertices[face.corners[k]].on_a;
    found.on_b += weight * polytope.vertices[face.corners[k]].on_b;
  }
  found.defect = away.squaredNorm();
  found.face = index;
  return found;
}

// The origin's projection on the best plane lies in a face: mostly the nearest, else the one that
// comes closest to it. The points of any face will do, whatever its orientation.
ClosestPoint findClosest(double tolerance, const ConvexWorkspace& polytope,
                         const Penetration& best) noexcept {
  const Eigen::Vector3d closest = best.depth * best.outward;
  ClosestPoint found = closestOn(nearestFace(polytope), closest, polytope);
  for (std::size_t f = 0; f < polytope.face_count && found.defect > tolerance * tolerance; ++f) {
    if (!polytope.faces[f].is_gone) {
      const ClosestPoint candidate = closestOn(f, closest, polytope);
      found = candidate.defect < found.defect ? candidate : found;
    }
  }
  return found;
}

void takePoints(const ClosestPoint& closest, const ConvexWorkspace& polytope,
                Penetration& best) noexcept {
  best.on_a = closest.on_a;
  best.on_b = closest.on_b;
  for (std::size_t k = 0; k < 3; ++k) {
    best.face[k] = polytope.vertices[polytope.faces[closest.face].corners[k]];
  }
  best.face_size = 3;
}

}  // namespace

Penetration runEpa(ConvexPair& pair, const Simplex& simplex, double tolerance,
                   ConvexWorkspace& polytope) noexcept {
  Tetrahedron start;
  start.corners = simplex.vertices;
  start.size = simplex.size;
  if (!span(pair, start)) {
    return flatContact(simplex, start.across);
  }
  startPolytope(start.corners, polytope);
  Penetration best;
  refine(pair, tolerance, polytope, best);
  takePoints(findClosest(tolerance, polytope, best), polytope, best);
  return best;
}

}  // namespace collision_monitor
