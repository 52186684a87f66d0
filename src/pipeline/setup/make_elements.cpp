// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <stdexcept>
#include <string>

#include "geometry/all_cores.h"
#include "geometry/interruption.h"
#include "narrow_phase/mesh_inside/mesh_openness.h"
#include "pipeline/fits/open_meshes.h"
#include "pipeline/fits/prove_inner.h"
#include "pipeline/setup/fill_element.h"
#include "setup_parts.h"

namespace collision_monitor {
namespace {

struct MakeConvex {
  ConvexGeometry operator()(const Sphere& s) const { return s; }
  ConvexGeometry operator()(const Capsule& s) const { return s; }
  ConvexGeometry operator()(const Box& s) const { return s; }
  ConvexGeometry operator()(const RoundedBox& s) const { return s; }
};

/// Makes an element of a body's shape, where the rules leave no geometry.
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

/// An element of the URDF that the bodies [first, last) enclose, or these bodies alone.
struct ElementTask {
  const CollisionElement* collision;
  const Fit* fit;
  RefineGeometry refine;
  bool has_geometry;
  std::size_t first;
  std::size_t last;
  LinkId link;
  Element element;
  double openness;    ///< of its mesh; 0 if the mesh is closed or not used
  std::string fault;  ///< why the geometry cannot be used
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

bool areSame(const Geometry& a, const Geometry& b) {
  const auto* mesh_a = std::get_if<TriangleMesh>(&a);
  const auto* mesh_b = std::get_if<TriangleMesh>(&b);
  return mesh_a != nullptr && mesh_b != nullptr && mesh_a->vertices == mesh_b->vertices &&
         mesh_a->triangles == mesh_b->triangles;
}

/// By task: the first task of the same mesh, which is made once for all. Arms or legs are often the
/// same.
std::vector<std::size_t> firstAlike(const std::vector<ElementTask>& tasks) {
  std::vector<std::size_t> first(tasks.size());
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    first[i] = 0;
    while (first[i] < i &&
           !(tasks[i].has_geometry && tasks[first[i]].has_geometry &&
             tasks[i].refine == tasks[first[i]].refine &&
             areSame(tasks[i].collision->geometry, tasks[first[i]].collision->geometry))) {
      ++first[i];
    }
  }
  return first;
}

/// Keeps the fault of a geometry instead of throwing it.
template <class Work>
void tryTo(const Work& work, ElementTask& task) {
  try {
    work(task);
  } catch (const std::invalid_argument& fault) {
    task.fault = fault.what();
  }
}

void makeGeometry(ElementTask& task) {
  fillElement(task.collision->geometry, task.refine, task.element);
}

/// Adds what also depends on the fit.
void complete(ElementTask& task) {
  Element& element = task.element;
  if (element.is_exact) {
    element.inner =
        innerShapes(task.collision->geometry, *task.fit, element.mesh ? &*element.mesh : nullptr);
    if (element.mesh && element.mesh->openSurface()) {
      task.openness = task.fit->openness ? *task.fit->openness : opennessOf(*element.mesh);
    }
  }
}

void makeAll(std::vector<ElementTask>& tasks) {
  const std::vector<std::size_t> first = firstAlike(tasks);
  forEachOnAllCores(tasks.size(), [&](std::size_t i) {
    throwIfInterrupted();
    if (tasks[i].has_geometry && first[i] == i) {
      tryTo(makeGeometry, tasks[i]);
    }
  });
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    tasks[i].fault = tasks[first[i]].fault;
  }
  forEachOnAllCores(tasks.size(), [&](std::size_t i) {
    if (first[i] != i) {
      fillAs(tasks[first[i]].element, tasks[i].element);
    }
    if (tasks[i].has_geometry && tasks[i].fault.empty()) {
      tryTo(complete, tasks[i]);
    }
  });
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

/// Adds the tasks of a link, whose bodies follow its given ones.
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
  makeAll(tasks);
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
