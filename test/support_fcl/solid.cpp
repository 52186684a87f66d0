// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support_fcl/solid.h"

#include <algorithm>
#include <cmath>

#include "collision_monitor/geometry/mesh_tree.h"
#include "collision_monitor/geometry/winding.h"
#include "fitting/proofs/closed_surface.h"
#include "support_fcl/fcl_mesh.h"

namespace collision_monitor::test {
namespace {

struct ToFcl {
  FclGeometry operator()(const TriangleMesh& mesh) const {
    return mesh.triangles.empty() ? nullptr : toFcl(mesh);
  }
  template <class Primitive>
  FclGeometry operator()(const Primitive& primitive) const {
    return toFclGeometry(primitive);
  }
};

struct MarkPoints {
  using Points = std::vector<Eigen::Vector3d>;

  Points operator()(const TriangleMesh& mesh) const { return MeshTree(mesh).probes(); }
  Points operator()(const Sphere&) const { return {Eigen::Vector3d::Zero()}; }
  Points operator()(const Capsule& capsule) const { return box(0.0, capsule.half_length); }
  Points operator()(const Cylinder& c) const {
    return box(std::sqrt(0.5) * c.radius, c.half_length);
  }
  Points operator()(const Box& shape) const {
    Points points = box(1.0, 1.0);
    for (Eigen::Vector3d& point : points) {
      point = point.cwiseProduct(shape.half_extents);
    }
    return points;
  }

 private:
  static Points box(double width, double height) {
    Points points;
    for (int corner = 0; corner < 8; ++corner) {
      points.emplace_back((corner & 1) != 0 ? width : -width, (corner & 2) != 0 ? width : -width,
                          (corner & 4) != 0 ? height : -height);
    }
    return points;
  }
};

// Most points are not even in the box of the surface, all of whose triangles count.
Holds holds(const TriangleBvh& surface, const Eigen::Vector3d& point) {
  constexpr double kSurelyInside = 0.52;
  if (!meets(surface.bounds(), {point, point})) {
    return Holds::no;
  }
  const double winding = std::abs(windingNumber(surface, point));
  return winding > kSurelyInside ? Holds::yes : winding > 0.5 ? Holds::undecided : Holds::no;
}

}  // namespace

FclGeometry fclGeometryOf(const Geometry& geometry) { return std::visit(ToFcl{}, geometry); }

Inside insideOf(const Geometry& geometry) {
  Inside inside{std::nullopt, std::visit(MarkPoints(), geometry)};
  const auto* mesh = std::get_if<TriangleMesh>(&geometry);
  if (mesh != nullptr && !mesh->triangles.empty()) {
    const auto closed = closedSurface(*mesh);
    inside.surface.emplace(closed ? *closed : orientedSurface(*mesh));
  }
  return inside;
}

Holds holdsMarkOf(const Inside& outer, const Pose& world_from_outer, const Inside& inner,
                  const Pose& world_from_inner) {
  Holds most = Holds::no;
  if (!outer.surface) {
    return most;
  }
  const Pose outer_from_inner = inverse(world_from_outer) * world_from_inner;
  for (const Eigen::Vector3d& mark : inner.marks) {
    most = std::max(most, holds(*outer.surface, outer_from_inner * mark));
    if (most == Holds::yes) {
      break;
    }
  }
  return most;
}

}  // namespace collision_monitor::test
