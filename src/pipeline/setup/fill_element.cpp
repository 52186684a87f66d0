// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/setup/fill_element.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "fitting/proofs/closed_surface.h"
#include "fitting/proofs/surrounding_mesh.h"
#include "geometry/all_cores.h"
#include "geometry/hulls/convex_hull.h"
#include "geometry/meshes/check_mesh.h"
#include "geometry/meshes/used_vertices.h"
#include "pipeline/fits/open_meshes.h"
#include "pipeline/setup/convex_mesh.h"

namespace collision_monitor {
namespace {

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

  void operator()(const TriangleMesh& given) const {
    checkMesh(given, kMaxMeasured);
    const std::optional<TriangleMesh> used = withoutUnusedVertices(given);
    const TriangleMesh& mesh = used ? *used : given;
    bool is_closed = false;
    std::shared_ptr<MeshTree> tree;
    std::optional<ConvexHull> hull;
    const auto makeTree = [&] {
      is_closed = closedSurface(mesh).has_value();
      if (refine != RefineGeometry::hull) {
        tree = std::make_shared<MeshTree>(is_closed ? MeshTree(mesh, true) : treeOfOpen(mesh));
      }
    };
    const auto makeHull = [&] { hull.emplace(mesh.vertices); };
    doBoth(mesh.triangles.size() >= kManyTriangles, makeTree, makeHull);
    const bool is_convex = is_closed && isSurfaceOf(mesh, *hull);
    if (tree == nullptr && is_convex) {
      tree = std::make_shared<MeshTree>(mesh, true);
    }
    if (tree != nullptr && hull->hasVolume()) {
      tree->setHull(hull->faces());
    }
    element.is_exact = tree != nullptr;
    element.mesh = tree != nullptr
                       ? std::move(tree)
                       : std::make_shared<MeshTree>(convexHullOf(mesh.vertices), hull->hasVolume());
    const bool stands_for_it = is_convex || refine == RefineGeometry::hull;
    (stands_for_it ? element.convex : element.hull) = std::move(*hull);
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

void fillElement(const TriangleMesh& mesh, RefineGeometry refine, Element& element) {
  FillElement{refine, element}(mesh);
}

void fillAs(const Element& other, Element& element) {
  element.convex = other.convex;
  element.mesh = other.mesh;
  element.hull = other.hull;
  element.mesh_excess = other.mesh_excess;
  element.is_exact = other.is_exact;
}

}  // namespace collision_monitor
