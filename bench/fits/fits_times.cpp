// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <map>
#include <vector>

#include "collision_monitor/fitting/enclose.h"
#include "collision_monitor/fitting/inner_shape.h"
#include "collision_monitor/model/urdf_reader.h"
#include "collision_monitor/pipeline/fit_links.h"
#include "collision_monitor/pipeline/setup.h"
#include "fits_tables.h"
#include "fitting/sphere_trees/build_sphere_tree.h"
#include "support/robots/file_loader.h"

namespace collision_monitor::test {
namespace {

/// A closed ball with bumps, from the faces of a cube in n x n squares: 12 n^2 triangles.
TriangleMesh bumpyBall(int n) {
  TriangleMesh mesh;
  std::map<std::array<int, 3>, std::uint32_t> known;
  const auto vertexAt = [&](const std::array<int, 3>& node) {
    const auto [place, is_new] =
        known.emplace(node, static_cast<std::uint32_t>(mesh.vertices.size()));
    if (is_new) {
      const Eigen::Vector3d u =
          Eigen::Vector3d(2 * node[0] - n, 2 * node[1] - n, 2 * node[2] - n).normalized();
      const double bumps =
          std::sin(9.0 * u.x() + 2.0) * std::sin(7.0 * u.y()) * std::cos(8.0 * u.z());
      mesh.vertices.emplace_back((1.0 + 0.05 * bumps) *
                                 u.cwiseProduct(Eigen::Vector3d(0.5, 0.35, 0.3)));
    }
    return place->second;
  };
  for (int face = 0; face < 6; ++face) {
    const auto k = static_cast<std::size_t>(face / 2);
    for (int i = 0; i < n * n; ++i) {
      const auto corner = [&](int a, int b) {
        std::array<int, 3> node{};
        node[k] = face % 2 == 0 ? 0 : n;
        node[(k + 1) % 3] = i / n + (face % 2 == 0 ? b : a);
        node[(k + 2) % 3] = i % n + (face % 2 == 0 ? a : b);
        return vertexAt(node);
      };
      mesh.triangles.push_back({corner(0, 0), corner(1, 0), corner(1, 1)});
      mesh.triangles.push_back({corner(0, 0), corner(1, 1), corner(0, 1)});
    }
  }
  return mesh;
}

/// The median processor time of five runs: other programs do not count.
double medianTime(const std::function<void()>& work) {
  std::vector<double> times;
  for (int i = 0; i < 5; ++i) {
    const std::clock_t start = std::clock();
    work();
    times.push_back(1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
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
    printTimes("ball with bumps", bumpyBall(65));
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
