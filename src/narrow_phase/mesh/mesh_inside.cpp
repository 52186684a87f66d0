// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/mesh/mesh_inside.h"

#include <Eigen/Geometry>
#include <cmath>

#include "narrow_phase/mesh/mesh_search.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

// > 0 where the point is left of the edge seen from above. Both directions of an edge give the
// same number with opposite signs, to the last bit.
double sideOf(const Vector3d& from, const Vector3d& to, const Vector3d& point) noexcept {
  const bool in_order = from.x() < to.x() || (from.x() == to.x() && from.y() < to.y());
  const Vector3d& first = in_order ? from : to;
  const Vector3d& last = in_order ? to : from;
  const double side = (last.x() - first.x()) * (point.y() - first.y()) -
                      (point.x() - first.x()) * (last.y() - first.y());
  return in_order ? side : -side;
}

// +1 when the triangle covers the point and turns left seen from above, -1 when it turns right.
int coverOf(const Triangle& triangle, const Vector3d& point) noexcept {
  int cover = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3d& from = triangle[i];
    const Vector3d& to = triangle[(i + 1) % 3];
    if (from.y() <= point.y() && point.y() < to.y()) {
      cover += sideOf(from, to, point) > 0.0 ? 1 : 0;
    } else if (to.y() <= point.y() && point.y() < from.y()) {
      cover -= sideOf(from, to, point) >= 0.0 ? 0 : 1;
    }
  }
  return cover;
}

bool isAbove(const Triangle& triangle, const Vector3d& point) noexcept {
  const Vector3d normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
  return normal.dot(triangle[0] - point) * normal.z() > 0.0;
}

// The children that a line up from the point may meet. `slack` covers the point's rounding.
bool mayMeet(const MeshTreeNode& node, std::uint32_t slot, const Eigen::Vector3f& point,
             float slack) noexcept {
  return std::abs(node.center[0][slot] - point.x()) <= node.half[0][slot] + slack &&
         std::abs(node.center[1][slot] - point.y()) <= node.half[1][slot] + slack &&
         node.center[2][slot] + node.half[2][slot] + slack >= point.z();
}

}  // namespace

bool isInside(const MeshTree& tree, const Vector3d& point, MeshQueryMemory& memory) noexcept {
  const Vector3d centered = point - tree.center();
  if (!(centered.norm() <= tree.radius())) {
    return false;
  }
  const Eigen::Vector3f rough = centered.cast<float>();
  const auto slack = static_cast<float>(1e-6 * tree.radius());
  WaitingPairs waiting(memory);
  waiting.push({0.0F, 0, 0});
  int turns = 0;
  while (!waiting.empty()) {
    const std::uint32_t child = childOf(tree, waiting.pop().a);
    if (isTriangle(child)) {
      const Triangle& triangle = tree.triangles()[triangleAt(child)];
      const int cover = coverOf(triangle, point);
      turns += cover != 0 && isAbove(triangle, point) ? cover : 0;
      continue;
    }
    const MeshTreeNode& node = tree.nodes()[child];
    for (std::uint32_t slot = 0; slot < MeshTreeNode::kWidth; ++slot) {
      if (mayMeet(node, slot, rough, slack)) {
        waiting.push({0.0F, (child << kSlotBits) + slot, 0});
      }
    }
  }
  return turns != 0;
}

}  // namespace collision_monitor
