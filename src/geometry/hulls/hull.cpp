// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/geometry/hull.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/bvh/vertex_blocks.h"
#include "geometry/hulls/convex_hull.h"
#include "geometry/hulls/hull_faces.h"
#include "geometry/hulls/hull_graph.h"

namespace collision_monitor {
namespace {

constexpr std::size_t kFewVertices = 24;    // testing these costs no more than a climb
constexpr std::size_t kManyVertices = 128;  // up to these, climbs cost no more than a map
double extentOf(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Vector3d low = points[0];
  Eigen::Vector3d high = points[0];
  for (const auto& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  return (high - low).maxCoeff();
}

// Appends one list to all lists and notes where it ends.
void append(const std::vector<std::uint32_t>& list, std::vector<std::uint32_t>& all,
            std::vector<std::uint32_t>& ends) {
  all.insert(all.end(), list.begin(), list.end());
  ends.push_back(static_cast<std::uint32_t>(all.size()));
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
  addRings(gathered.rings);
  addFans(neighboursToClimb(mesh, extent));
  climbs_ = canClimb() && vertices_.size() > kFewVertices;
  if (climbs_ && vertices_.size() > kManyVertices) {
    mapDirections();
  }
}

void ConvexHull::addRings(const std::vector<std::vector<std::uint32_t>>& rings) {
  std::vector<std::vector<std::uint32_t>> faces_at(vertices_.size());
  first_corner_.push_back(0);
  for (std::uint32_t face = 0; face < rings.size(); ++face) {
    append(rings[face], ring_corners_, first_corner_);
    for (const std::uint32_t corner : rings[face]) {
      faces_at[corner].push_back(face);
    }
  }
  first_face_at_.push_back(0);
  for (const std::vector<std::uint32_t>& faces : faces_at) {
    append(faces, faces_at_, first_face_at_);
  }
}

void ConvexHull::addFans(const std::vector<std::vector<std::uint32_t>>& neighbours) {
  first_fan_.push_back(0);
  for (const std::vector<std::uint32_t>& around : neighbours) {
    for (std::size_t first = 0; first < around.size(); first += Fan::kSize) {
      Fan fan;
      for (std::size_t i = 0; i < Fan::kSize; ++i) {
        fan.vertex[i] = around[first + i < around.size() ? first + i : first];
        const auto column = static_cast<Eigen::Index>(i);
        const Eigen::Vector3d& point = vertices_[fan.vertex[i]];
        fan.x[column] = point.x();
        fan.y[column] = point.y();
        fan.z[column] = point.z();
      }
      fans_.push_back(fan);
    }
    first_fan_.push_back(static_cast<std::uint32_t>(fans_.size()));
  }
  first_fan_.resize(vertices_.size() + 1, 0);
}

void ConvexHull::mapDirections() {
  // With more cells than vertices, most climbs start at their end.
  constexpr double kCellsAVertex = 4.0;
  constexpr std::size_t kMostRows = 16;
  const double cells_a_side = kCellsAVertex / 6.0 * static_cast<double>(vertices_.size());
  rows_ = std::min(kMostRows, static_cast<std::size_t>(std::sqrt(cells_a_side)));
  farthest_.resize(6 * rows_ * rows_);
  const VertexBlocks blocks(vertices_);
  std::uint32_t last = 0;
  const auto middleOf = [this](std::size_t row) {
    return (2.0 * static_cast<double>(row) + 1.0) / static_cast<double>(rows_) - 1.0;
  };
  for (Eigen::Index side = 0; side < 6; ++side) {
    Eigen::Vector3d direction;
    direction[side / 2] = side % 2 == 0 ? 1.0 : -1.0;
    for (std::size_t row = 0; row < rows_; ++row) {
      direction[(side / 2 + 1) % 3] = middleOf(row);
      for (std::size_t column = 0; column < rows_; ++column) {
        direction[(side / 2 + 2) % 3] = middleOf(column);
        last = blocks.farthest(direction, last);
        farthest_[cellOf(direction)] = last;
      }
    }
  }
}

std::size_t ConvexHull::cellOf(const Eigen::Vector3d& direction) const noexcept {
  const Eigen::Vector3d size = direction.cwiseAbs();
  const Eigen::Index of_xy = size.y() > size.x() ? 1 : 0;
  const Eigen::Index axis = size.z() > size[of_xy] ? 2 : of_xy;
  const auto rows = static_cast<double>(rows_);
  const double cells_a_length = 0.5 * rows / size[axis];
  const auto rowOf = [&](double across) {
    // This form puts NaN, as from direction 0, into the first row.
    const double place = std::max(0.0, across * cells_a_length + 0.5 * rows);
    return static_cast<std::size_t>(std::min(place, rows - 1.0));
  };
  const auto side = static_cast<std::size_t>(2 * axis + (direction[axis] < 0.0 ? 1 : 0));
  return (side * rows_ + rowOf(direction[(axis + 1) % 3])) * rows_ +
         rowOf(direction[(axis + 2) % 3]);
}

ConvexHull::Look ConvexHull::lookAround(const Eigen::Vector3d& direction,
                                        std::uint32_t from) const noexcept {
  // Uses the same sum as the fans, so that a climb cannot go in a circle.
  const double reach = along(direction, vertices_[from]);
  double beside = -std::numeric_limits<double>::infinity();
  double farthest = reach;
  std::uint32_t next = from;
  for (const Fan& fan : fansOf(from)) {
    const Eigen::Array<double, Fan::kSize, 1> reaches = fan.reaches(direction);
    const double most = reaches.maxCoeff();
    if (most > farthest) {
      farthest = most;
      next = fan.vertex[static_cast<std::size_t>(
          std::find(reaches.data(), reaches.data() + Fan::kSize, most) - reaches.data())];
    }
    beside = most > beside ? most : beside;
  }
  return {{from, reach, beside}, next};
}

ConvexHull::Extreme ConvexHull::climb(const Eigen::Vector3d& direction,
                                      std::uint32_t start) const noexcept {
  Look look = lookAround(direction, start);
  if (look.next == start) {
    return look.here;
  }
  std::uint32_t at = look.next;
  if (rows_ > 0) {
    const std::uint32_t mapped = farthest_[cellOf(direction)];
    at = direction.dot(vertices_[mapped]) > direction.dot(vertices_[at]) ? mapped : at;
  }
  for (look = lookAround(direction, at); look.next != at; look = lookAround(direction, at)) {
    at = look.next;
  }
  return look.here;
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
