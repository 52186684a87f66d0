// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/warm_start/confirm_depth.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <limits>

#include "narrow_phase/gjk/simplex.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;
using Inside = ConvexWarmStart::Inside;

// What the polytope is where the cores are now.
struct PlacedInside {
  std::array<Vector3d, Inside::kMaxCorners> on_a;
  std::array<Vector3d, Inside::kMaxCorners> corners;
  std::array<Vector3d, Inside::kMaxFaces> outward;  // normals, of any length
  // Of each face's plane the squared distance, negative where the face looks at the origin.
  std::array<double, Inside::kMaxFaces> squared;
};

void placeCorner(std::size_t i, const PlacedPair& pair, const Inside& inside,
                 PlacedInside& placed) noexcept {
  const PlacedCorners ends = place(inside.corners[i], pair);
  placed.on_a[i] = ends.on_a;
  placed.corners[i] = ends.difference;
}

void placeFace(std::size_t f, const Inside& inside, PlacedInside& placed) noexcept {
  const Inside::Face& face = inside.faces[f];
  const Vector3d& p = placed.corners[face[0]];
  const Vector3d normal = (placed.corners[face[1]] - p).cross(placed.corners[face[2]] - p);
  const double offset = normal.dot(p);
  const double squared = normal.squaredNorm();
  placed.outward[f] = normal;
  placed.squared[f] = squared > 0.0 ? offset * std::abs(offset) / squared
                                    : -std::numeric_limits<double>::infinity();
}

std::size_t nearestFace(const ConvexWarmStart& warm, const PlacedInside& placed) noexcept {
  const auto first = placed.squared.begin();
  return static_cast<std::size_t>(std::min_element(first, first + warm.inside_faces) - first);
}

// Of the faces in the plane of the nearest one, that which holds the foot of the perpendicular.
// About a middle that the cores share, others are as far, and look elsewhere.
bool findFoot(const ConvexWarmStart& warm, const PlacedInside& placed, const Vector3d& expected,
              std::size_t& face, NearestOnSimplex& foot) noexcept {
  constexpr double kSame = 1e-20;  // of squares
  const double nearest = expected.squaredNorm();
  for (face = 0; face < warm.inside_faces; ++face) {
    if (placed.squared[face] <= (1.0 + 1e-12) * nearest) {
      const Inside::Face& ends = warm.inside.faces[face];
      const std::array<Vector3d, 4> points{placed.corners[ends[0]], placed.corners[ends[1]],
                                           placed.corners[ends[2]], Vector3d::Zero()};
      if (nearestInside(points, 3, foot) &&
          (foot.point - expected).squaredNorm() <= kSame * nearest) {
        return true;
      }
    }
  }
  return false;
}

struct Faces {
  std::array<Inside::Face, Inside::kMaxFaces> list;
  std::size_t size{0};

  bool hasEdge(std::uint8_t from, std::uint8_t to) const noexcept {
    return std::any_of(list.begin(), list.begin() + size, [&](const Inside::Face& f) {
      return (f[0] == from && f[1] == to) || (f[1] == from && f[2] == to) ||
             (f[2] == from && f[0] == to);
    });
  }
};

// Takes away the faces that see a corner; those that stay move up.
Faces takeSeeing(const Vector3d& apex, ConvexWarmStart& warm, PlacedInside& placed) noexcept {
  auto& faces = warm.inside.faces;
  Faces seeing;
  std::uint8_t kept = 0;
  for (std::size_t f = 0; f < warm.inside_faces; ++f) {
    if (placed.outward[f].dot(apex - placed.corners[faces[f][0]]) > 0.0) {
      seeing.list[seeing.size++] = faces[f];
    } else {
      faces[kept] = faces[f];
      placed.outward[kept] = placed.outward[f];
      placed.squared[kept++] = placed.squared[f];
    }
  }
  warm.inside_faces = kept;
  return seeing;
}

// Corners that no face has any more make room for others.
void dropUnused(ConvexWarmStart& warm, PlacedInside& placed) noexcept {
  std::bitset<Inside::kMaxCorners> used;
  for (std::size_t f = 0; f < warm.inside_faces; ++f) {
    for (const std::uint8_t corner : warm.inside.faces[f]) {
      used.set(corner);
    }
  }
  std::array<std::uint8_t, Inside::kMaxCorners> number{};
  std::uint8_t kept = 0;
  for (std::size_t i = 0; i < warm.inside_corners; ++i) {
    if (used[i]) {
      warm.inside.corners[kept] = warm.inside.corners[i];
      placed.corners[kept] = placed.corners[i];
      placed.on_a[kept] = placed.on_a[i];
      number[i] = kept++;
    }
  }
  warm.inside_corners = kept;
  for (std::size_t f = 0; f < warm.inside_faces; ++f) {
    for (std::uint8_t& corner : warm.inside.faces[f]) {
      corner = number[corner];
    }
  }
}

// Joins a corner to the outline of the faces that see it, which go. The surface stays closed, with
// each edge between two faces, if the outline starts but once at each corner.
// Returns false, with no polytope left, if it does not, or there is no room.
bool growTo(const ConvexWarmStart::Ends& beyond, const PlacedPair& pair, ConvexWarmStart& warm,
            PlacedInside& placed) noexcept {
  if (warm.inside_corners == Inside::kMaxCorners) {
    dropUnused(warm, placed);
  }
  if (warm.inside_corners == Inside::kMaxCorners) {
    warm.inside_faces = 0;
    return false;
  }
  std::bitset<Inside::kMaxCorners> starts;
  const std::uint8_t apex = warm.inside_corners++;
  warm.inside.corners[apex] = beyond;
  placeCorner(apex, pair, warm.inside, placed);
  const Faces seeing = takeSeeing(placed.corners[apex], warm, placed);
  for (std::size_t i = 0; i < seeing.size; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint8_t from = seeing.list[i][k];
      const std::uint8_t to = seeing.list[i][(k + 1) % 3];
      if (seeing.hasEdge(to, from)) {
        continue;
      }
      if (warm.inside_faces == Inside::kMaxFaces || starts[from]) {
        warm.inside_faces = 0;
        return false;
      }
      starts.set(from);
      warm.inside.faces[warm.inside_faces] = {from, to, apex};
      placeFace(warm.inside_faces++, warm.inside, placed);
    }
  }
  return starts.any();
}

// The face that proves the depth. The polytope grows while the difference goes on beyond it.
bool settle(const PlacedPair& pair, ConvexWarmStart& warm, PlacedInside& placed,
            std::size_t& nearest, bool& is_level) noexcept {
  constexpr int kMaxGrown = 6;
  const double touching = 2.0 * touchingDistance(pair.size);
  for (int grown = 0; grown <= kMaxGrown; ++grown) {
    nearest = nearestFace(warm, placed);
    const double squared = placed.squared[nearest];
    const SupportPlanes planes = supportPlanes(pair, -placed.outward[nearest].normalized());
    if (!(planes.gap < -touching)) {
      return false;
    }
    if (squared > touching * touching && meet(planes, -std::sqrt(squared), roundingOf(pair.size))) {
      is_level = planes.may_be_level && areLevel(pair, planes);
      return true;
    }
    if (!growTo(cornersOf(pair, planes), pair, warm, placed)) {
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
  warm.inside_faces = 0;
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
  warm.inside_corners = static_cast<std::uint8_t>(corner_count);
  warm.inside_faces = static_cast<std::uint8_t>(face_count);
}

std::optional<ConfirmedDistance> confirmDepth(const PlacedPair& pair,
                                              ConvexWarmStart& warm) noexcept {
  PlacedInside placed;
  for (std::size_t i = 0; i < warm.inside_corners; ++i) {
    placeCorner(i, pair, warm.inside, placed);
  }
  for (std::size_t f = 0; f < warm.inside_faces; ++f) {
    placeFace(f, warm.inside, placed);
  }
  std::size_t nearest = 0;
  std::size_t face = 0;
  NearestOnSimplex foot;
  bool is_level = false;
  if (!settle(pair, warm, placed, nearest, is_level)) {
    return std::nullopt;
  }
  const double depth = std::sqrt(placed.squared[nearest]);
  const Vector3d normal = -placed.outward[nearest].normalized();
  if (!findFoot(warm, placed, -depth * normal, face, foot)) {
    return std::nullopt;
  }
  Vector3d on_a = pair.a.world_from_core.translation;
  for (std::size_t k = 0; k < 3; ++k) {
    on_a += foot.weights[k] * placed.on_a[warm.inside.faces[face][k]];
  }
  return ConfirmedDistance{{-depth, on_a, on_a - depth * normal, normal}, is_level};
}

}  // namespace collision_monitor
