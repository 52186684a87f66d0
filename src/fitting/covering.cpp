// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/fitting/covering.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "collision_monitor/fitting/proof.h"
#include "fitting/surrounding_mesh.h"

namespace collision_monitor {
namespace {

using Corners = std::array<Eigen::Vector3d, 3>;

constexpr std::size_t kMaxParts = 4'000'000;
// Growths that are tried, as parts of the greatest.
constexpr double kGrowths[] = {0.0, 1e-4, 1e-3, 1e-2, 1e-1, 1.0};

TriangleMesh prismAround(const Cylinder& cylinder) {
  constexpr std::uint32_t kSides = 1024;
  constexpr double kPi = 3.14159265358979323846;
  const double radius = (1.0 + 1e-14) * cylinder.radius / std::cos(kPi / kSides);
  TriangleMesh mesh;
  for (std::uint32_t side = 0; side < kSides; ++side) {
    const double angle = 2.0 * kPi * side / kSides;
    const double x = radius * std::cos(angle);
    const double y = radius * std::sin(angle);
    mesh.vertices.emplace_back(x, y, -cylinder.half_length);
    mesh.vertices.emplace_back(x, y, cylinder.half_length);
    const std::uint32_t low = 2 * side;
    const std::uint32_t next = 2 * ((side + 1) % kSides);
    mesh.triangles.push_back({low, next, low + 1});
    mesh.triangles.push_back({next, next + 1, low + 1});
    mesh.triangles.push_back({0, next, low});
    mesh.triangles.push_back({1, low + 1, next + 1});
  }
  return mesh;
}

struct ToMesh {
  TriangleMesh operator()(const Sphere& sphere) const {
    return surroundingMesh(Capsule{0.0, sphere.radius});
  }
  TriangleMesh operator()(const Capsule& capsule) const { return surroundingMesh(capsule); }
  TriangleMesh operator()(const Box& box) const { return surroundingMesh(box); }
  TriangleMesh operator()(const Cylinder& cylinder) const { return prismAround(cylinder); }
  TriangleMesh operator()(const TriangleMesh& mesh) const { return mesh; }
};

/// In the link frame.
TriangleMesh meshOf(const PlacedGeometry& placed) {
  TriangleMesh mesh = std::visit(ToMesh{}, *placed.geometry);
  for (Eigen::Vector3d& vertex : mesh.vertices) {
    vertex = placed.link_from_geometry * vertex;
  }
  return mesh;
}

/// What bounds the error of a distance from a shape to any point between the given ones: the
/// rounding that provenExcess allows for, twice, as the points were moved before, and that of
/// halving a few dozen times.
double slackOf(const PosedShape& shape, const Points& points) {
  const double allowed = provenExcess(shape, points) - excessOver(shape, points);
  double extent = 0.0;
  for (const Eigen::Vector3d& point : points) {
    extent = std::max(extent, point.norm());
  }
  return 2.0 * allowed + 64.0 * std::numeric_limits<double>::epsilon() * extent;
}

/// A union of shapes, held against points and triangles between given points.
class Union {
 public:
  Union(const std::vector<PosedShape>& shapes, double growth, const Points& points) {
    for (const PosedShape& shape : shapes) {
      shapes_.push_back({grown(shape.shape, growth), shape.geometry_from_body});
      slacks_.push_back(slackOf(shapes_.back(), points));
    }
  }

  /// Upper bound of the distance to the union; <= 0 proves the point inside.
  double excessOf(const Eigen::Vector3d& point) const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < shapes_.size(); ++i) {
      least = std::min(least, excessOver(i, point));
    }
    return least;
  }

  bool holdInOne(const Corners& corners) const {
    for (std::size_t i = 0; i < shapes_.size(); ++i) {
      if (std::all_of(corners.begin(), corners.end(), [&](const Eigen::Vector3d& corner) {
            return excessOver(i, corner) <= 0.0;
          })) {
        return true;
      }
    }
    return false;
  }

 private:
  double excessOver(std::size_t i, const Eigen::Vector3d& point) const {
    const Pose& pose = shapes_[i].geometry_from_body;
    return signedDistanceTo(shapes_[i].shape,
                            pose.rotation.transpose() * (point - pose.translation)) +
           slacks_[i];
  }

  std::vector<PosedShape> shapes_;
  std::vector<double> slacks_;
};

/// The two halves, cut at the longest edge.
std::array<Corners, 2> halvesOf(const Corners& corners, double& longest) {
  std::size_t edge = 0;
  longest = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double length = (corners[i] - corners[(i + 1) % 3]).norm();
    if (length > longest) {
      longest = length;
      edge = i;
    }
  }
  const Eigen::Vector3d& a = corners[edge];
  const Eigen::Vector3d& b = corners[(edge + 1) % 3];
  const Eigen::Vector3d& c = corners[(edge + 2) % 3];
  const Eigen::Vector3d middle = 0.5 * (a + b);
  return {Corners{a, middle, c}, Corners{middle, b, c}};
}

/// Keeps the point if it lies farther outside than those before.
void note(const Eigen::Vector3d& point, double excess, Covering& covering) {
  if (excess > covering.excess) {
    covering.excess = excess;
    covering.farthest = point;
  }
}

/// Whether every triangle lies in the union; parts below `least_size` are given up.
bool coversTriangles(const Union& shapes, const TriangleMesh& mesh, double least_size,
                     Covering& covering) {
  std::size_t part_count = 0;
  std::vector<Corners> open;
  for (const auto& triangle : mesh.triangles) {
    open.push_back(
        {mesh.vertices[triangle[0]], mesh.vertices[triangle[1]], mesh.vertices[triangle[2]]});
    while (!open.empty()) {
      const Corners part = open.back();
      open.pop_back();
      if (shapes.holdInOne(part)) {
        continue;
      }
      double size = 0.0;
      const std::array<Corners, 2> halves = halvesOf(part, size);
      const Eigen::Vector3d& middle = halves[1][0];
      const double excess = shapes.excessOf(middle);
      if (excess > 0.0 || size < least_size || ++part_count > kMaxParts) {
        note(middle, excess > 0.0 ? excess : size, covering);
        return false;
      }
      open.insert(open.end(), halves.begin(), halves.end());
    }
  }
  return true;
}

/// How far the vertices lie outside the shapes as they are.
double worstVertex(const std::vector<PosedShape>& shapes, const TriangleMesh& mesh,
                   Covering& covering) {
  const Union as_given(shapes, 0.0, mesh.vertices);
  double worst = 0.0;
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    const double excess = as_given.excessOf(vertex);
    worst = std::max(worst, excess);
    note(vertex, excess, covering);
  }
  return worst;
}

/// A ball lies in a convex shape with its centre and its radius to spare; the capsule follows.
double excessOfRound(const Capsule& capsule, const Pose& pose, const PosedShape& shape) {
  const Eigen::Vector3d half_axis = capsule.half_length * pose.rotation.col(2);
  const Points ends{pose.translation + half_axis, pose.translation - half_axis};
  return excessOver(shape, ends) + slackOf(shape, ends) +
         capsule.radius * (1.0 + 4.0 * std::numeric_limits<double>::epsilon());
}

/// How far a sphere or capsule lies outside the one shape that holds it best; infinity for others.
double excessInOne(const PlacedGeometry& placed, const std::vector<PosedShape>& shapes) {
  const auto* sphere = std::get_if<Sphere>(placed.geometry);
  const auto* capsule = std::get_if<Capsule>(placed.geometry);
  double least = std::numeric_limits<double>::infinity();
  for (const PosedShape& shape : shapes) {
    if (sphere != nullptr || capsule != nullptr) {
      const Capsule round = sphere != nullptr ? Capsule{0.0, sphere->radius} : *capsule;
      least = std::min(least, excessOfRound(round, placed.link_from_geometry, shape));
    }
  }
  return least;
}

/// The growth with which one geometry is covered; none where it is more than `max_widening`.
Covering coverOne(const PlacedGeometry& placed, const std::vector<PosedShape>& shapes,
                  double max_widening) {
  Covering covering;
  const double excess_in_one = excessInOne(placed, shapes);
  if (excess_in_one <= max_widening) {
    covering.is_proven = true;
    // A shape that grows gains a little rounding, too.
    covering.widening = excess_in_one > 0.0 ? excess_in_one + kGrowths[1] * max_widening : 0.0;
    return covering;
  }
  const TriangleMesh mesh = meshOf(placed);
  const double needed = worstVertex(shapes, mesh, covering);
  for (const double fraction : kGrowths) {
    const double growth = fraction * max_widening;
    if (growth >= needed) {
      Covering attempt;
      if (coversTriangles(Union(shapes, growth, mesh.vertices), mesh, 0.25 * max_widening,
                          attempt)) {
        return {true, growth, Eigen::Vector3d::Zero(), 0.0, 0};
      }
      note(attempt.farthest, attempt.excess, covering);
    }
  }
  if (shapes.size() == 1 && std::isfinite(excess_in_one)) {
    // Nearer the truth than the polyhedron around the round geometry.
    covering.excess = excess_in_one;
  }
  return covering;
}

}  // namespace

Covering proveCovering(const std::vector<PlacedGeometry>& geometries,
                       const std::vector<PosedShape>& shapes, double max_widening) {
  Covering all;
  all.is_proven = true;
  for (std::size_t i = 0; i < geometries.size(); ++i) {
    Covering one = coverOne(geometries[i], shapes, max_widening);
    one.geometry = i;
    if (!one.is_proven && (all.is_proven || one.excess > all.excess)) {
      all = one;
    } else if (all.is_proven) {
      all.widening = std::max(all.widening, one.widening);
    }
  }
  return all;
}

}  // namespace collision_monitor
