// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/setup/fill_element.h"

#include <algorithm>

#include "fitting/proofs/closed_surface.h"
#include "fitting/proofs/surrounding_mesh.h"
#include "geometry/hulls/convex_hull.h"
#include "geometry/meshes/check_mesh.h"
#include "pipeline/fits/open_meshes.h"
#include "pipeline/setup/convex_mesh.h"

namespace collision_monitor {
namespace {

/// Adds stray vertices as triangles of one point, so that what encloses the mesh encloses them.
TriangleMesh withStrayVertices(const TriangleMesh& mesh) {
  TriangleMesh all = mesh;
  std::vector<bool> is_used(mesh.vertices.size(), false);
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) {
      is_used[corner] = true;
    }
  }
  for (std::size_t i = 0; i < is_used.size(); ++i) {
    if (!is_used[i]) {
      const auto vertex = static_cast<std::uint32_t>(i);
      all.triangles.push_back({vertex, vertex, vertex});
    }
  }
  return all;
}

/// Fills an element from a geometry of the URDF.
struct FillElement {
  RefineGeometry refine;
  Element& element;

  void operator()(const Cylinder& cylinder) const {
    const TriangleMesh around = surroundingMesh(cylinder);
    double reach = 0.0;
    for (const Eigen::Vector3d& corner : around.vertices) {
      reach = std::max(reach, corner.head<2>().norm());
    }
    element.convex = cylinder;
    element.mesh = std::make_shared<MeshTree>(around, true);
    element.mesh_excess = reach - cylinder.radius;
    element.is_exact = true;
  }

  void operator()(const TriangleMesh& mesh) const {
    checkMesh(mesh, kMaxMeasured);
    const TriangleMesh whole = withStrayVertices(mesh);
    const bool is_closed = closedSurface(mesh).has_value();
    ConvexHull hull(mesh.vertices);
    const bool is_convex =
        is_closed && whole.triangles.size() == mesh.triangles.size() && isSurfaceOf(mesh, hull);
    if (refine == RefineGeometry::hull && !is_convex) {
      element.mesh = std::make_shared<MeshTree>(convexHullOf(mesh.vertices), hull.hasVolume());
    } else {
      element.mesh =
          std::make_shared<MeshTree>(is_closed ? MeshTree(whole, true) : treeOfOpen(whole));
      element.is_exact = true;
    }
    const bool stands_for_it = is_convex || refine == RefineGeometry::hull;
    (stands_for_it ? element.convex : element.hull) = std::move(hull);
  }

  void operator()(const Box& box) const {
    element.convex = box;
    element.mesh =
        std::make_shared<MeshTree>(surroundingMesh(box), box.half_extents.minCoeff() > 0.0);
    element.is_exact = true;
  }

  template <class Primitive>
  void operator()(const Primitive& primitive) const {
    element.convex = primitive;
    element.is_exact = true;
  }
};

}  // namespace

void fillElement(const Geometry& geometry, RefineGeometry refine, Element& element) {
  std::visit(FillElement{refine, element}, geometry);
}

void fillAs(const Element& other, Element& element) {
  element.convex = other.convex;
  element.mesh = other.mesh;
  element.hull = other.hull;
  element.mesh_excess = other.mesh_excess;
  element.is_exact = other.is_exact;
}

}  // namespace collision_monitor
