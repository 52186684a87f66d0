// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/confirm_depth.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <limits>

#include "narrow_phase/simplex.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;
using Inside = ConvexWarmStart::Inside;

// What the polytope is where the cores are now.
struct PlacedInside {
  std::array<Vector3d, Inside::kMaxCorners> on_a;
  std::array<Vector3d, Inside::kMaxCorners> corners;
  std::array<double, Inside::kMaxFaces> squared;  // distance of each face's plane
  std::size_t nearest{0};                         // the least of them
  Vector3d outward;                               // its normal, of any length
};

void placeCorner(std::size_t i, const PlacedPair& pair, const Inside& inside,
                 PlacedInside& placed) noexcept {
  const PlacedCorners ends = place(inside.corners[i], pair);
  placed.on_a[i] = ends.on_a;
  placed.corners[i] = ends.difference;
}

// False if a face does not look away from the origin.
bool placeFaces(const Inside& inside, PlacedInside& placed) noexcept {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t f = 0; f < inside.face_count; ++f) {
    const Inside::Face& face = inside.faces[f];
    const Vector3d& p = placed.corners[face[0]];
    const Vector3d normal = (placed.corners[face[1]] - p).cross(placed.corners[face[2]] - p);
    const double offset = normal.dot(p);
    if (!(offset > 0.0)) {
      return false;
    }
    placed.squared[f] = offset * offset / normal.squaredNorm();
    if (placed.squared[f] < least) {
      least = placed.squared[f];
      placed.nearest = f;
      placed.outward = normal;
    }
  }
  return least < std::numeric_limits<double>::infinity();
}

// Of the faces in the plane of the nearest one, that which holds the foot of the perpendicular.
bool findFoot(const Inside& inside, const PlacedInside& placed, std::size_t& face,
              NearestPoint& foot) noexcept {
  constexpr double kSamePlane = 1.0 + 1e-12;
  const double most = kSamePlane * placed.squared[placed.nearest];
  for (face = 0; face < inside.face_count; ++face) {
    const Inside::Face& ends = inside.faces[face];
    const std::array<Vector3d, 4> points{placed.corners[ends[0]], placed.corners[ends[1]],
                                         placed.corners[ends[2]], Vector3d::Zero()};
    if (placed.squared[face] <= most && nearestInside(points, 3, foot)) {
      return true;
    }
  }
  return false;
}

// Three faces for the nearest one, up to the corner beyond it. They need not make a convex edge
// with those beside it.
bool raiseNearest(const PlacedPair& pair, Inside& inside, PlacedInside& placed) noexcept {
  if (inside.corner_count == Inside::kMaxCorners || inside.face_count + 2U > Inside::kMaxFaces) {
    return false;
  }
  const std::uint8_t apex = inside.corner_count++;
  inside.corners[apex] = supportEnds(pair, -placed.outward.normalized());
  placeCorner(apex, pair, inside, placed);
  const Inside::Face base = inside.faces[placed.nearest];
  inside.faces[placed.nearest] = {base[0], base[1], apex};
  inside.faces[inside.face_count++] = {base[1], base[2], apex};
  inside.faces[inside.face_count++] = {base[2], base[0], apex};
  return true;
}

bool settle(const PlacedPair& pair, Inside& inside, PlacedInside& placed) noexcept {
  constexpr int kMaxRaised = 3;
  for (int raised = 0; placeFaces(inside, placed); ++raised) {
    const double depth = std::sqrt(placed.squared[placed.nearest]);
    if (depth <= 2.0 * touchingDistance(pair.size)) {
      return false;
    }
    if (isProven(pair, -placed.outward.normalized(), -depth, roundingOf(pair.size))) {
      return true;
    }
    if (raised == kMaxRaised || !raiseNearest(pair, inside, placed)) {
      return false;
    }
  }
  return false;
}

}  // namespace

void keepInside(const ConvexWorkspace& polytope, ConvexWarmStart& warm) noexcept {
  constexpr std::uint8_t kNone = std::numeric_limits<std::uint8_t>::max();
  std::array<std::uint8_t, ConvexWorkspace::kMaxVertices> number;
  number.fill(kNone);
  Inside& inside = warm.inside;
  std::size_t corner_count = 0;
  std::size_t face_count = 0;
  inside.face_count = 0;
  for (std::size_t f = 0; f < polytope.face_count; ++f) {
    if (polytope.faces[f].is_gone) {
      continue;
    }
    if (face_count == Inside::kMaxFaces) {
      return;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t corner = polytope.faces[f].corners[k];
      if (number[corner] == kNone) {
        if (corner_count == Inside::kMaxCorners) {
          return;
        }
        const SupportVertex& vertex = polytope.vertices[corner];
        inside.corners[corner_count] = {vertex.on_a, vertex.on_b};
        number[corner] = static_cast<std::uint8_t>(corner_count++);
      }
      inside.faces[face_count][k] = number[corner];
    }
    ++face_count;
  }
  inside.corner_count = static_cast<std::uint8_t>(corner_count);
  inside.face_count = static_cast<std::uint8_t>(face_count);
}

bool confirmDepth(const PlacedPair& pair, ConvexWarmStart& warm, SignedDistance& cores) noexcept {
  Inside& inside = warm.inside;
  PlacedInside placed;
  for (std::size_t i = 0; i < inside.corner_count; ++i) {
    placeCorner(i, pair, inside, placed);
  }
  std::size_t face = 0;
  NearestPoint foot;
  if (!settle(pair, inside, placed) || !findFoot(inside, placed, face, foot)) {
    return false;
  }
  const double depth = std::sqrt(placed.squared[placed.nearest]);
  cores.distance = -depth;
  cores.normal_a_to_b = -placed.outward.normalized();
  cores.point_on_a = pair.a.world_from_core.translation;
  for (std::size_t k = 0; k < 3; ++k) {
    cores.point_on_a += foot.weights[k] * placed.on_a[inside.faces[face][k]];
  }
  cores.point_on_b = cores.point_on_a - depth * cores.normal_a_to_b;
  return true;
}

}  // namespace collision_monitor
