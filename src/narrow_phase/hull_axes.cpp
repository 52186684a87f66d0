// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/narrow_phase/hull_axes.h"

#include <Eigen/Geometry>
#include <cmath>

namespace collision_monitor {
namespace {

using Kind = HullAxis::Kind;
constexpr double kParallelEdges = 1e-12;

void offer(const HullAxis& candidate, HullAxis& best) noexcept {
  if (candidate.separation > best.separation) {
    best = candidate;
  }
}

// In the frame of `owner`; the axis leads away from it.
HullAxis bestFace(const ConvexHull& owner, const ConvexHull& other,
                  const Pose& owner_from_other) noexcept {
  HullAxis best;
  std::uint32_t vertex = 0;
  for (std::uint32_t f = 0; f < owner.faces().size(); ++f) {
    const ConvexHull::Face& face = owner.faces()[f];
    vertex = other.supportVertex(owner_from_other.rotation.transpose() * -face.normal, vertex);
    const Eigen::Vector3d lowest = owner_from_other * other.vertices()[vertex];
    offer({face.normal.dot(lowest) - face.offset, face.normal, Kind::face_of_a, f, vertex}, best);
  }
  return best;
}

// An edge and the normals of the faces beside it, in A's frame. On the Gauss map it is the arc
// from one normal to the other.
struct Arc {
  Eigen::Vector3d point;
  Eigen::Vector3d edge;  // any length, along left x right or against it
  Eigen::Vector3d left;
  Eigen::Vector3d right;
};

Arc arcOf(const ConvexHull& hull, const ConvexHull::Edge& edge) noexcept {
  Arc arc{hull.vertices()[edge.from], hull.vertices()[edge.to] - hull.vertices()[edge.from],
          hull.faces()[edge.left].normal, hull.faces()[edge.right].normal};
  if (arc.edge.dot(arc.left.cross(arc.right)) < 0.0) {
    arc.edge = -arc.edge;
  }
  return arc;
}

// The arc of a face pair of B as seen by A's outward normals.
Arc opposite(const Arc& arc, const Pose& a_from_b) noexcept {
  return {a_from_b * arc.point, a_from_b.rotation * arc.edge, -(a_from_b.rotation * arc.left),
          -(a_from_b.rotation * arc.right)};
}

// Each arc's ends lie on both sides of the other's great circle, and on the same half.
bool cross(const Arc& a, const Arc& b) noexcept {
  const double left_of_b = a.edge.dot(b.left);
  const double right_of_b = a.edge.dot(b.right);
  const double left_of_a = b.edge.dot(a.left);
  const double right_of_a = b.edge.dot(a.right);
  return left_of_b * right_of_b < 0.0 && left_of_a * right_of_a < 0.0 &&
         left_of_b * right_of_a > 0.0;
}

// Perpendicular to both edges however small their angle.
bool axisOf(const Arc& a, const Arc& b, Eigen::Vector3d& axis) noexcept {
  const Eigen::Vector3d along = a.edge.normalized();
  Eigen::Vector3d across = b.edge.normalized();
  across -= along.dot(across) * along;
  across -= along.dot(across) * along;
  const double sine = across.norm();
  if (sine < kParallelEdges) {
    return false;
  }
  axis = along.cross(across / sine);
  if (axis.dot(a.left + a.right) < 0.0) {
    axis = -axis;
  }
  return true;
}

HullAxis bestEdges(const ConvexHull& a, const ConvexHull& b, const Pose& a_from_b) noexcept {
  HullAxis best;
  Eigen::Vector3d axis;
  for (std::uint32_t j = 0; j < b.edges().size(); ++j) {
    const Arc of_b = opposite(arcOf(b, b.edges()[j]), a_from_b);
    for (std::uint32_t i = 0; i < a.edges().size(); ++i) {
      const Arc of_a = arcOf(a, a.edges()[i]);
      if (cross(of_a, of_b) && axisOf(of_a, of_b, axis)) {
        offer({axis.dot(of_b.point - of_a.point), axis, Kind::edges, i, j}, best);
      }
    }
  }
  return best;
}

}  // namespace

HullAxis separateHulls(const ConvexHull& a, const Pose& world_from_a, const ConvexHull& b,
                       const Pose& world_from_b) noexcept {
  const Pose a_from_b = inverse(world_from_a) * world_from_b;
  HullAxis best = bestFace(a, b, a_from_b);
  HullAxis of_b = bestFace(b, a, inverse(a_from_b));
  of_b = {of_b.separation, a_from_b.rotation * -of_b.direction, Kind::face_of_b, of_b.feature_of_b,
          of_b.feature_of_a};
  offer(of_b, best);
  offer(bestEdges(a, b, a_from_b), best);
  best.direction = world_from_a.rotation * best.direction;
  return best;
}

}  // namespace collision_monitor
