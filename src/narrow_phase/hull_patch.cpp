// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/hull_patch.h"

#include <Eigen/Geometry>
#include <cmath>

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

ContactPatch patchOfFace(const ConvexHull& hull, std::uint32_t face) noexcept {
  ContactPatch patch;
  const ConvexHull::Indices ring = hull.ringOf(face);
  const std::size_t step =
      (ring.size() + ContactPatch::kMaxCorners - 1) / ContactPatch::kMaxCorners;
  for (std::size_t i = 0; i < ring.size(); i += step) {
    patch.corners[patch.size++] = hull.vertices()[ring.first[i]];
  }
  return patch;
}

// The face most square to the direction; false if none is flat.
bool findFace(const ConvexHull& hull, const Vector3d& direction, double flat_sine,
              std::uint32_t& found) noexcept {
  double least = flat_sine;
  bool is_found = false;
  // Few faces pass this, which costs less than their sine; its rounding is far below 1e-12.
  const double least_cosine = std::sqrt(1.0 - flat_sine * flat_sine) - 1e-12;
  for (std::uint32_t i = 0; i < hull.faces().size(); ++i) {
    const Vector3d& normal = hull.faces()[i].normal;
    if (normal.dot(direction) < least_cosine) {
      continue;
    }
    const double sine = normal.cross(direction).norm();
    if (sine <= least && hull.ringOf(i).size() >= 3) {
      least = sine;
      found = i;
      is_found = true;
    }
  }
  return is_found;
}

// An edge at the extreme vertex that is flat, the flattest; or the vertex.
ContactPatch edgeOrVertex(const ConvexHull& hull, const Vector3d& direction,
                          double flat_sine) noexcept {
  const std::uint32_t vertex = hull.supportVertex(direction, 0);
  ContactPatch patch;
  patch.corners[patch.size++] = hull.vertices()[vertex];
  double least = flat_sine;
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
                          const Vector3d& direction, double flat_sine) noexcept {
  const Vector3d in_hull = world_from_hull.rotation.transpose() * direction;
  std::uint32_t face = 0;
  ContactPatch patch = findFace(hull, in_hull, flat_sine, face)
                           ? patchOfFace(hull, face)
                           : edgeOrVertex(hull, in_hull, flat_sine);
  for (std::size_t i = 0; i < patch.size; ++i) {
    patch.corners[i] = world_from_hull * patch.corners[i];
  }
  return patch;
}

}  // namespace collision_monitor
