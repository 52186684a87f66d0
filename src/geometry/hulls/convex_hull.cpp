// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/hulls/convex_hull.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

#include "geometry/hulls/planar_hull.h"
#include "geometry/hulls/run_qhull.h"

namespace collision_monitor {
namespace {

using Points = std::vector<Eigen::Vector3d>;

constexpr double kFlatness = 1e-12;
constexpr std::uint32_t kUnseen = std::numeric_limits<std::uint32_t>::max();

void checkPoints(const Points& points) {
  if (points.empty()) {
    throw std::invalid_argument("convex hull: no points; at least one is needed");
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].allFinite()) {
      throw std::invalid_argument("convex hull: point " + std::to_string(i) +
                                  " is not finite; every coordinate must be");
    }
  }
}

/// The index of the point with the largest `measure`, and that value.
template <class Measure>
std::pair<std::uint32_t, double> farthest(const Points& points, const Measure& measure) {
  std::pair<std::uint32_t, double> best{0, -1.0};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double value = measure(points[i]);
    if (value > best.second) {
      best = {static_cast<std::uint32_t>(i), value};
    }
  }
  return best;
}

/// Four points, chosen greedily to span as much as they can. `dimension` tells how many count.
struct Simplex {
  std::uint32_t corners[4] = {0, 0, 0, 0};
  int dimension{0};
  Eigen::Vector3d normal{Eigen::Vector3d::Zero()};  ///< of the plane through the first three
};

Simplex spanningSimplex(const Points& points, double extent) {
  Simplex simplex;
  const auto add = [&](const auto& measure) {
    const auto [corner, value] = farthest(points, measure);
    if (!(value > kFlatness * extent)) {
      return false;
    }
    simplex.corners[++simplex.dimension] = corner;
    return true;
  };
  simplex.corners[0] =
      farthest(points, [&](const auto& p) { return (p - points[0]).norm(); }).first;
  const Eigen::Vector3d origin = points[simplex.corners[0]];
  if (!add([&](const auto& p) { return (p - origin).norm(); })) {
    return simplex;
  }
  const Eigen::Vector3d line = (points[simplex.corners[1]] - origin).normalized();
  if (!add([&](const auto& p) { return (p - origin).cross(line).norm(); })) {
    return simplex;
  }
  simplex.normal = line.cross(points[simplex.corners[2]] - origin).normalized();
  add([&](const auto& p) { return std::abs((p - origin).dot(simplex.normal)); });
  return simplex;
}

/// Keeps each point that triangles use, once.
TriangleMesh compact(const Points& points, const std::vector<std::array<std::uint32_t, 3>>& faces) {
  TriangleMesh mesh;
  std::vector<std::uint32_t> new_index(points.size(), kUnseen);
  mesh.triangles = faces;
  for (auto& face : mesh.triangles) {
    for (auto& corner : face) {
      if (new_index[corner] == kUnseen) {
        new_index[corner] = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.push_back(points[corner]);
      }
      corner = new_index[corner];
    }
  }
  return mesh;
}

TriangleMesh distinctPoints(Points points) {
  const auto before = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
  };
  std::sort(points.begin(), points.end(), before);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return {std::move(points), {}};
}

}  // namespace

TriangleMesh convexHullOf(const Points& points) {
  checkPoints(points);
  Eigen::Vector3d low = points[0];
  Eigen::Vector3d high = points[0];
  for (const auto& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double extent = (0.5 * high - 0.5 * low).maxCoeff();
  const Simplex simplex = spanningSimplex(points, extent);
  if (simplex.dimension < 2) {
    TriangleMesh mesh;
    for (int i = 0; i <= simplex.dimension; ++i) {
      mesh.vertices.push_back(points[simplex.corners[i]]);
    }
    return mesh;
  }
  if (simplex.dimension == 2) {
    return compact(points, planarHull(points, simplex.normal));
  }
  const auto faces = runQhull(points, 0.5 * low + 0.5 * high, extent);
  // The distinct points enclose as much as their hull does, so a failure only costs speed.
  return faces.empty() ? distinctPoints(points) : compact(points, faces);
}

}  // namespace collision_monitor
