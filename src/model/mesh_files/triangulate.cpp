// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/mesh_files/triangulate.h"

#include <Eigen/Geometry>

namespace collision_monitor {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;
using Points = std::vector<Eigen::Vector2d>;

Eigen::Vector3d meanNormal(const std::vector<Eigen::Vector3d>& polygon) {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    // Relative to one corner: far from the origin the products would cancel.
    normal += (polygon[i] - polygon[0]).cross(polygon[(i + 1) % polygon.size()] - polygon[0]);
  }
  return normal;
}

/// The polygon projected along its normal; it runs counter-clockwise.
Points projected(const std::vector<Eigen::Vector3d>& polygon) {
  const Eigen::Vector3d normal = meanNormal(polygon);
  Eigen::Index dropped = 0;
  normal.cwiseAbs().maxCoeff(&dropped);
  const Eigen::Index first = (dropped + 1) % 3;
  const Eigen::Index second = (dropped + 2) % 3;
  const double sign = normal[dropped] < 0.0 ? -1.0 : 1.0;
  Points points;
  for (const Eigen::Vector3d& corner : polygon) {
    points.emplace_back(sign * corner[first], corner[second]);
  }
  return points;
}

/// Twice the area of a triangle, positive if it runs counter-clockwise.
double orientation(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

bool isInside(const Points& points, const std::array<std::uint32_t, 3>& ear, std::uint32_t i) {
  const Eigen::Vector2d& p = points[i];
  const Eigen::Vector2d& a = points[ear[0]];
  const Eigen::Vector2d& b = points[ear[1]];
  const Eigen::Vector2d& c = points[ear[2]];
  // A corner that occurs twice, where a hole is joined to the outline, is not in the way.
  return p != a && p != b && p != c && orientation(a, b, p) >= 0.0 && orientation(b, c, p) >= 0.0 &&
         orientation(c, a, p) >= 0.0;
}

bool isEar(const Points& points, const std::vector<std::uint32_t>& left,
           const std::array<std::uint32_t, 3>& ear) {
  const double area = orientation(points[ear[0]], points[ear[1]], points[ear[2]]);
  if (area <= 0.0) {
    return area == 0.0;  // cutting off a corner on a straight edge removes no area
  }
  for (const std::uint32_t i : left) {
    if (isInside(points, ear, i)) {
      return false;
    }
  }
  return true;
}

/// Clips ears until one triangle is left; false if no ear is found.
///
/// The signed areas of the triangles add up to the winding number of the polygon at every point.
/// All ears are positive, so together they cover exactly the points where it is above 0.
bool clipEars(const Points& points, Triangles& triangles) {
  std::vector<std::uint32_t> left;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    left.push_back(i);
  }
  while (left.size() > 2) {
    bool is_clipped = false;
    for (std::size_t i = 0; i < left.size() && !is_clipped; ++i) {
      const std::array<std::uint32_t, 3> ear{left[i], left[(i + 1) % left.size()],
                                             left[(i + 2) % left.size()]};
      if (isEar(points, left, ear)) {
        triangles.push_back(ear);
        left.erase(left.begin() + static_cast<std::ptrdiff_t>((i + 1) % left.size()));
        is_clipped = true;
      }
    }
    if (!is_clipped) {
      return false;
    }
  }
  return true;
}

}  // namespace

Triangles triangulate(const std::vector<Eigen::Vector3d>& polygon) {
  Triangles triangles;
  if (polygon.size() == 3) {
    return {{0, 1, 2}};
  }
  if (clipEars(projected(polygon), triangles)) {
    return triangles;
  }
  // The polygon crosses itself. The triangles of a fan have both signs but add up to the same
  // winding number, so they cover every point where it is not 0.
  triangles.clear();
  for (std::uint32_t i = 2; i < polygon.size(); ++i) {
    triangles.push_back({0, i - 1, i});
  }
  return triangles;
}

}  // namespace collision_monitor
