// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/sat/hull_arcs.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

namespace collision_monitor {
namespace {

using Eigen::Vector3d;
using Kind = HullAxis::Kind;

// By face: a bit for each known point that is at least as far below it as asked for.
using Masks = std::array<std::uint8_t, kMostAxisFaces>;

void maskFaces(const ConvexHull& owner, const KnownPoints& known, double below,
               Masks& masks) noexcept {
  const std::size_t count = std::min(owner.faces().size(), kMostAxisFaces);
  for (std::size_t f = 0; f < count; ++f) {
    const Eigen::Array4d heights = known.above(owner.faces()[f]);
    unsigned mask = 0;
    for (unsigned i = 0; i < 4; ++i) {
      mask |= heights[i] <= below ? 1U << i : 0U;
    }
    masks[f] = static_cast<std::uint8_t>(mask);
  }
}

// True if no axis that touches only the edge separates by more than the height of the masks, which
// is not positive. A point that far below both faces of the edge is at least as far below any plane
// between them: the plane's normal is a sum of theirs, lengthened to unit.
bool isPassedOver(const ConvexHull::Edge& edge, const Masks& masks) noexcept {
  return edge.left < kMostAxisFaces && edge.right < kMostAxisFaces &&
         (masks[edge.left] & masks[edge.right]) != 0;
}

// An edge and the normals of its two faces, in A's frame. On the Gauss map it is the arc from one
// normal to the other.
struct Arc {
  Vector3d point;
  Vector3d edge;  // any length, along left x right
  Vector3d left;
  Vector3d right;
  std::uint32_t number;
};

// Some of the edges of a hull that are not passed over.
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

// An arc of B, negated, so that it compares with arcs of A's outward normals.
Arc opposite(const Arc& arc, const Pose& a_from_b) noexcept {
  return {a_from_b * arc.point, a_from_b.rotation * arc.edge, -(a_from_b.rotation * arc.left),
          -(a_from_b.rotation * arc.right), arc.number};
}

// Collects edges from `from` on. Returns the number of the edge after them.
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

// True if the ends of each arc lie on both sides of the other's great circle, and on the same half.
bool cross(const Arc& a, const Arc& b) noexcept {
  const double left_of_b = along(a.edge, b.left);
  const double right_of_b = along(a.edge, b.right);
  const double left_of_a = along(b.edge, a.left);
  const double right_of_a = along(b.edge, a.right);
  return left_of_b * right_of_b < 0.0 && left_of_a * right_of_a < 0.0 &&
         left_of_b * right_of_a > 0.0;
}

// Finds the axis perpendicular to both edges, however small their angle. False if parallel.
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

}  // namespace

void searchEdges(const KnownHull& a, const KnownHull& b, const Pose& a_from_b,
                 HullAxis& best) noexcept {
  const double below = std::min(best.separation, 0.0);
  Masks masks_a;
  Masks masks_b;
  maskFaces(a.hull, a.other, below, masks_a);
  maskFaces(b.hull, b.other, below, masks_b);
  Arcs arcs_a;
  Arcs arcs_b;
  for (std::uint32_t j = 0; j < b.hull.edges().size();) {
    j = gather(b.hull, masks_b, j, arcs_b);
    for (std::size_t k = 0; k < arcs_b.size; ++k) {
      arcs_b.list[k] = opposite(arcs_b.list[k], a_from_b);
    }
    for (std::uint32_t i = 0; arcs_b.size > 0 && i < a.hull.edges().size();) {
      i = gather(a.hull, masks_a, i, arcs_a);
      crossAll(arcs_a, arcs_b, best);
    }
  }
}

}  // namespace collision_monitor
