// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/point_triangle.h"
#include "narrow_phase/mesh_front/front_entries.h"

namespace collision_monitor {
namespace {

Eigen::Vector3f unitOrNone(const Eigen::Vector3f& vector) noexcept {
  const float squared = vector.squaredNorm();
  return squared > 0.0F ? Eigen::Vector3f(vector / std::sqrt(squared)) : vector;
}

std::uint32_t nearestOf(const OpenedPair& opened, std::uint32_t children) noexcept {
  auto nearest = static_cast<std::uint32_t>(__builtin_ctz(children));
  for (std::uint32_t left = children; left != 0; left &= left - 1) {
    const auto slot = static_cast<std::uint32_t>(__builtin_ctz(left));
    nearest = opened.bounds.squared[slot] < opened.bounds.squared[nearest] ? slot : nearest;
  }
  return nearest;
}

// What the likely directions are made of, from a child to the other bound or triangle.
struct Lying {
  Eigen::Vector3f gap;      // of the boxes
  Eigen::Vector3f between;  // from the child's center to the other, where it is near
  Eigen::Vector3f normal;   // of the other
};

Lying lyingOf(const Bound& child, const PlacedBound& other) noexcept {
  const Eigen::Vector3f between = other.center - child.center;
  const Eigen::Vector3f gap = (between.cwiseAbs() - child.half - other.reach).cwiseMax(0.0F);
  return {gap.cwiseProduct(between.cwiseSign()), between, other.normal};
}

Lying lyingOf(const Bound& child, const PlacedTriangle& other) noexcept {
  const auto& [a, b, c] = other.corners;
  const Eigen::Vector3f above = a.cwiseMin(b).cwiseMin(c) - (child.center + child.half);
  const Eigen::Vector3f below = (child.center - child.half) - a.cwiseMax(b).cwiseMax(c);
  const Eigen::Vector3d nearest = closestPointOnTriangle(
      child.center.cast<double>(), a.cast<double>(), b.cast<double>(), c.cast<double>());
  return {above.cwiseMax(0.0F) - below.cwiseMax(0.0F), nearest.cast<float>() - child.center,
          unitOrNone((b - a).cross(c - a))};
}

// Directions that separate the boxes, the centers or the normals of a child and the other, and
// directions between these.
Directions likelyDirections(const Bound& child, const Lying& other) noexcept {
  const auto towards = [&](const Eigen::Vector3f& normal) {
    return Eigen::Vector3f(normal.dot(other.between) < 0.0F ? -normal : normal);
  };
  const std::array<Eigen::Vector3f, 4> single{unitOrNone(other.gap), unitOrNone(other.between),
                                              towards(other.normal), towards(child.normal)};
  Directions directions;
  for (std::size_t i = 0; i < kDirections; ++i) {
    const Eigen::Vector3f unit =
        i < single.size() ? single[i] : unitOrNone(single[i % 4] + single[(i + 1) % 4]);
    for (int axis = 0; axis < 3; ++axis) {
      directions.at[axis][i] = unit[axis];
    }
  }
  return directions;
}

}  // namespace

std::uint32_t directionFor(const OpenedPair& opened, std::uint32_t children,
                           const Eigen::Matrix3d& resting_from_node) noexcept {
  const Bound child = boundOf(*opened.node, nearestOf(opened, children));
  const Directions directions = likelyDirections(
      child, opened.triangle ? lyingOf(child, *opened.triangle) : lyingOf(child, opened.placed));
  const std::array<float, kDirections> gaps = opened.triangle
                                                  ? gapsAlong(child, *opened.triangle, directions)
                                                  : gapsAlong(child, opened.placed, directions);
  const auto best = std::max_element(gaps.begin(), gaps.end()) - gaps.begin();
  const Eigen::Vector3d chosen(directions.at[0][best], directions.at[1][best],
                               directions.at[2][best]);
  return packed(resting_from_node * chosen);
}

std::array<float, MeshTreeNode::kWidth> gapsAlong(
    std::uint32_t direction, const OpenedPair& opened,
    const Eigen::Matrix3d& resting_from_node) noexcept {
  const Eigen::Vector3d in_node = resting_from_node.transpose() * directionOf(direction);
  const Eigen::Vector3f unit = in_node.normalized().cast<float>();
  return opened.triangle ? gapsAlong(*opened.node, *opened.triangle, unit)
                         : gapsAlong(*opened.node, opened.placed, unit);
}

}  // namespace collision_monitor
