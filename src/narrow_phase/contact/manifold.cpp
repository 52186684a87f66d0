// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/contact/manifold.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "narrow_phase/closed_form/core_distance.h"
#include "narrow_phase/contact/manifold_points.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

// For edges that count as parallel. Other edges cross at one point.
constexpr EdgeSlack kParallelEdges{1e-4, 1e-4};

std::size_t dimensionOf(std::size_t corner_count) noexcept {
  return std::min<std::size_t>(corner_count, 3) - 1;
}

ContactFeature featureOf(std::size_t dimension_a, std::size_t dimension_b) noexcept {
  constexpr ContactFeature kFeatures[3][3] = {
      {ContactFeature::vertex_vertex, ContactFeature::vertex_edge, ContactFeature::vertex_face},
      {ContactFeature::vertex_edge, ContactFeature::edge_edge, ContactFeature::edge_face},
      {ContactFeature::vertex_face, ContactFeature::edge_face, ContactFeature::face_face}};
  return kFeatures[dimension_a][dimension_b];
}

Vector3d unitNormalOf(const ContactPatch& face) noexcept {
  Vector3d sum = Vector3d::Zero();
  for (std::size_t i = 2; i < face.size; ++i) {
    sum += (face.corners[i - 1] - face.corners[0]).cross(face.corners[i] - face.corners[0]);
  }
  return sum.normalized();
}

// True if A's face clips B's. Chooses the same face if A and B are exchanged, unless they are
// alike.
bool clipsOther(const ContactPatch& a, const ContactPatch& b, const Vector3d& normal) noexcept {
  if (a.size < 3 || b.size < 3) {
    return a.size >= 3;
  }
  constexpr double kAlike = 1e-9;
  const double square_a = std::abs(unitNormalOf(a).dot(normal));
  const double square_b = std::abs(unitNormalOf(b).dot(normal));
  if (std::abs(square_a - square_b) > kAlike) {
    return square_a > square_b;
  }
  const auto extentOf = [](const ContactPatch& face) {
    return (face.corners[2] - face.corners[0]).squaredNorm();
  };
  return extentOf(a) >= extentOf(b);
}

// Adds the points of the other feature over the face, each with the face's point along the normal.
void clipByFace(const ContactPatch& face, const ContactPatch& other, const Vector3d& normal,
                ManifoldPoints& points) noexcept {
  const Vector3d across = unitNormalOf(face);
  const double square = across.dot(normal);
  ClippedPolygon polygon;
  for (std::size_t i = 0; i < other.size; ++i) {
    polygon.add(other.corners[i]);
  }
  for (std::size_t i = 0; i < face.size; ++i) {
    const Vector3d& corner = face.corners[i];
    const Vector3d along = face.corners[(i + 1) % face.size] - corner;
    cut(along.cross(signOf(square) * normal), corner, polygon);
  }
  for (std::size_t i = 0; i < polygon.size; ++i) {
    const Vector3d& on_b = polygon.corners[i];
    const double distance = (on_b - face.corners[0]).dot(across) / square;
    points.add({on_b - distance * normal, on_b, distance});
  }
}

// Adds the two ends of the common part of nearly parallel edges.
void clipEdges(const ContactPatch& a, const ContactPatch& b, const Vector3d& normal,
               const EdgeSlack& slack, ManifoldPoints& points) noexcept {
  const Vector3d along_a = a.corners[1] - a.corners[0];
  const Vector3d along_b = b.corners[1] - b.corners[0];
  if (along_a.cross(along_b).norm() > slack.sine * along_a.norm() * along_b.norm()) {
    return;
  }
  const double squared_length = along_a.squaredNorm();
  const double first = along_a.dot(b.corners[0] - a.corners[0]) / squared_length;
  const double last = along_a.dot(b.corners[1] - a.corners[0]) / squared_length;
  const double low = std::max(0.0, std::min(first, last));
  const double high = std::min(1.0, std::max(first, last));
  for (const double parameter : {low, high}) {
    const Vector3d on_a = a.corners[0] + parameter * along_a;
    const Vector3d on_b = b.corners[0] + (parameter - first) / (last - first) * along_b;
    const double distance = (on_b - on_a).dot(normal);
    if (low < high && (on_b - on_a - distance * normal).norm() <= slack.sideways) {
      points.add({on_a, on_b, distance});
    }
  }
}

ManifoldPoint swappedPoint(const ManifoldPoint& point) noexcept {
  return {point.point_on_b, point.point_on_a, point.distance};
}

// Names the features by what clipping left: a tilted face touches with an edge or a corner.
ContactFeature nameContact(const ContactPatch& a, const ContactPatch& b, const Vector3d& normal,
                           std::size_t point_count) noexcept {
  const std::size_t left = dimensionOf(point_count);
  std::size_t dimension_a = dimensionOf(a.size);
  std::size_t dimension_b = dimensionOf(b.size);
  if (dimension_a == 2 && dimension_b == 2) {
    (clipsOther(a, b, normal) ? dimension_b : dimension_a) = left;
  }
  return featureOf(dimension_a, dimension_b);
}

}  // namespace

const char* nameOf(ContactFeature feature) noexcept {
  constexpr const char* kNames[] = {"vertex_vertex", "vertex_edge", "vertex_face",
                                    "edge_edge",     "edge_face",   "face_face"};
  return kNames[static_cast<std::size_t>(feature)];
}

ManifoldPoints facingPoints(const ContactPatch& a, const ContactPatch& b, const Vector3d& normal,
                            const EdgeSlack& slack) noexcept {
  ManifoldPoints points;
  if (a.size == 2 && b.size == 2) {
    clipEdges(a, b, normal, slack, points);
  } else if (a.size >= 2 && b.size >= 2) {
    const bool is_a = clipsOther(a, b, normal);
    clipByFace(is_a ? a : b, is_a ? b : a, is_a ? normal : Vector3d(-normal), points);
    for (std::size_t i = 0; !is_a && i < points.size; ++i) {
      points.points[i] = swappedPoint(points.points[i]);
    }
  }
  return points;
}

ContactManifold manifoldOf(const ContactPatch& on_a, const ContactPatch& on_b,
                           const SignedDistance& measured) noexcept {
  ContactManifold manifold;
  manifold.normal_a_to_b = measured.normal_a_to_b;
  ManifoldPoints points = facingPoints(on_a, on_b, measured.normal_a_to_b, kParallelEdges);
  dropFarther(measured.distance + kPatchDepth, points);
  if (points.size == 0) {
    points.add({measured.point_on_a, measured.point_on_b, measured.distance});
    manifold.feature = featureOf(dimensionOf(on_a.size), dimensionOf(on_b.size));
  } else {
    manifold.feature = nameContact(on_a, on_b, measured.normal_a_to_b, points.size);
  }
  spreadOut(points, manifold);
  return manifold;
}

ContactManifold manifoldBetween(const Shape& a, const Pose& world_from_a, const Shape& b,
                                const Pose& world_from_b, const SignedDistance& measured) noexcept {
  return manifoldOf(extremePatch(a, world_from_a, measured.normal_a_to_b),
                    extremePatch(b, world_from_b, -measured.normal_a_to_b), measured);
}

}  // namespace collision_monitor
