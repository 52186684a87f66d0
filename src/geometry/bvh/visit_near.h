// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <limits>

#include "geometry/bvh/build_bvh.h"

namespace collision_monitor {

/// A query against the boxes of nodes: an axis-aligned box, or a point as a box without extent. In
/// the unit frame of a hierarchy.
struct UnitQuery {
  std::array<float, 3> low;
  std::array<float, 3> high;
};

inline UnitQuery unitQuery(const TriangleBvh::UnitFrame& frame, const Eigen::Vector3d& low,
                           const Eigen::Vector3d& high) noexcept {
  // Clamps coordinates so that squares stay finite. Clamping moves nothing farther from the mesh.
  constexpr double kFar = 1e15;
  UnitQuery query{};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    const double from = (low[axis] - frame.center[axis]) / frame.scale;
    const double to = (high[axis] - frame.center[axis]) / frame.scale;
    query.low[k] = static_cast<float>(std::clamp(from, -kFar, kFar));
    query.high[k] = static_cast<float>(std::clamp(to, -kFar, kFar));
  }
  return query;
}

/// Lower bounds of the squared distances to four boxes. Units: of the unit frame, squared.
/// Error: near the mesh the padding of the boxes covers rounding. Far from it rounding grows with
/// the distance, and the factor at the end covers it.
inline TriangleBvh::Lanes squaredDistances(const TriangleBvh::Node& node,
                                           const UnitQuery& query) noexcept {
  TriangleBvh::Lanes sum = TriangleBvh::Lanes::Zero();
  for (std::size_t k = 0; k < 3; ++k) {
    const TriangleBvh::Lanes gap =
        (node.low[k] - query.high[k]).max(query.low[k] - node.high[k]).max(0.0f);
    sum += gap * gap;
  }
  return sum * 0.999998f;
}

/// Calls `visit(leaf_triangle)` for triangles whose boxes are nearer than a limit, nearer boxes
/// first as far as the hierarchy tells. `visit` returns the limit [m] from then on.
template <class Visit>
void visitNear(const TriangleBvh& mesh, const UnitQuery& query, double limit, const Visit& visit) {
  struct NodeToVisit {
    std::uint32_t child;
    float squared_distance;
  };
  const auto unitSquare = [&mesh](double distance) {
    const double unit = distance / mesh.unitFrame().scale;
    constexpr double kMax = std::numeric_limits<float>::max();
    return static_cast<float>(std::min(unit * unit * (1.0 + 1e-6), kMax));
  };
  // Each node on a path leaves at most three siblings on the stack.
  std::array<NodeToVisit, 3 * kMaxBvhDepth + 4> stack;
  std::size_t size = 0;
  float squared_limit = unitSquare(limit);
  stack[size++] = {0, 0.0f};
  while (size > 0) {
    const NodeToVisit next = stack[--size];
    if (next.squared_distance >= squared_limit) {
      continue;
    }
    if ((next.child & TriangleBvh::Node::kLeaf) != 0) {
      squared_limit = unitSquare(visit(next.child - TriangleBvh::Node::kLeaf));
      continue;
    }
    const auto& node = mesh.nodes()[next.child];
    const TriangleBvh::Lanes squared = squaredDistances(node, query);
    const std::size_t bottom = size;
    for (std::size_t lane = 0; lane < 4; ++lane) {
      const float distance = squared[static_cast<Eigen::Index>(lane)];
      if (distance < squared_limit) {
        std::size_t place = size++;
        for (; place > bottom && stack[place - 1].squared_distance < distance; --place) {
          stack[place] = stack[place - 1];
        }
        stack[place] = {node.child[lane], distance};
      }
    }
  }
}

}  // namespace collision_monitor
