// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <stdexcept>
#include <string>

#include "collision_monitor/geometry/convex_hull.h"
#include "collision_monitor/geometry/interruption.h"
#include "collision_monitor/narrow_phase/mesh_openness.h"
#include "fitting/closed_surface.h"
#include "fitting/surrounding_mesh.h"
#include "geometry/all_cores.h"
#include "pipeline/convex_mesh.h"
#include "pipeline/open_meshes.h"
#include "pipeline/prove_inner.h"
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

/// One element of the URDF, which the bodies [first, last) enclose; or those alone.
struct ElementTask {
  const CollisionElement* collision;
  const Fit* fit;
  RefineGeometry refine;
  bool has_geometry;
  std::size_t first;
  std::size_t last;
  LinkId link;
  Element element;
  double openness;    ///< of its mesh; 0 where that is closed or stands for nothing
  std::string fault;  ///< why the geometry is of no use
};

InnerShapes innerShapes(const Geometry& geometry, const Fit& fit, const MeshTree* tree) {
  if (std::holds_alternative<TriangleMesh>(geometry)) {
    const bool are_known = fit.inner.sphere || fit.inner.capsule;
    if (are_known ? areInside(fit.inner, *tree) : !tree->isClosed()) {
      return fit.inner;
    }
  }
  return inscribeShapes(geometry);
}

void makeElement(ElementTask& task) {
  const Geometry& geometry = task.collision->geometry;
  Element& element = task.element;
  try {
    std::visit(FillElement{task.refine, element}, geometry);
    if (element.is_exact) {
      element.inner = innerShapes(geometry, *task.fit, element.mesh ? &*element.mesh : nullptr);
      if (element.mesh && element.mesh->openSurface()) {
        task.openness = task.fit->openness ? *task.fit->openness : opennessOf(*element.mesh);
      }
    }
  } catch (const std::invalid_argument& fault) {
    task.fault = fault.what();
  }
}

void addGeometry(ElementTask& task, CycleSetup& setup) {
  Element& element = task.element;
  element.name = task.collision->name;
  element.link_from_element = task.collision->link_from_geometry;
  element.is_body = task.last == task.first + 1 && setup.bodies[task.first].is_exact;
  for (std::size_t body = task.first; body < task.last; ++body) {
    setup.bodies[body].element = idAt<ElementId>(setup.elements.size());
  }
  setup.elements.push_back(std::move(element));
}

void addShapes(std::size_t first, std::size_t last, CycleSetup& setup) {
  for (std::size_t body = first; body < last; ++body) {
    addShape(body, setup);
  }
}

/// Those of a link, behind the bodies that were given to it.
void addTasks(const LinkFit& fit, const Link& link, RefineGeometry refine, std::size_t& body,
              const CycleSetup& setup, std::vector<ElementTask>& tasks) {
  for (std::size_t i = 0; i < fit.fits.size(); ++i) {
    const std::size_t first = body;
    body += fit.fits[i].shapes.size();
    const bool has_geometry = refine != RefineGeometry::none || setup.bodies[first].is_exact;
    Element element;
    element.link = fit.link;
    element.padding = fit.padding;
    tasks.push_back({&link.collisions[i],
                     &fit.fits[i],
                     refine,
                     has_geometry,
                     first,
                     body,
                     fit.link,
                     std::move(element),
                     0.0,
                     {}});
  }
}

void warnOfOpenMeshes(const std::vector<ElementTask>& tasks, const CycleSetup& setup,
                      SetupReport& report) {
  OpenMeshes open;
  for (const ElementTask& task : tasks) {
    if (task.openness > 0.0) {
      open.look(setup.model.link(task.link).name, task.collision->name, task.openness);
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
  std::vector<ElementTask> tasks;
  for (const LinkFit& fit : fits) {
    const Link& link = setup.model.link(fit.link);
    if (!fit.given.empty()) {
      ElementTask given{};
      given.first = body;
      given.last = body += fit.given.size();
      tasks.push_back(std::move(given));
    }
    addTasks(fit, link, settings.refineFor(fit.link), body, setup, tasks);
  }
  forEachOnAllCores(tasks.size(), [&](std::size_t i) {
    throwIfInterrupted();
    if (tasks[i].has_geometry) {
      makeElement(tasks[i]);
    }
  });
  for (ElementTask& task : tasks) {
    if (task.has_geometry && task.fault.empty()) {
      addGeometry(task, setup);
      continue;
    }
    if (task.has_geometry) {
      report.warnings.push_back({"link '" + setup.model.link(task.link).name + "', collision '" +
                                     task.collision->name + "'",
                                 task.fault, "", "its enclosing shapes stand for it"});
    }
    addShapes(task.first, task.last, setup);
  }
  warnOfOpenMeshes(tasks, setup, report);
}

}  // namespace collision_monitor
