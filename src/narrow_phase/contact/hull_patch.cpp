// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/contact/hull_patch.h"

#include <Eigen/Geometry>
#include <algorithm>
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

// Keeps the offered face that is most square to a direction, within `least_sine`.
struct FlattestFace {
  const ConvexHull& hull;
  const Vector3d& direction;
  double least_sine;
  std::uint32_t face{0};
  bool is_found{false};

  void offer(std::uint32_t offered) noexcept {
    const Vector3d& normal = hull.faces()[offered].normal;
    const double sine = normal.cross(direction).norm();
    if (sine <= least_sine && normal.dot(direction) > 0.0 && hull.ringOf(offered).size() >= 3) {
      least_sine = sine;
      face = offered;
      is_found = true;
    }
  }
};

bool findFace(const ConvexHull& hull, const Vector3d& direction, double flat_sine,
              std::uint32_t& found) noexcept {
  FlattestFace flattest{hull, direction, flat_sine};
  // Few faces pass this test, and it is cheaper than their sine. Its rounding is far below 1e-12.
  const double least_cosine = std::sqrt(1.0 - flat_sine * flat_sine) - 1e-12;
  for (std::uint32_t face = 0; face < hull.faces().size(); ++face) {
    if (hull.faces()[face].normal.dot(direction) >= least_cosine) {
      flattest.offer(face);
    }
  }
  found = flattest.face;
  return flattest.is_found;
}

// The flattest edge at a vertex, or the vertex if no edge is flat. The ring of each face gives the
// edge that leaves the vertex.
ContactPatch edgeOrVertex(const ConvexHull& hull, std::uint32_t vertex, const Vector3d& direction,
                          double flat_sine) noexcept {
  ContactPatch patch;
  patch.corners[patch.size++] = hull.vertices()[vertex];
  double least = flat_sine;
  for (const std::uint32_t face : hull.facesAt(vertex)) {
    const ConvexHull::Indices ring = hull.ringOf(face);
    const std::uint32_t* next = std::find(ring.begin(), ring.end(), vertex) + 1;
    const Vector3d& end = hull.vertices()[next == ring.end() ? *ring.begin() : *next];
    const Vector3d along = end - patch.corners[0];
    const double sine = std::abs(along.dot(direction)) / along.norm();
    if (sine <= least) {
      least = sine;
      patch.corners[1] = end;
      patch.size = 2;
    }
  }
  return patch;
}

ContactPatch placed(const Pose& world_from_hull, ContactPatch patch) noexcept {
  for (std::size_t i = 0; i < patch.size; ++i) {
    patch.corners[i] = world_from_hull * patch.corners[i];
  }
  return patch;
}

}  // namespace

ContactPatch extremePatch(const ConvexHull& hull, const Pose& world_from_hull,
                          const Vector3d& direction, double flat_sine) noexcept {
  const Vector3d in_hull = world_from_hull.rotation.transpose() * direction;
  std::uint32_t face = 0;
  return placed(world_from_hull,
                findFace(hull, in_hull, flat_sine, face)
                    ? patchOfFace(hull, face)
                    : edgeOrVertex(hull, hull.supportVertex(in_hull, 0), in_hull, flat_sine));
}

ContactPatch patchAt(std::uint32_t vertex, const ConvexHull& hull, const Pose& world_from_hull,
                     const Vector3d& direction, double flat_sine) noexcept {
  if (hull.facesAt(vertex).size() == 0) {  // inside a face
    return extremePatch(hull, world_from_hull, direction, flat_sine);
  }
  const Vector3d in_hull = world_from_hull.rotation.transpose() * direction;
  FlattestFace flattest{hull, in_hull, flat_sine};
  for (const std::uint32_t face : hull.facesAt(vertex)) {
    flattest.offer(face);
  }
  return placed(world_from_hull, flattest.is_found
                                     ? patchOfFace(hull, flattest.face)
                                     : edgeOrVertex(hull, vertex, in_hull, flat_sine));
}

}  // namespace collision_monitor
