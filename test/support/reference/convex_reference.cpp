// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/reference/convex_reference.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include "geometry/hulls/convex_hull.h"
#include "support/reference/convex_polyhedron.h"

namespace collision_monitor::test {
namespace {

constexpr Real kFarthest = std::numeric_limits<Real>::infinity();

std::vector<Eigen::Vector3d> corners(const Eigen::Vector3d& half_extents) {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d signs((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1,
                                (i & 4) != 0 ? 1 : -1);
    points.push_back(signs.cwiseProduct(half_extents));
  }
  return points;
}

struct CorePoints {
  std::vector<Eigen::Vector3d> operator()(const Sphere&) const { return {Eigen::Vector3d::Zero()}; }
  std::vector<Eigen::Vector3d> operator()(const Capsule& s) const {
    return corners({0.0, 0.0, s.half_length});
  }
  std::vector<Eigen::Vector3d> operator()(const Box& s) const { return corners(s.half_extents); }
  std::vector<Eigen::Vector3d> operator()(const RoundedBox& s) const {
    return corners(s.half_extents);
  }
  std::vector<Eigen::Vector3d> operator()(const ConvexHull& hull) const { return hull.vertices(); }
  template <class Other>
  std::vector<Eigen::Vector3d> operator()(const Other&) const {
    return {};
  }
};

Real radiusOfGeometry(const ConvexGeometry& geometry) {
  struct {
    Real operator()(const Sphere& s) const { return s.radius; }
    Real operator()(const Capsule& s) const { return s.radius; }
    Real operator()(const RoundedBox& s) const { return s.radius; }
    Real operator()(const Box&) const { return 0; }
    Real operator()(const Cylinder&) const { return 0; }
    Real operator()(const ConvexHull&) const { return 0; }
    Real operator()(const HalfSpace&) const { return 0; }
  } radius;
  return std::visit(radius, geometry);
}

}  // namespace

Polyhedron polyhedronOf(const ConvexGeometry& geometry, const Pose& pose) {
  const TriangleMesh mesh = convexHullOf(std::visit(CorePoints{}, geometry));
  Polyhedron placed;
  placed.radius = radiusOfGeometry(geometry);
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    placed.points.push_back(pose.rotation.cast<Real>() * vertex.cast<Real>() +
                            pose.translation.cast<Real>());
  }
  placed.triangles = mesh.triangles;
  std::set<std::pair<std::size_t, std::size_t>> edges;
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      edges.insert(std::minmax<std::size_t>(t[k], t[(k + 1) % 3]));
    }
  }
  if (placed.points.size() == 2) {
    edges.insert({0, 1});
  }
  placed.edges.assign(edges.begin(), edges.end());
  return placed;
}

Vector normalOf(const Polyhedron& p, const std::array<std::uint32_t, 3>& t) {
  return (p.points[t[1]] - p.points[t[0]]).cross(p.points[t[2]] - p.points[t[0]]);
}

namespace {

Real gapAlong(const Polyhedron& a, const Polyhedron& b, const Vector& direction) {
  Real end_of_a = -kFarthest;
  Real start_of_b = kFarthest;
  for (const Vector& point : a.points) {
    end_of_a = std::max(end_of_a, direction.dot(point));
  }
  for (const Vector& point : b.points) {
    start_of_b = std::min(start_of_b, direction.dot(point));
  }
  return start_of_b - end_of_a;
}

bool isFlat(const Polyhedron& p) {
  return p.triangles.empty() ||
         std::all_of(p.points.begin(), p.points.end(), [&](const Vector& point) {
           const Vector normal = normalOf(p, p.triangles[0]).normalized();
           return std::abs(normal.dot(point - p.points[p.triangles[0][0]])) < 1e-12L;
         });
}

// Flat pieces in one plane: their Minkowski difference has no volume, and sides across the plane.
template <class Offer>
void offerSidesOfFlat(const Polyhedron& a, const Polyhedron& b, const Offer& offer) {
  for (const Polyhedron* plane : {&a, &b}) {
    for (const auto& t : plane->triangles) {
      for (const Polyhedron* sides : {&a, &b}) {
        for (const auto& [i, j] : sides->edges) {
          offer(normalOf(*plane, t).cross(sides->points[j] - sides->points[i]));
        }
      }
    }
  }
}

Real largestGap(const Polyhedron& a, const Polyhedron& b) {
  Real largest = -kFarthest;
  const auto offer = [&](const Vector& normal) {
    const Real length = normal.norm();
    if (length > 0) {
      const Vector unit = normal / length;
      largest = std::max({largest, gapAlong(a, b, unit), gapAlong(a, b, -unit)});
    }
  };
  for (const Polyhedron* p : {&a, &b}) {
    for (const auto& t : p->triangles) {
      offer(normalOf(*p, t));
    }
  }
  for (const auto& [i, j] : a.edges) {
    const Vector along = (a.points[j] - a.points[i]).normalized();
    for (const auto& [k, l] : b.edges) {
      Vector across = (b.points[l] - b.points[k]).normalized();
      across -= along.dot(across) * along;
      if (across.norm() > 1e-15L) {
        offer(along.cross(across.normalized()));
      }
    }
  }
  if (isFlat(a) && isFlat(b)) {
    offerSidesOfFlat(a, b, offer);
  }
  return largest;
}

Real clampToUnit(Real value) { return std::max<Real>(0, std::min<Real>(1, value)); }

Real distanceOfEdges(const Vector& p, const Vector& u, const Vector& q, const Vector& v) {
  const Vector between = q - p;
  const Real uu = u.dot(u);
  const Vector v_across = v - v.dot(u) / uu * u;
  const Real squared = v_across.dot(v_across);
  Real on_v = squared > 1e-30L * v.dot(v) ? clampToUnit(-between.dot(v_across) / squared) : 0;
  const Real on_u = clampToUnit((between + on_v * v).dot(u) / uu);
  on_v = clampToUnit((on_u * u - between).dot(v) / v.dot(v));
  return (between + on_v * v - clampToUnit((between + on_v * v).dot(u) / uu) * u).norm();
}

// Only to the inside of the triangle; its edges are tested elsewhere.
Real distanceToInside(const Vector& point, const Vector& a, const Vector& b, const Vector& c) {
  const Vector normal = (b - a).cross(c - a);
  const Real squared = normal.squaredNorm();
  if (!(squared > 0) || (b - a).cross(point - a).dot(normal) < 0 ||
      (c - b).cross(point - b).dot(normal) < 0 || (a - c).cross(point - c).dot(normal) < 0) {
    return kFarthest;
  }
  return std::abs((point - a).dot(normal)) / std::sqrt(squared);
}

Real distanceToFaces(const Polyhedron& corners_of, const Polyhedron& faces_of) {
  Real least = kFarthest;
  for (const Vector& point : corners_of.points) {
    for (const Vector& other : faces_of.points) {
      least = std::min(least, (point - other).norm());
    }
    for (const auto& [i, j] : faces_of.edges) {
      const Vector edge = faces_of.points[j] - faces_of.points[i];
      const Vector from = point - faces_of.points[i];
      least = std::min(least, (from - clampToUnit(from.dot(edge) / edge.dot(edge)) * edge).norm());
    }
    for (const auto& t : faces_of.triangles) {
      least = std::min(least, distanceToInside(point, faces_of.points[t[0]], faces_of.points[t[1]],
                                               faces_of.points[t[2]]));
    }
  }
  return least;
}

Real distanceApart(const Polyhedron& a, const Polyhedron& b) {
  Real least = std::min(distanceToFaces(a, b), distanceToFaces(b, a));
  for (const auto& [i, j] : a.edges) {
    for (const auto& [k, l] : b.edges) {
      least = std::min(least, distanceOfEdges(a.points[i], a.points[j] - a.points[i], b.points[k],
                                              b.points[l] - b.points[k]));
    }
  }
  return least;
}

Real distanceOfPolyhedra(const Polyhedron& a, const Polyhedron& b) {
  const Real gap = largestGap(a, b);
  const bool is_flat = !std::isfinite(static_cast<double>(gap));  // two points: no normal at all
  return (gap > 0 || is_flat ? distanceApart(a, b) : gap) - a.radius - b.radius;
}

}  // namespace

bool convexReference(const PosedConvexPair& pair, long double& distance) {
  const auto is = [&](auto type) {
    using Type = decltype(type);
    return std::holds_alternative<Type>(*pair.a) || std::holds_alternative<Type>(*pair.b);
  };
  if (is(HalfSpace{})) {
    return false;
  }
  if (is(Cylinder{})) {
    distance = cylinderReference(pair);
    return true;
  }
  distance = distanceOfPolyhedra(polyhedronOf(*pair.a, pair.world_from_a),
                                 polyhedronOf(*pair.b, pair.world_from_b));
  return true;
}

}  // namespace collision_monitor::test
