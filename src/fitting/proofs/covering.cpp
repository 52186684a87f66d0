// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/proofs/covering.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "fitting/proofs/shape_union.h"
#include "fitting/proofs/surrounding_mesh.h"
#include "geometry/constants.h"

namespace collision_monitor {
namespace {

constexpr std::size_t kMaxParts = 4'000'000;
// Growths to try, as fractions of the greatest.
constexpr double kGrowths[] = {0.0, 1e-4, 1e-3, 1e-2, 1e-1, 1.0};

TriangleMesh prismAround(const Cylinder& cylinder) {
  constexpr std::uint32_t kSides = 1024;
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

/// The mesh of a geometry in the link frame.
TriangleMesh meshOf(const PlacedGeometry& placed) {
  TriangleMesh mesh = std::visit(ToMesh{}, *placed.geometry);
  for (Eigen::Vector3d& vertex : mesh.vertices) {
    vertex = placed.link_from_geometry * vertex;
  }
  return mesh;
}

/// A cut of a triangle through a point of an edge and the opposite corner.
struct Cut {
  std::size_t from{0};
  std::size_t to{1};
  double fraction{0.5};
};

double lengthOf(const Corners& corners, std::size_t i, std::size_t j) {
  return (corners[i] - corners[j]).norm();
}

Cut halveLongestEdge(const Corners& corners) {
  Cut cut;
  for (std::size_t i = 0; i < 3; ++i) {
    if (lengthOf(corners, i, (i + 1) % 3) > lengthOf(corners, cut.from, cut.to)) {
      cut = {i, (i + 1) % 3, 0.5};
    }
  }
  return cut;
}

/// Cuts where the shape that holds most corners ends. Two such cuts leave one part in this shape,
/// and the rest in the next shape where both overlap. Halving alone would need parts as small as
/// the overlap, all along the seam.
Cut chooseCut(const ShapeUnion& shapes, const Corners& corners) {
  constexpr std::array<int, 8> kBitCount{0, 1, 1, 2, 1, 2, 2, 3};
  std::size_t best = 0;
  unsigned held = 0;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const unsigned mask = shapes.heldBy(i, corners);
    if (kBitCount[mask] > kBitCount[held]) {
      best = i;
      held = mask;
    }
  }
  Cut cut = halveLongestEdge(corners);
  double longest = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const bool leaves = (held >> i & 1U) != 0 && (held >> j & 1U) == 0;
      if (leaves && lengthOf(corners, i, j) > longest) {
        const double reach = shapes.reachAlong(best, corners[i], corners[j]);
        // A corner on the shape's surface gives no useful cut.
        constexpr double kLeastReach = 1e-3;
        longest = reach > kLeastReach ? lengthOf(corners, i, j) : longest;
        cut = reach > kLeastReach ? Cut{i, j, reach} : cut;
      }
    }
  }
  return cut;
}

bool holdInOne(const ShapeUnion& shapes, const Corners& corners) {
  constexpr unsigned kAll = 7;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    if (shapes.heldBy(i, corners) == kAll) {
      return true;
    }
  }
  return false;
}

/// Keeps the point if it lies farther outside than all before.
void note(const Eigen::Vector3d& point, double excess, Covering& covering) {
  if (excess > covering.excess) {
    covering.excess = excess;
    covering.farthest = point;
  }
}

/// Whether every triangle lies in the union. Gives up at parts below `least_size`.
bool coversTriangles(const ShapeUnion& shapes, const TriangleMesh& mesh, double least_size,
                     Covering& covering) {
  std::size_t part_count = 0;
  std::vector<Corners> open;
  for (const auto& triangle : mesh.triangles) {
    open.push_back(
        {mesh.vertices[triangle[0]], mesh.vertices[triangle[1]], mesh.vertices[triangle[2]]});
    while (!open.empty()) {
      const Corners part = open.back();
      open.pop_back();
      if (holdInOne(shapes, part)) {
        continue;
      }
      const Cut cut = chooseCut(shapes, part);
      const Eigen::Vector3d middle =
          part[cut.from] + cut.fraction * (part[cut.to] - part[cut.from]);
      const double excess = shapes.excessOf(middle);
      const Cut longest = halveLongestEdge(part);
      const double size = lengthOf(part, longest.from, longest.to);
      if (excess > 0.0 || size < least_size || ++part_count > kMaxParts) {
        note(middle, excess > 0.0 ? excess : size, covering);
        return false;
      }
      const Eigen::Vector3d& across = part[3 - cut.from - cut.to];
      open.push_back({part[cut.from], middle, across});
      open.push_back({middle, part[cut.to], across});
    }
  }
  return true;
}

/// The greatest distance of a vertex outside the shapes, without growth.
double worstVertex(const std::vector<PosedShape>& shapes, const TriangleMesh& mesh,
                   Covering& covering) {
  const ShapeUnion as_given(shapes, 0.0, mesh.vertices);
  double worst = 0.0;
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    const double excess = as_given.excessOf(vertex);
    worst = std::max(worst, excess);
    note(vertex, excess, covering);
  }
  return worst;
}

/// A convex shape holds a ball if it holds its center with the radius to spare. Capsules follow.
double excessOfRound(const Capsule& capsule, const Pose& pose, const PosedShape& shape) {
  const Eigen::Vector3d half_axis = capsule.half_length * pose.rotation.col(2);
  const Points ends{pose.translation + half_axis, pose.translation - half_axis};
  return excessOver(shape, ends) + slackOf(shape, ends) +
         capsule.radius * (1.0 + 4.0 * std::numeric_limits<double>::epsilon());
}

/// How far a sphere or capsule lies outside the single best shape; infinity for other geometries.
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

/// The growth that covers one geometry; none if it exceeds `max_widening`.
Covering coverOne(const PlacedGeometry& placed, const std::vector<PosedShape>& shapes,
                  double max_widening) {
  Covering covering;
  const double excess_in_one = excessInOne(placed, shapes);
  if (excess_in_one <= max_widening) {
    covering.is_proven = true;
    // A shape that grows gains a little rounding error, too.
    covering.widening = excess_in_one > 0.0 ? excess_in_one + kGrowths[1] * max_widening : 0.0;
    return covering;
  }
  const TriangleMesh mesh = meshOf(placed);
  const double needed = worstVertex(shapes, mesh, covering);
  for (const double fraction : kGrowths) {
    const double growth = fraction * max_widening;
    if (growth >= needed) {
      Covering attempt;
      if (coversTriangles(ShapeUnion(shapes, growth, mesh.vertices), mesh, 0.25 * max_widening,
                          attempt)) {
        return {true, growth, Eigen::Vector3d::Zero(), 0.0, 0};
      }
      note(attempt.farthest, attempt.excess, covering);
    }
  }
  if (shapes.size() == 1 && std::isfinite(excess_in_one)) {
    // This is nearer to the truth than the polyhedron around the round geometry.
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
