// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/geometry/hull.h"

#include <algorithm>
#include <set>
#include <utility>

#include "collision_monitor/geometry/convex_hull.h"
#include "geometry/hull_faces.h"

namespace collision_monitor {
namespace {

constexpr std::size_t kFewVertices = 24;  // as many cost no more than a climb
// A climb stops where no neighbour gains more than rounding, about 1e-16 of the extent; along an
// edge this short that is a slope of 1e-11, which the rest of the hull might exploit.
constexpr double kShortEdge = 1e-5;
constexpr std::uint32_t kNowhere = 0xffffffffU;

double extentOf(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Vector3d low = points[0];
  Eigen::Vector3d high = points[0];
  for (const auto& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  return (high - low).maxCoeff();
}

std::set<std::pair<std::uint32_t, std::uint32_t>> neighboursOf(const TriangleMesh& mesh) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (const auto& corners : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      pairs.insert({corners[k], corners[(k + 1) % 3]});
      pairs.insert({corners[(k + 1) % 3], corners[k]});
    }
  }
  return pairs;
}

}  // namespace

ConvexHull::ConvexHull(const std::vector<Eigen::Vector3d>& points) {
  const TriangleMesh mesh = convexHullOf(points);
  vertices_ = mesh.vertices;
  for (const auto& vertex : vertices_) {
    bounding_radius_ = std::max(bounding_radius_, vertex.norm());
  }
  const double extent = extentOf(vertices_);
  HullFaces gathered = gatherFaces(mesh, extent);
  faces_ = std::move(gathered.faces);
  edges_ = std::move(gathered.edges);
  has_volume_ = faces_.size() >= 4;

  climbs_ = vertices_.size() > kFewVertices && !mesh.triangles.empty();
  first_neighbour_.assign(vertices_.size() + 1, 0);
  for (const auto& [from, to] : neighboursOf(mesh)) {
    neighbours_.push_back(to);
    first_neighbour_[from + 1] = static_cast<std::uint32_t>(neighbours_.size());
    climbs_ = climbs_ && (vertices_[to] - vertices_[from]).norm() > kShortEdge * extent;
  }
}

std::uint32_t ConvexHull::climb(const Eigen::Vector3d& direction,
                                std::uint32_t start) const noexcept {
  std::uint32_t best = start;
  double farthest = direction.dot(vertices_[start]);
  for (std::uint32_t at = kNowhere; at != best;) {
    at = best;
    const std::uint32_t end = first_neighbour_[at + 1];
    for (std::uint32_t k = first_neighbour_[at]; k < end; ++k) {
      const double reach = direction.dot(vertices_[neighbours_[k]]);
      if (reach > farthest) {
        farthest = reach;
        best = neighbours_[k];
      }
    }
  }
  return best;
}

std::uint32_t ConvexHull::lookAtAll(const Eigen::Vector3d& direction) const noexcept {
  std::uint32_t best = 0;
  double farthest = direction.dot(vertices_[0]);
  for (std::uint32_t i = 1; i < vertices_.size(); ++i) {
    const double reach = direction.dot(vertices_[i]);
    if (reach > farthest) {
      farthest = reach;
      best = i;
    }
  }
  return best;
}

}  // namespace collision_monitor
