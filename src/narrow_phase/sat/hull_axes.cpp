// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/sat/hull_axes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "narrow_phase/gjk/convex_pair.h"
#include "narrow_phase/sat/hull_arcs.h"
#include "narrow_phase/sat/hull_depth.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;
using Kind = HullAxis::Kind;

// Two hulls as seen from one of them.
struct View {
  const ConvexHull& owner;
  const ConvexHull& other;
  const Pose& owner_from_other;
};

// The search among the faces of one hull.
struct FaceSearch {
  KnownPoints known;
  Eigen::Index found{0};    // number of known points that are lowest under a face
  std::uint32_t lowest{0};  // the last such vertex
};

// `best` is in the owner's frame, and its axis leads away from the owner.
void lookAtFace(const View& view, std::uint32_t f, FaceSearch& search, HullAxis& best) noexcept {
  const ConvexHull::Face& face = view.owner.faces()[f];
  for (Eigen::Index i = 0; i < search.found; ++i) {
    if (search.known.above(face, i) <= best.separation) {
      return;
    }
  }
  const Eigen::Matrix3d& rotation = view.owner_from_other.rotation;
  const Vector3d inward(-along(face.normal, rotation.col(0)), -along(face.normal, rotation.col(1)),
                        -along(face.normal, rotation.col(2)));
  search.lowest = view.other.supportVertex(inward, search.lowest);
  const Vector3d point = view.owner_from_other * view.other.vertices()[search.lowest];
  if (search.found < search.known.x.size()) {
    search.known.set(search.found++, point);
  }
  offer({along(face.normal, point) - face.offset, face.normal, Kind::face_of_a, f, search.lowest},
        best);
}

// Starts with the face that some vertices of the other hull are least below. Skips faces that
// separate no more than the best.
void searchFaces(const View& view, FaceSearch& search, HullAxis& best) noexcept {
  const auto& faces = view.owner.faces();
  const auto& vertices = view.other.vertices();
  for (std::size_t i = 0; i < 4; ++i) {
    search.known.set(static_cast<Eigen::Index>(i),
                     view.owner_from_other * vertices[i * vertices.size() / 4]);
  }
  std::array<double, kMostAxisFaces> heights;
  const std::size_t count = std::min(faces.size(), kMostAxisFaces);
  std::uint32_t first = 0;
  for (std::uint32_t f = 0; f < count; ++f) {
    heights[f] = search.known.above(faces[f]).minCoeff();
    first = heights[f] > heights[first] ? f : first;
  }
  lookAtFace(view, first, search, best);
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    if (f >= count || (f != first && heights[f] > best.separation)) {
      lookAtFace(view, f, search, best);
    }
  }
}

}  // namespace

HullAxis bestAxis(const ConvexHull& a, const ConvexHull& b, const Pose& a_from_b,
                  double cutoff) noexcept {
  const View from_a{a, b, a_from_b};
  FaceSearch of_b;
  HullAxis best;
  searchFaces(from_a, of_b, best);
  if (best.separation >= cutoff) {
    return best;
  }
  const Pose b_from_a = inverse(a_from_b);
  FaceSearch of_a;
  HullAxis best_of_b;
  best_of_b.separation = best.separation;
  searchFaces({b, a, b_from_a}, of_a, best_of_b);
  offer({best_of_b.separation, a_from_b.rotation * -best_of_b.direction, Kind::face_of_b,
         best_of_b.feature_of_b, best_of_b.feature_of_a},
        best);
  if (best.separation < cutoff) {
    searchEdges({a, of_b.known}, {b, of_a.known}, a_from_b, best);
  }
  return best;
}

}  // namespace collision_monitor
