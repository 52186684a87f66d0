// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/hulls/planar_hull.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>

namespace collision_monitor {
namespace {

/// Twice the signed area of a triangle; > 0 when a, b, c turn left.
double turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

}  // namespace

std::vector<std::uint32_t> convexPolygonOf(const std::vector<Eigen::Vector2d>& points) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return points[a].x() != points[b].x() ? points[a].x() < points[b].x()
                                          : points[a].y() < points[b].y();
  });
  std::vector<std::uint32_t> chain;
  const auto extend = [&](std::size_t fixed, std::uint32_t next) {
    while (chain.size() >= fixed + 2 &&
           turn(points[chain[chain.size() - 2]], points[chain.back()], points[next]) <= 0.0) {
      chain.pop_back();
    }
    chain.push_back(next);
  };
  for (const auto next : order) {
    extend(0, next);
  }
  const std::size_t lower_size = chain.size() - 1;
  for (auto next = order.rbegin() + 1; next < order.rend(); ++next) {
    extend(lower_size, *next);
  }
  if (chain.size() > 1) {
    chain.pop_back();  // the first point again
  }
  return chain;
}

std::vector<std::array<std::uint32_t, 3>> planarHull(const std::vector<Eigen::Vector3d>& points,
                                                     const Eigen::Vector3d& normal) {
  const Eigen::Vector3d u = normal.unitOrthogonal();
  const Eigen::Vector3d v = normal.cross(u);
  std::vector<Eigen::Vector2d> flat;
  flat.reserve(points.size());
  for (const auto& p : points) {
    // Relative to the first point, so that a far origin costs no digits.
    flat.emplace_back(u.dot(p - points[0]), v.dot(p - points[0]));
  }
  const auto polygon = convexPolygonOf(flat);
  std::vector<std::array<std::uint32_t, 3>> faces;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    faces.push_back({polygon[0], polygon[i - 1], polygon[i]});
    faces.push_back({polygon[0], polygon[i], polygon[i - 1]});
  }
  return faces;
}

}  // namespace collision_monitor
