// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/sphere_trees/build_sphere_tree.h"

#include <algorithm>
#include <queue>
#include <stdexcept>
#include <utility>

#include "collision_monitor/geometry/ids.h"
#include "fitting/proofs/check_geometry.h"
#include "fitting/proofs/surrounding_mesh.h"
#include "fitting/search/point_cloud.h"
#include "fitting/shapes/fit_sphere.h"
#include "fitting/shapes/mesh_part.h"
#include "geometry/constants.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

constexpr int kSamples = 32;        // of a node's sphere
constexpr double kTolerance = 0.1;  // of a sample's distance

// [m] Below this a square underflows, and a computed length may be 0 although the true one is not.
constexpr double kUnderflow = 1e-150;

/// Where the part of a node can be cut, and whether it has an extent to cut.
struct Division {
  CutPlane plane;
  bool is_possible{false};
};

Division divisionOf(const Points& corners) {
  Vector3d low = corners[0];
  Vector3d high = corners[0];
  for (const auto& corner : corners) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  Division division;
  Eigen::Index axis = 0;
  (high - low).maxCoeff(&axis);
  division.plane.normal = Vector3d::Unit(axis);
  division.plane.offset = 0.5 * low[axis] + 0.5 * high[axis];
  division.is_possible = low[axis] < division.plane.offset && division.plane.offset < high[axis];
  return division;
}

class SphereTreeBuilder {
 public:
  SphereTreeBuilder(const TriangleMesh& mesh, const SphereTreeLimits& limits)
      : bvh_(mesh), surface_(mesh), limits_(limits), directions_(spreadDirections(kSamples)) {}

  SphereTree build() {
    add(surface_.whole(), 0);
    std::size_t leaves = 1;
    while (leaves < limits_.max_leaves && !largest_.empty()) {
      const std::uint32_t node = largest_.top().second;
      largest_.pop();
      divide(node);
      ++leaves;
    }
    return breadthFirst();
  }

 private:
  void add(MeshPart part, std::uint32_t level) {
    const Points corners = surface_.cornersOf(part);
    SphereNode node;
    node.level = level;
    enclose(corners, node);
    node.overshoot = overshootOf(node);
    const Division division = divisionOf(corners);
    const auto id = ~static_cast<std::uint32_t>(nodes_.size());
    if (division.is_possible && level < limits_.max_level && node.radius > limits_.min_radius &&
        node.overshoot > limits_.min_overshoot) {
      // The complemented id ranks the first of equal ones highest.
      largest_.push({node.radius, id});
    }
    nodes_.push_back(node);
    parts_.push_back(std::move(part));
    planes_.push_back(division.plane);
  }

  /// The smallest ball, proven. A computed distance errs by less than 4 u of it. A corner stands
  /// for points up to cutError() away for each cut.
  void enclose(const Points& corners, SphereNode& node) const {
    node.center = fitSphere(corners).geometry_from_body.translation;
    double reach = 0.0;
    for (const auto& corner : corners) {
      reach = std::max(reach, (corner - node.center).norm());
    }
    node.radius = reach * (1.0 + 16.0 * kUnitRoundOff) + node.level * surface_.cutError();
    node.radius += node.radius > 0.0 ? kUnderflow : 0.0;
  }

  double overshootOf(const SphereNode& node) const {
    double farthest = 0.0;
    NearestPoint nearest;
    for (const auto& direction : directions_) {
      const Vector3d point = node.center + node.radius * direction;
      const NearestPoint start = nearest.leaf_triangle == kNone
                                     ? NearestPoint{}
                                     : bvh_.nearestOn(nearest.leaf_triangle, point);
      nearest = bvh_.nearestTo(point, start, kTolerance);
      farthest = std::max(farthest, nearest.distance);
    }
    return farthest;
  }

  void divide(std::uint32_t complement) {
    const std::uint32_t node = ~complement;
    MeshPart below;
    MeshPart above;
    surface_.split(parts_[node], planes_[node], below, above);
    parts_[node] = MeshPart{};
    nodes_[node].first_child = static_cast<std::uint32_t>(nodes_.size());
    nodes_[node].child_count = 2;
    const std::uint32_t level = nodes_[node].level + 1;
    add(std::move(below), level);
    add(std::move(above), level);
  }

  SphereTree breadthFirst() const {
    SphereTree tree;
    tree.nodes.reserve(nodes_.size());
    tree.nodes.push_back(nodes_[0]);
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
      const std::uint32_t first = tree.nodes[i].first_child;
      const std::uint32_t count = tree.nodes[i].child_count;
      if (count > 0) {
        tree.nodes[i].first_child = static_cast<std::uint32_t>(tree.nodes.size());
        tree.nodes.insert(tree.nodes.end(), nodes_.begin() + first, nodes_.begin() + first + count);
      }
    }
    return tree;
  }

  TriangleBvh bvh_;
  PartedSurface surface_;
  SphereTreeLimits limits_;
  Points directions_;
  std::vector<SphereNode> nodes_;
  std::vector<MeshPart> parts_;
  std::vector<CutPlane> planes_;
  std::priority_queue<std::pair<double, std::uint32_t>> largest_;
};

struct Build {
  const SphereTreeLimits& limits;

  SphereTree operator()(const Sphere& sphere) const {
    SphereNode node;
    node.radius = sphere.radius;
    return {{node}};
  }
  SphereTree operator()(const TriangleMesh& mesh) const {
    return SphereTreeBuilder(mesh, limits).build();
  }
  template <class Primitive>
  SphereTree operator()(const Primitive& primitive) const {
    return SphereTreeBuilder(surroundingMesh(primitive), limits).build();
  }
};

}  // namespace

SphereTree buildSphereTree(const Geometry& geometry, const SphereTreeLimits& limits) {
  checkGeometry(geometry);
  if (limits.max_leaves == 0) {
    throw std::invalid_argument("max_leaves is 0; at least 1 is accepted");
  }
  return std::visit(Build{limits}, geometry);
}

}  // namespace collision_monitor
