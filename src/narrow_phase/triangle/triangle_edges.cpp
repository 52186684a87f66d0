// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/triangle/triangle_edges.h"

#include <cmath>

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

// Squared height over base. Below it the normal is mostly rounding.
constexpr double kSliver = 1e-24;

// Middle of the part of edge A beside a parallel edge B.
double middleOfShared(const Edge& a, const Vector3d& from_a_to_b, double product) noexcept {
  if (!(a.squared_length > 0.0)) {
    return 0.0;
  }
  const double first = from_a_to_b.dot(a.along) / a.squared_length;
  const double last = first + product / a.squared_length;
  return 0.5 * (clampToUnit(first) + clampToUnit(last));
}

}  // namespace

PreparedTriangle prepare(const Triangle& triangle) noexcept {
  PreparedTriangle prepared;
  prepared.corners = triangle;
  for (std::size_t i = 0; i < 3; ++i) {
    prepared.edges[i] = makeEdge(triangle[i], triangle[(i + 1) % 3]);
  }
  prepared.based = baseOf(triangle);
  prepared.normal.setZero();
  const Vector3d height = prepared.based.height();
  if (height.squaredNorm() > kSliver * prepared.based.squared_length) {
    prepared.normal = prepared.based.along.cross(height).normalized();
  }
  return prepared;
}

void improveByEdges(const Edge& a, const Edge& b, PointPair& best) noexcept {
  const Vector3d from_a_to_b = b.start - a.start;
  const Vector3d normal = a.along.cross(b.along);
  const double squared_normal = normal.squaredNorm();
  const double product = a.along.dot(b.along);
  double on_a = 0.0;
  if (squared_normal > kParallelSquared * a.squared_length * b.squared_length) {
    // The lines are this far apart, and the edges at least as far.
    const double height = from_a_to_b.dot(normal);
    if (height * height >= best.squared_distance * squared_normal) {
      return;
    }
    on_a = clampToUnit(from_a_to_b.cross(b.along).dot(normal) / squared_normal);
  } else {
    on_a = middleOfShared(a, from_a_to_b, product);
  }
  // Makes each parameter the best for the other. The second one matters if b was clamped.
  double on_b = 0.0;
  if (b.squared_length > 0.0) {
    on_b = clampToUnit((on_a * product - from_a_to_b.dot(b.along)) / b.squared_length);
  }
  if (a.squared_length > 0.0) {
    on_a = clampToUnit((on_b * product + from_a_to_b.dot(a.along)) / a.squared_length);
  }
  const Vector3d point_on_a = a.start + on_a * a.along;
  const Vector3d point_on_b = b.start + on_b * b.along;
  const double squared_distance = (point_on_b - point_on_a).squaredNorm();
  if (squared_distance < best.squared_distance) {
    best = {squared_distance, point_on_a, point_on_b};
  }
}

void improveByFace(const PreparedTriangle& triangle, const Vector3d& point,
                   PointPair& best) noexcept {
  const double height = heightOver(triangle, point);
  if (height * height >= best.squared_distance) {
    return;
  }
  const Vector3d closest = closestOn(triangle.based, point);
  const double squared_distance = (point - closest).squaredNorm();
  if (squared_distance < best.squared_distance) {
    best = {squared_distance, closest, point};
  }
}

void improveByPiercing(const PreparedTriangle& triangle, const Vector3d& from, const Vector3d& to,
                       PointPair& best) noexcept {
  const double height_from = heightOver(triangle, from);
  const double height_to = heightOver(triangle, to);
  if (height_from * height_to <= 0.0 && height_from != height_to) {
    const double share = height_from / (height_from - height_to);
    improveByFace(triangle, from + share * (to - from), best);
  }
}

}  // namespace collision_monitor
