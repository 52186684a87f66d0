// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/narrow_phase/hull_axes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "narrow_phase/convex_pair.h"
#include "narrow_phase/hull_depth.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;
using Kind = HullAxis::Kind;

// What a few points of one hull say of the faces of the other: they are looked at only where the
// points leave it open. Faces beyond these are looked at in any case.
constexpr std::size_t kMostFaces = 128;

void offer(const HullAxis& candidate, HullAxis& best) noexcept {
  if (candidate.separation > best.separation) {
    best = candidate;
  }
}

// Two hulls as seen from one of them.
struct View {
  const ConvexHull& owner;
  const ConvexHull& other;
  const Pose& owner_from_other;
};

// Four points of the other hull, in columns and in the owner's frame. What one of them is below a
// face, the hull is at least.
struct Known {
  Eigen::Array4d x, y, z;

  void set(Eigen::Index i, const Vector3d& point) noexcept {
    x[i] = point.x();
    y[i] = point.y();
    z[i] = point.z();
  }
  Eigen::Array4d above(const ConvexHull::Face& face) const noexcept {
    return face.normal.x() * x + face.normal.y() * y + face.normal.z() * z - face.offset;
  }
  double above(const ConvexHull::Face& face, Eigen::Index i) const noexcept {
    return face.normal.x() * x[i] + face.normal.y() * y[i] + face.normal.z() * z[i] - face.offset;
  }
};

// The search among the faces of one hull.
struct FaceSearch {
  Known known;
  Eigen::Index found{0};    // points known because they were lowest under a face
  std::uint32_t lowest{0};  // the last vertex that was
};

// `best` is in the owner's frame, and its axis leads away from it.
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

// Begins with the face that some vertices of the other hull are least below; those that separate
// no more than the best are passed over.
void searchFaces(const View& view, FaceSearch& search, HullAxis& best) noexcept {
  const auto& faces = view.owner.faces();
  const auto& vertices = view.other.vertices();
  for (std::size_t i = 0; i < 4; ++i) {
    search.known.set(static_cast<Eigen::Index>(i),
                     view.owner_from_other * vertices[i * vertices.size() / 4]);
  }
  std::array<double, kMostFaces> heights;
  const std::size_t count = std::min(faces.size(), kMostFaces);
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

// By face: a bit for each known point that is at least as far below it as asked for.
using Masks = std::array<std::uint8_t, kMostFaces>;

void maskFaces(const ConvexHull& owner, const Known& known, double below, Masks& masks) noexcept {
  const std::size_t count = std::min(owner.faces().size(), kMostFaces);
  for (std::size_t f = 0; f < count; ++f) {
    const Eigen::Array4d heights = known.above(owner.faces()[f]);
    unsigned mask = 0;
    for (unsigned i = 0; i < 4; ++i) {
      mask |= heights[i] <= below ? 1U << i : 0U;
    }
    masks[f] = static_cast<std::uint8_t>(mask);
  }
}

// Whether no axis that touches only the edge separates more than the masks were made for, which is
// not positive: a point as far below both faces beside it is at least as far below any plane
// between these, since its normal is a sum of theirs, made longer to be unit.
bool isPassedOver(const ConvexHull::Edge& edge, const Masks& masks) noexcept {
  return edge.left < kMostFaces && edge.right < kMostFaces &&
         (masks[edge.left] & masks[edge.right]) != 0;
}

// An edge and the normals of the faces beside it, in A's frame. On the Gauss map it is the arc
// from one normal to the other.
struct Arc {
  Vector3d point;
  Vector3d edge;  // any length, along left x right
  Vector3d left;
  Vector3d right;
  std::uint32_t number;
};

// Edges that are left over of a hull, so many at a time.
struct Arcs {
  static constexpr std::size_t kMost = 32;

  std::array<Arc, kMost> list;
  std::size_t size{0};
};

Arc arcOf(const ConvexHull& hull, std::uint32_t number) noexcept {
  const ConvexHull::Edge& edge = hull.edges()[number];
  return {hull.vertices()[edge.from], hull.vertices()[edge.to] - hull.vertices()[edge.from],
          hull.faces()[edge.left].normal, hull.faces()[edge.right].normal, number};
}

// The arc of a face pair of B as seen by A's outward normals.
Arc opposite(const Arc& arc, const Pose& a_from_b) noexcept {
  return {a_from_b * arc.point, a_from_b.rotation * arc.edge, -(a_from_b.rotation * arc.left),
          -(a_from_b.rotation * arc.right), arc.number};
}

// The next edges, from `from` on; the number of the one after them.
std::uint32_t gather(const ConvexHull& hull, const Masks& masks, std::uint32_t from,
                     Arcs& arcs) noexcept {
  arcs.size = 0;
  for (; from < hull.edges().size() && arcs.size < Arcs::kMost; ++from) {
    if (!isPassedOver(hull.edges()[from], masks)) {
      arcs.list[arcs.size++] = arcOf(hull, from);
    }
  }
  return from;
}

// Each arc's ends lie on both sides of the other's great circle, and on the same half.
bool cross(const Arc& a, const Arc& b) noexcept {
  const double left_of_b = along(a.edge, b.left);
  const double right_of_b = along(a.edge, b.right);
  const double left_of_a = along(b.edge, a.left);
  const double right_of_a = along(b.edge, a.right);
  return left_of_b * right_of_b < 0.0 && left_of_a * right_of_a < 0.0 &&
         left_of_b * right_of_a > 0.0;
}

// Perpendicular to both edges however small their angle.
bool axisOf(const Arc& a, const Arc& b, Vector3d& axis) noexcept {
  constexpr double kParallelEdges = 1e-12;
  const Vector3d along_a = a.edge.normalized();
  Vector3d across = b.edge.normalized();
  across -= along_a.dot(across) * along_a;
  across -= along_a.dot(across) * along_a;
  const double sine = across.norm();
  if (sine < kParallelEdges) {
    return false;
  }
  axis = along_a.cross(across / sine);
  if (axis.dot(a.left + a.right) < 0.0) {
    axis = -axis;
  }
  return true;
}

void crossAll(const Arcs& of_a, const Arcs& of_b, HullAxis& best) noexcept {
  Vector3d axis;
  for (std::size_t j = 0; j < of_b.size; ++j) {
    const Arc& b = of_b.list[j];
    for (std::size_t i = 0; i < of_a.size; ++i) {
      const Arc& a = of_a.list[i];
      if (cross(a, b) && axisOf(a, b, axis)) {
        offer({axis.dot(b.point - a.point), axis, Kind::edges, a.number, b.number}, best);
      }
    }
  }
}

// `best` is the best face of both.
void searchEdges(const View& from_a, const Known& of_b, const Known& of_a,
                 HullAxis& best) noexcept {
  const ConvexHull& a = from_a.owner;
  const ConvexHull& b = from_a.other;
  const double below = std::min(best.separation, 0.0);
  Masks masks_a;
  Masks masks_b;
  maskFaces(a, of_b, below, masks_a);
  maskFaces(b, of_a, below, masks_b);
  Arcs arcs_a;
  Arcs arcs_b;
  for (std::uint32_t j = 0; j < b.edges().size();) {
    j = gather(b, masks_b, j, arcs_b);
    for (std::size_t k = 0; k < arcs_b.size; ++k) {
      arcs_b.list[k] = opposite(arcs_b.list[k], from_a.owner_from_other);
    }
    for (std::uint32_t i = 0; arcs_b.size > 0 && i < a.edges().size();) {
      i = gather(a, masks_a, i, arcs_a);
      crossAll(arcs_a, arcs_b, best);
    }
  }
}

}  // namespace

HullAxis bestAxis(const ConvexHull& a, const ConvexHull& b, const Pose& a_from_b,
                  double enough) noexcept {
  const View from_a{a, b, a_from_b};
  FaceSearch of_b;
  HullAxis best;
  searchFaces(from_a, of_b, best);
  if (best.separation >= enough) {
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
  if (best.separation < enough) {
    searchEdges(from_a, of_b.known, of_a.known, best);
  }
  return best;
}

HullAxis separateHulls(const ConvexHull& a, const Pose& world_from_a, const ConvexHull& b,
                       const Pose& world_from_b) noexcept {
  HullAxis best = bestAxis(a, b, relativePose(world_from_a, world_from_b));
  best.direction = world_from_a.rotation * best.direction;
  return best;
}

}  // namespace collision_monitor
