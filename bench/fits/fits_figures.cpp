// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <map>
#include <stdexcept>
#include <string>

#include "collision_monitor/fitting/fit_parts.h"
#include "fits_long_search.h"
#include "fits_solids.h"
#include "fits_tables.h"
#include "support/reference/extended_distance.h"

// Prints tables with tabs for bench/figures/fits.py: a row of names, then one row per link or mesh.
// Lengths in millimetres, times in milliseconds.
//   links URDF DIRECTORY ROOT             what the fits miss and overshoot
//   ratios URDF DIRECTORY ROOT STARTS     volumes against a long search
//   times URDF DIRECTORY ROOT TRIANGLES   of meshes with at least so many; "-" for the URDF: bumps
//   load URDF DIRECTORY ROOT              reading and fitting with the default limits
//   brute URDF DIRECTORY ROOT TRIANGLES   overshoot by brute force, of meshes with at most so many
//   published URDF DIRECTORY ROOT MODEL   against a model: a URDF of primitives, links of same name
// DIRECTORY is where relative names of meshes start, ROOT is where package:// starts.
namespace collision_monitor::test {
namespace {

constexpr double kMillimetres = 1e3;
constexpr int kSamples = 2000;
constexpr int kMostShapes = 16;

std::vector<Fit> fitLink(const Link& link, std::uint32_t max_shapes) {
  std::vector<Geometry> geometries;
  for (const auto& element : link.collisions) {
    geometries.push_back(element.geometry);
  }
  return fitGeometries(geometries, {max_shapes, 0.0, {}});
}

/// The number of an element's points that are in none of its shapes, by extended precision.
std::size_t countOutside(const Fit& fit, const Points& points) {
  return static_cast<std::size_t>(std::count_if(points.begin(), points.end(), [&](const auto& p) {
    return std::none_of(fit.shapes.begin(), fit.shapes.end(), [&](const Enclosure& enclosure) {
      return extendedDistance(enclosure.shape, enclosure.geometry_from_body, p) <= 0.0L;
    });
  }));
}

Points pointsOf(const Geometry& geometry) {
  if (const auto* mesh = std::get_if<TriangleMesh>(&geometry)) {
    return densePoints(*mesh);
  }
  Points points;
  for (const auto& sample : samplesOf(toSolid(geometry, Pose()), kSamples)) {
    points.push_back(sample.point);
  }
  return points;
}

struct LinkSums {
  std::size_t shapes{0}, outside_vertices{0}, outside_points{0};
  double widening{0.0}, overshoot{0.0};
};

LinkSums sumUp(const Link& link, const std::vector<Fit>& fits, const std::vector<Points>& points) {
  LinkSums sums;
  for (std::size_t i = 0; i < fits.size(); ++i) {
    sums.shapes += fits[i].shapes.size();
    sums.overshoot = std::max(sums.overshoot, fits[i].overshoot.max);
    for (const auto& enclosure : fits[i].shapes) {
      sums.widening = std::max(sums.widening, enclosure.widening);
    }
    if (fits[i].shapes.front().is_exact) {
      continue;
    }
    sums.outside_points += countOutside(fits[i], points[i]);
    if (const auto* mesh = std::get_if<TriangleMesh>(&link.collisions[i].geometry)) {
      sums.outside_vertices += countOutside(fits[i], mesh->vertices);
    }
  }
  return sums;
}

void printLinks(const Arguments& arguments) {
  std::printf("link\tmeshes\tvertices\tpoints");
  for (const int n : {1, 8}) {
    std::printf("\tshapes_%d\toutside_%d\tpoints_outside_%d\twidening_%d\tovershoot_%d", n, n, n, n,
                n);
  }
  std::printf("\n");
  for (const auto& link : readModel(arguments).links) {
    if (link.collisions.empty()) {
      continue;
    }
    std::vector<Points> points;
    std::size_t meshes = 0, vertices = 0, count = 0;
    for (const auto& element : link.collisions) {
      const auto* mesh = std::get_if<TriangleMesh>(&element.geometry);
      meshes += mesh != nullptr ? 1 : 0;
      vertices += mesh != nullptr ? mesh->vertices.size() : 0;
      points.push_back(pointsOf(element.geometry));
      count += points.back().size();
    }
    std::printf("%s\t%zu\t%zu\t%zu", link.name.c_str(), meshes, vertices, count);
    for (const std::uint32_t n : {1u, 8u}) {
      const LinkSums sums = sumUp(link, fitLink(link, n), points);
      std::printf("\t%zu\t%zu\t%zu\t%.3e\t%.3f", sums.shapes, sums.outside_vertices,
                  sums.outside_points, kMillimetres * sums.widening, kMillimetres * sums.overshoot);
    }
    std::printf("\n");
    std::fflush(stdout);
  }
}

void printRatios(const Arguments& arguments) {
  std::printf("link\tcapsule\tbox\trounded_box\trounded_over_others\n");
  forMeshes(readModel(arguments), [&](const std::string& name, const TriangleMesh& mesh) {
    const VolumeRatios ratios = compareVolumes(mesh, arguments.number());
    std::printf("%s\t%.6f\t%.6f\t%.6f\t%.12f\n", name.c_str(), ratios.capsule, ratios.box,
                ratios.rounded_box, ratios.rounded_over_others);
    std::fflush(stdout);
  });
}

void printBrute(const Arguments& arguments) {
  std::printf("link\tmax_shapes\tours\tbrute\tspacing\n");
  forMeshes(readModel(arguments), [&](const std::string& name, const TriangleMesh& mesh) {
    if (mesh.triangles.empty() ||
        mesh.triangles.size() > static_cast<std::size_t>(arguments.number())) {
      return;
    }
    Link link;
    link.collisions.push_back({name, Pose(), mesh});
    for (const std::uint32_t n : {1u, 8u}) {
      const std::vector<Fit> fits = fitLink(link, n);
      const std::vector<Solid> solids = toSolids(link, fits);
      // Between the samples of the fits' own measure: 600 per shape.
      double spacing = 0.0;
      for (const auto& solid : solids) {
        double area = 0.0;
        for (const auto& sample : samplesOf(solid, kSamples)) {
          area += sample.area;
        }
        spacing = std::max(spacing, std::sqrt(area / 600.0));
      }
      std::printf("%s\t%u\t%.3f\t%.3f\t%.3f\n", name.c_str(), n,
                  kMillimetres * fits.front().overshoot.max,
                  kMillimetres * bruteOvershoot(solids, TriangleBvh(mesh), kSamples),
                  kMillimetres * spacing);
      std::fflush(stdout);
    }
  });
}

void printComparison(const Link& link, const std::vector<Solid>& theirs) {
  const TriangleMesh mesh = meshOf(link);
  const TriangleBvh surface(mesh);
  const double miss_vertices = missOf(theirs, mesh.vertices);
  const double miss = missOf(theirs, densePoints(mesh));
  // Grown by the greatest miss of its vertices, the least growth that encloses.
  std::vector<Solid> grown = theirs;
  for (auto& solid : grown) {
    solid.radius += miss_vertices;
  }
  const auto count = std::min(static_cast<int>(theirs.size()), kMostShapes);
  const std::vector<Solid> ours = toSolids(link, fitLink(link, static_cast<std::uint32_t>(count)));
  const auto tell = [&](const std::vector<Solid>& solids) {
    const Overshoot overshoot = overshootOf(solids, surface, kSamples);
    std::printf("\t%.3f\t%.3f", kMillimetres * overshoot.max, kMillimetres * overshoot.mean);
  };
  std::printf("%s\t%zu\t%zu\t%.3f\t%.3f", link.name.c_str(), theirs.size(), ours.size(),
              kMillimetres * miss_vertices, kMillimetres * miss);
  tell(theirs);
  tell(grown);
  tell(ours);
  std::printf("\n");
  std::fflush(stdout);
}

void printPublished(const Arguments& arguments) {
  std::printf(
      "link\tshapes\tours_shapes\tmiss_vertices\tmiss_points\tmax\tmean\tgrown_max\tgrown_mean");
  std::printf("\tours_max\tours_mean\n");
  const RobotModel robot = readModel(arguments);
  for (const auto& model_link : readModel({arguments.option, "", "", ""}).links) {
    std::vector<Solid> solids;
    for (const auto& element : model_link.collisions) {
      solids.push_back(toSolid(element.geometry, element.link_from_geometry));
    }
    const auto id = robot.findLink(model_link.name);
    if (id && !solids.empty() && !meshOf(robot.link(*id)).triangles.empty()) {
      printComparison(robot.link(*id), solids);
    }
  }
}

void run(int argc, char** argv) {
  const std::map<std::string, std::pair<int, void (*)(const Arguments&)>> commands{
      {"links", {5, printLinks}}, {"ratios", {6, printRatios}}, {"times", {6, printTimes}},
      {"load", {5, printLoad}},   {"brute", {6, printBrute}},   {"published", {6, printPublished}}};
  const auto command = argc > 1 ? commands.find(argv[1]) : commands.end();
  if (command == commands.end() || argc != command->second.first) {
    throw std::invalid_argument("a command and its arguments are accepted; see the source");
  }
  command->second.second({argv[2], argv[3], argv[4], argc > 5 ? argv[5] : ""});
}

}  // namespace
}  // namespace collision_monitor::test

int main(int argc, char** argv) {
  try {
    collision_monitor::test::run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "fits_figures: %s\n", error.what());
    return 1;
  }
  return 0;
}
