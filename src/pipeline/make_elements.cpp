// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <stdexcept>
#include <string>

#include "collision_monitor/geometry/convex_hull.h"
#include "collision_monitor/geometry/interruption.h"
#include "fitting/closed_surface.h"
#include "fitting/surrounding_mesh.h"
#include "pipeline/convex_mesh.h"
#include "pipeline/open_meshes.h"
#include "setup_parts.h"

namespace collision_monitor {
namespace {

struct MakeConvex {
  ConvexGeometry operator()(const Sphere& s) const { return s; }
  ConvexGeometry operator()(const Capsule& s) const { return s; }
  ConvexGeometry operator()(const Box& s) const { return s; }
  ConvexGeometry operator()(const RoundedBox& s) const { return s; }
};

/// The mesh with its stray vertices as triangles of one point: what encloses it encloses them.
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

/// Fills in what an element is, from the geometry of the URDF.
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
    element.mesh.emplace(around, true);
    element.mesh_excess = reach - cylinder.radius;
    element.is_exact = true;
  }

  void operator()(const TriangleMesh& mesh) const {
    const TriangleMesh whole = withStrayVertices(mesh);
    const bool is_closed = closedSurface(mesh).has_value();
    ConvexHull hull(mesh.vertices);
    const bool is_convex =
        is_closed && whole.triangles.size() == mesh.triangles.size() && isSurfaceOf(mesh, hull);
    if (refine == RefineGeometry::hull && !is_convex) {
      element.mesh.emplace(convexHullOf(mesh.vertices), hull.hasVolume());
    } else {
      element.mesh.emplace(is_closed ? MeshTree(whole, true) : treeOfOpen(whole));
      element.is_exact = true;
    }
    const bool stands_for_it = is_convex || refine == RefineGeometry::hull;
    (stands_for_it ? element.convex : element.hull) = std::move(hull);
  }

  void operator()(const Box& box) const {
    element.convex = box;
    element.mesh.emplace(surroundingMesh(box), box.half_extents.minCoeff() > 0.0);
    element.is_exact = true;
  }

  template <class Primitive>
  void operator()(const Primitive& primitive) const {
    element.convex = primitive;
    element.is_exact = true;
  }
};

/// A body's shape where no geometry is to stand behind it.
void addShape(std::size_t body, CycleSetup& setup) {
  Element element;
  element.link = setup.bodies[body].link;
  element.name = setup.labels[body].shape_name;
  element.link_from_element = setup.bodies[body].link_from_body;
  element.convex = std::visit(MakeConvex{}, setup.bodies[body].shape);
  element.is_body = true;
  setup.bodies[body].element = idAt<ElementId>(setup.elements.size());
  setup.elements.push_back(std::move(element));
}

/// One element of the URDF, which the bodies [first, last) enclose.
void addGeometry(const CollisionElement& collision, const FillElement& how, std::size_t first,
                 std::size_t last, CycleSetup& setup) {
  Element& element = how.element;
  element.name = collision.name;
  element.link_from_element = collision.link_from_geometry;
  std::visit(how, collision.geometry);
  if (element.is_exact) {
    element.inner = inscribeShapes(collision.geometry);
  }
  element.is_body = last == first + 1 && setup.bodies[first].is_exact;
  for (std::size_t body = first; body < last; ++body) {
    setup.bodies[body].element = idAt<ElementId>(setup.elements.size());
  }
  setup.elements.push_back(std::move(element));
}

void addShapes(std::size_t first, std::size_t last, CycleSetup& setup) {
  for (std::size_t body = first; body < last; ++body) {
    addShape(body, setup);
  }
}

void warnOfOpenMeshes(const CycleSetup& setup, SetupReport& report) {
  OpenMeshes open;
  for (const Element& element : setup.elements) {
    if (element.mesh && element.is_exact) {
      open.look(setup.model.link(element.link).name, element.name, *element.mesh);
    }
  }
  if (const std::optional<Problem> warning = open.warning()) {
    report.warnings.push_back(*warning);
  }
}

}  // namespace

void makeElements(const std::vector<LinkFit>& fits, const ElementSettings& settings,
                  CycleSetup& setup, SetupReport& report) {
  std::size_t body = 0;
  for (const LinkFit& fit : fits) {
    const Link& link = setup.model.link(fit.link);
    const RefineGeometry refine = settings.refineFor(fit.link);
    addShapes(body, body + fit.given.size(), setup);
    body += fit.given.size();
    for (std::size_t i = 0; i < fit.fits.size(); ++i) {
      throwIfInterrupted();
      const std::size_t first = body;
      body += fit.fits[i].shapes.size();
      if (refine == RefineGeometry::none && !setup.bodies[first].is_exact) {
        addShapes(first, body, setup);
        continue;
      }
      try {
        Element element;
        element.link = fit.link;
        element.padding = fit.padding;
        addGeometry(link.collisions[i], {refine, element}, first, body, setup);
      } catch (const std::invalid_argument& fault) {
        report.warnings.push_back(
            {"link '" + link.name + "', collision '" + link.collisions[i].name + "'", fault.what(),
             "", "its enclosing shapes stand for it"});
        addShapes(first, body, setup);
      }
    }
  }
  warnOfOpenMeshes(setup, report);
}

}  // namespace collision_monitor
