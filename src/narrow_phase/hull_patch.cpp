// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/hull_patch.h"

#include <algorithm>
#include <cmath>

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

// One side of an edge: the face to its left when it is walked from `from` to `to`.
struct DirectedEdge {
  std::uint32_t face, from, to;
};

std::array<DirectedEdge, 2> sidesOf(const ConvexHull::Edge& edge) noexcept {
  return {{{edge.left, edge.from, edge.to}, {edge.right, edge.to, edge.from}}};
}

std::size_t countCorners(const ConvexHull& hull, std::uint32_t face,
                         std::uint32_t& first) noexcept {
  std::size_t count = 0;
  for (const ConvexHull::Edge& edge : hull.edges()) {
    for (const DirectedEdge& side : sidesOf(edge)) {
      if (side.face == face) {
        first = side.from;
        ++count;
      }
    }
  }
  return count;
}

std::uint32_t nextCorner(const ConvexHull& hull, std::uint32_t face,
                         std::uint32_t corner) noexcept {
  for (const ConvexHull::Edge& edge : hull.edges()) {
    for (const DirectedEdge& side : sidesOf(edge)) {
      if (side.face == face && side.from == corner) {
        return side.to;
      }
    }
  }
  return corner;
}

ContactPatch ringOf(const ConvexHull& hull, std::uint32_t face) noexcept {
  ContactPatch patch;
  std::uint32_t corner = 0;
  const std::size_t count = countCorners(hull, face, corner);
  const std::size_t step = (count + ContactPatch::kMaxCorners - 1) / ContactPatch::kMaxCorners;
  for (std::size_t i = 0; i < count; ++i) {
    if (i % step == 0) {
      patch.corners[patch.size++] = hull.vertices()[corner];
    }
    corner = nextCorner(hull, face, corner);
  }
  return patch;
}

// The face most square to the direction; false if none is flat.
bool findFace(const ConvexHull& hull, const Vector3d& direction, std::uint32_t& found) noexcept {
  double most = std::sqrt(1.0 - kFlatSine * kFlatSine);
  bool is_found = false;
  for (std::uint32_t i = 0; i < hull.faces().size(); ++i) {
    const double square = hull.faces()[i].normal.dot(direction);
    if (square >= most) {
      most = square;
      found = i;
      is_found = true;
    }
  }
  return is_found;
}

// An edge at the extreme vertex that is flat, the flattest; or the vertex.
ContactPatch edgeOrVertex(const ConvexHull& hull, const Vector3d& direction) noexcept {
  const std::uint32_t vertex = hull.supportVertex(direction, 0);
  ContactPatch patch;
  patch.corners[patch.size++] = hull.vertices()[vertex];
  double least = kFlatSine;
  for (const ConvexHull::Edge& edge : hull.edges()) {
    if (edge.from != vertex && edge.to != vertex) {
      continue;
    }
    const Vector3d along = hull.vertices()[edge.to] - hull.vertices()[edge.from];
    const double sine = std::abs(along.dot(direction)) / along.norm();
    if (sine <= least) {
      least = sine;
      patch.corners[1] = hull.vertices()[edge.from == vertex ? edge.to : edge.from];
      patch.size = 2;
    }
  }
  return patch;
}

}  // namespace

ContactPatch extremePatch(const ConvexHull& hull, const Pose& world_from_hull,
                          const Vector3d& direction) noexcept {
  const Vector3d in_hull = world_from_hull.rotation.transpose() * direction;
  std::uint32_t face = 0;
  ContactPatch patch =
      findFace(hull, in_hull, face) ? ringOf(hull, face) : edgeOrVertex(hull, in_hull);
  for (std::size_t i = 0; i < patch.size; ++i) {
    patch.corners[i] = world_from_hull * patch.corners[i];
  }
  return patch;
}

}  // namespace collision_monitor
