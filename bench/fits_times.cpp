// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <vector>

#include "collision_monitor/fitting/build_sphere_tree.h"
#include "collision_monitor/fitting/enclose.h"
#include "collision_monitor/fitting/inner_shape.h"
#include "collision_monitor/model/urdf_reader.h"
#include "collision_monitor/pipeline/fit_links.h"
#include "collision_monitor/pipeline/setup.h"
#include "fits_tables.h"
#include "support/file_loader.h"
#include "support/query_meshes.h"

namespace collision_monitor::test {
namespace {

/// The median of five runs.
double medianTime(const std::function<void()>& work) {
  std::vector<double> times;
  for (int i = 0; i < 5; ++i) {
    const auto start = std::chrono::steady_clock::now();
    work();
    const auto end = std::chrono::steady_clock::now();
    times.push_back(std::chrono::duration<double, std::milli>(end - start).count());
  }
  std::sort(times.begin(), times.end());
  return times[2];
}

void printTimes(const std::string& name, const TriangleMesh& mesh) {
  const Geometry geometry = mesh;
  const double fit = medianTime([&] { encloseTightly(geometry); });
  const double tree = medianTime([&] { buildSphereTree(geometry, SphereTreeLimits{}); });
  const double inner = medianTime([&] { inscribeShapes(geometry); });
  const bool has_inside = inscribeShapes(geometry).sphere.has_value();
  std::printf("%s\t%zu\t%.1f\t%.1f\t%.1f\t%d\n", name.c_str(), mesh.triangles.size(), fit, tree,
              inner, has_inside ? 1 : 0);
  std::fflush(stdout);
}

}  // namespace

RobotModel readModel(const Arguments& arguments) {
  RobotDescription description;
  description.source = arguments.urdf;
  description.urdf_xml = readFile(arguments.urdf);
  description.directory = arguments.directory;
  SetupReport report;
  RobotModel model = readRobots({description}, fileLoader(arguments.root), report);
  throwIfErrors(report);
  return model;
}

void forMeshes(const RobotModel& model,
               const std::function<void(const std::string&, const TriangleMesh&)>& visit) {
  for (const auto& link : model.links) {
    for (const auto& element : link.collisions) {
      if (const auto* mesh = std::get_if<TriangleMesh>(&element.geometry)) {
        visit(link.name, *mesh);
      }
    }
  }
}

void printTimes(const Arguments& arguments) {
  std::printf("mesh\ttriangles\tfit\tsphere_tree\tinner_shapes\thas_inside\n");
  if (arguments.urdf == "-") {
    printTimes("bumps", bumpyMesh(1.0, 224));
    return;
  }
  forMeshes(readModel(arguments), [&](const std::string& name, const TriangleMesh& mesh) {
    if (mesh.triangles.size() >= static_cast<std::size_t>(arguments.number())) {
      printTimes(name, mesh);
    }
  });
}

void printLoad(const Arguments& arguments) {
  std::size_t shapes = 0;
  const double time = medianTime([&] {
    const RobotModel model = readModel(arguments);
    SetupReport report;
    FitSettings settings;
    settings.limits = SetupOptions().default_limits;
    shapes = 0;
    for (const auto& link : fitLinks(model, settings, {}, report)) {
      for (const auto& fit : link.fits) {
        shapes += fit.shapes.size();
      }
    }
  });
  std::printf("time\tshapes\n%.1f\t%zu\n", time, shapes);
}

}  // namespace collision_monitor::test
