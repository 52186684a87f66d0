// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/warm_start/depth_from_warm_start.h"

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
using CachedPolytope = ConvexWarmStart::CachedPolytope;

// The polytope at the current poses of the cores.
struct PlacedPolytope {
  std::array<Vector3d, CachedPolytope::kMaxCorners> on_a;
  std::array<Vector3d, CachedPolytope::kMaxCorners> corners;
  std::array<Vector3d, CachedPolytope::kMaxFaces> outward;  // normals, of any length
  // Squared distance of each face's plane, negative if the face looks at the origin.
  std::array<double, CachedPolytope::kMaxFaces> squared;
};

void placeCorner(std::size_t i, const PlacedPair& pair, const CachedPolytope& polytope,
                 PlacedPolytope& placed) noexcept {
  const PlacedCorners ends = place(polytope.corners[i], pair);
  placed.on_a[i] = ends.on_a;
  placed.corners[i] = ends.difference;
}

void placeFace(std::size_t f, const CachedPolytope& polytope, PlacedPolytope& placed) noexcept {
  const CachedPolytope::Face& face = polytope.faces[f];
  const Vector3d& p = placed.corners[face[0]];
  const Vector3d normal = (placed.corners[face[1]] - p).cross(placed.corners[face[2]] - p);
  const double offset = normal.dot(p);
  const double squared = normal.squaredNorm();
  placed.outward[f] = normal;
  placed.squared[f] = squared > 0.0 ? offset * std::abs(offset) / squared
                                    : -std::numeric_limits<double>::infinity();
}

std::size_t nearestFace(const ConvexWarmStart& warm, const PlacedPolytope& placed) noexcept {
  const auto first = placed.squared.begin();
  return static_cast<std::size_t>(std::min_element(first, first + warm.polytope_faces) - first);
}

// Of the faces in the plane of the nearest one, finds the one that holds the projection of the
// origin. If the cores share their middle, others are as far and look elsewhere.
bool findClosest(const ConvexWarmStart& warm, const PlacedPolytope& placed,
                 const Vector3d& expected, std::size_t& face, NearestOnSimplex& closest) noexcept {
  constexpr double kSame = 1e-20;  // of squares
  const double nearest = expected.squaredNorm();
  for (face = 0; face < warm.polytope_faces; ++face) {
    if (placed.squared[face] <= (1.0 + 1e-12) * nearest) {
      const CachedPolytope::Face& ends = warm.polytope.faces[face];
      const std::array<Vector3d, 4> points{placed.corners[ends[0]], placed.corners[ends[1]],
                                           placed.corners[ends[2]], Vector3d::Zero()};
      if (nearestOfSimplex(points, 3, closest) &&
          (closest.point - expected).squaredNorm() <= kSame * nearest) {
        return true;
      }
    }
  }
  return false;
}

struct Faces {
  std::array<CachedPolytope::Face, CachedPolytope::kMaxFaces> list;
  std::size_t size{0};

  bool hasEdge(std::uint8_t from, std::uint8_t to) const noexcept {
    return std::any_of(list.begin(), list.begin() + size, [&](const CachedPolytope::Face& f) {
      return (f[0] == from && f[1] == to) || (f[1] == from && f[2] == to) ||
             (f[2] == from && f[0] == to);
    });
  }
};

// Removes the faces that see a corner; the others move up.
Faces takeSeeing(const Vector3d& apex, ConvexWarmStart& warm, PlacedPolytope& placed) noexcept {
  auto& faces = warm.polytope.faces;
  Faces seeing;
  std::uint8_t kept = 0;
  for (std::size_t f = 0; f < warm.polytope_faces; ++f) {
    if (placed.outward[f].dot(apex - placed.corners[faces[f][0]]) > 0.0) {
      seeing.list[seeing.size++] = faces[f];
    } else {
      faces[kept] = faces[f];
      placed.outward[kept] = placed.outward[f];
      placed.squared[kept++] = placed.squared[f];
    }
  }
  warm.polytope_faces = kept;
  return seeing;
}

// Removes the corners that no face has any more, to make room.
void dropUnused(ConvexWarmStart& warm, PlacedPolytope& placed) noexcept {
  std::bitset<CachedPolytope::kMaxCorners> used;
  for (std::size_t f = 0; f < warm.polytope_faces; ++f) {
    for (const std::uint8_t corner : warm.polytope.faces[f]) {
      used.set(corner);
    }
  }
  std::array<std::uint8_t, CachedPolytope::kMaxCorners> number{};
  std::uint8_t kept = 0;
  for (std::size_t i = 0; i < warm.polytope_corners; ++i) {
    if (used[i]) {
      warm.polytope.corners[kept] = warm.polytope.corners[i];
      placed.corners[kept] = placed.corners[i];
      placed.on_a[kept] = placed.on_a[i];
      number[i] = kept++;
    }
  }
  warm.polytope_corners = kept;
  for (std::size_t f = 0; f < warm.polytope_faces; ++f) {
    for (std::uint8_t& corner : warm.polytope.faces[f]) {
      corner = number[corner];
    }
  }
}

// Joins a corner to the outline of the faces that see it, which are removed. The surface stays
// closed, with each edge between two faces, if the outline starts only once at each corner. Returns
// false, with no polytope left, if it does not or there is no room.
bool growTo(const ConvexWarmStart::Ends& beyond, const PlacedPair& pair, ConvexWarmStart& warm,
            PlacedPolytope& placed) noexcept {
  if (warm.polytope_corners == CachedPolytope::kMaxCorners) {
    dropUnused(warm, placed);
  }
  if (warm.polytope_corners == CachedPolytope::kMaxCorners) {
    warm.polytope_faces = 0;
    return false;
  }
  std::bitset<CachedPolytope::kMaxCorners> starts;
  const std::uint8_t apex = warm.polytope_corners++;
  warm.polytope.corners[apex] = beyond;
  placeCorner(apex, pair, warm.polytope, placed);
  const Faces seeing = takeSeeing(placed.corners[apex], warm, placed);
  for (std::size_t i = 0; i < seeing.size; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint8_t from = seeing.list[i][k];
      const std::uint8_t to = seeing.list[i][(k + 1) % 3];
      if (seeing.hasEdge(to, from)) {
        continue;
      }
      if (warm.polytope_faces == CachedPolytope::kMaxFaces || starts[from]) {
        warm.polytope_faces = 0;
        return false;
      }
      starts.set(from);
      warm.polytope.faces[warm.polytope_faces] = {from, to, apex};
      placeFace(warm.polytope_faces++, warm.polytope, placed);
    }
  }
  return starts.any();
}

// Finds the face that proves the depth. Grows the polytope while the difference goes beyond it.
bool settle(const PlacedPair& pair, ConvexWarmStart& warm, PlacedPolytope& placed,
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

void cachePolytope(const ConvexWorkspace& grown, ConvexWarmStart& warm) noexcept {
  constexpr std::uint8_t kNotKept = std::numeric_limits<std::uint8_t>::max();
  std::array<std::uint8_t, ConvexWorkspace::kMaxVertices> number;
  number.fill(kNotKept);
  CachedPolytope& kept = warm.polytope;
  std::size_t corner_count = 0;
  std::size_t face_count = 0;
  warm.polytope_faces = 0;
  for (std::size_t f = 0; f < grown.face_count; ++f) {
    if (grown.faces[f].is_gone) {
      continue;
    }
    if (face_count == CachedPolytope::kMaxFaces) {
      return;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t corner = grown.faces[f].corners[k];
      if (number[corner] == kNotKept) {
        if (corner_count == CachedPolytope::kMaxCorners) {
          return;
        }
        const SupportVertex& vertex = grown.vertices[corner];
        kept.corners[corner_count] = {vertex.on_a, vertex.on_b};
        number[corner] = static_cast<std::uint8_t>(corner_count++);
      }
      kept.faces[face_count][k] = number[corner];
    }
    ++face_count;
  }
  warm.polytope_corners = static_cast<std::uint8_t>(corner_count);
  warm.polytope_faces = static_cast<std::uint8_t>(face_count);
}

std::optional<WarmStartDistance> depthFromWarmStart(const PlacedPair& pair,
                                                    ConvexWarmStart& warm) noexcept {
  PlacedPolytope placed;
  for (std::size_t i = 0; i < warm.polytope_corners; ++i) {
    placeCorner(i, pair, warm.polytope, placed);
  }
  for (std::size_t f = 0; f < warm.polytope_faces; ++f) {
    placeFace(f, warm.polytope, placed);
  }
  std::size_t nearest = 0;
  std::size_t face = 0;
  NearestOnSimplex closest;
  bool is_level = false;
  if (!settle(pair, warm, placed, nearest, is_level)) {
    return std::nullopt;
  }
  const double depth = std::sqrt(placed.squared[nearest]);
  const Vector3d normal = -placed.outward[nearest].normalized();
  if (!findClosest(warm, placed, -depth * normal, face, closest)) {
    return std::nullopt;
  }
  Vector3d on_a = pair.a.world_from_core.translation;
  for (std::size_t k = 0; k < 3; ++k) {
    on_a += closest.weights[k] * placed.on_a[warm.polytope.faces[face][k]];
  }
  return WarmStartDistance{{-depth, on_a, on_a - depth * normal, normal}, is_level};
}

}  // namespace collision_monitor
