// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/mesh_inside/mesh_crossings.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "narrow_phase/mesh/mesh_search.h"

namespace collision_monitor {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// A shear that turns the line of sight to z. Equal points stay equal, to the last bit.
Vector3d sheared(const Vector3d& point, const Vector2d& slope) noexcept {
  return {point.x() - slope.x() * point.z(), point.y() - slope.y() * point.z(), point.z()};
}

// > 0 if the point is left of the edge seen from above. Both directions of an edge give the
// same number with opposite signs, to the last bit.
double sideOf(const Vector3d& from, const Vector3d& to, const Vector3d& point) noexcept {
  const bool in_order = from.x() < to.x() || (from.x() == to.x() && from.y() < to.y());
  const Vector3d& first = in_order ? from : to;
  const Vector3d& last = in_order ? to : from;
  const double side = (last.x() - first.x()) * (point.y() - first.y()) -
                      (point.x() - first.x()) * (last.y() - first.y());
  return in_order ? side : -side;
}

// +1 if the triangle covers the point and turns left seen from above, -1 if it turns right.
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

// Whether a triangle that covers the point is above it. Two of its edges cross the point's y. If
// both do so above the point, or both below, that decides: normals of slivers are mere rounding.
bool isAbove(const Triangle& triangle, const Vector3d& point) noexcept {
  bool is_below = true;
  bool is_above = true;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3d& from = triangle[i];
    const Vector3d& to = triangle[(i + 1) % 3];
    if ((from.y() <= point.y()) != (to.y() <= point.y())) {
      const double share = (point.y() - from.y()) / (to.y() - from.y());
      const double height = from.z() + share * (to.z() - from.z());
      is_below = is_below && height < point.z();
      is_above = is_above && height > point.z();
    }
  }
  if (is_above != is_below) {
    return is_above;
  }
  const Vector3d normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
  return normal.dot(triangle[0] - point) * normal.z() > 0.0;
}

// The line of sight from the point, in the frame of the nodes.
struct Sight {
  Eigen::Vector3f point;  // sheared
  Eigen::Vector2f slope;
  float slack;  // covers rounding
};

using Slots = std::array<bool, MeshTreeNode::kWidth>;

// Which children the line may meet.
Slots mayMeet(const MeshTreeNode& node, const Sight& sight) noexcept {
  Slots may{};
  for (std::uint32_t slot = 0; slot < MeshTreeNode::kWidth; ++slot) {
    const float z = node.center[2][slot];
    const float half_z = node.half[2][slot];
    const float x = node.center[0][slot] - sight.slope.x() * z - sight.point.x();
    const float y = node.center[1][slot] - sight.slope.y() * z - sight.point.y();
    const float half_x = node.half[0][slot] + std::abs(sight.slope.x()) * half_z + sight.slack;
    const float half_y = node.half[1][slot] + std::abs(sight.slope.y()) * half_z + sight.slack;
    const bool is_beside = (std::abs(x) <= half_x) & (std::abs(y) <= half_y);
    may[slot] = is_beside & (z + half_z + sight.slack >= sight.point.z());
  }
  return may;
}

Sight sightFrom(const MeshTree& tree, const Vector3d& point, const Vector2d& slope) noexcept {
  const double slack = 1e-6 * tree.radius() * (1.0 + slope.lpNorm<1>());
  return {sheared(point - tree.center(), slope).cast<float>(), slope.cast<float>(),
          static_cast<float>(slack)};
}

int turnsOf(const Triangle& triangle, const Vector3d& center, const Vector3d& point,
            const Vector2d& slope) noexcept {
  const Triangle seen = {sheared(triangle[0] - center, slope), sheared(triangle[1] - center, slope),
                         sheared(triangle[2] - center, slope)};
  const int cover = coverOf(seen, point);
  return cover != 0 && isAbove(seen, point) ? cover : 0;
}

}  // namespace

Crossings crossingsAbove(const MeshTree& tree, const Vector3d& point, const Vector2d& slope,
                         MeshQueryMemory& memory) noexcept {
  const Sight sight = sightFrom(tree, point, slope);
  const Vector3d from = sheared(point - tree.center(), slope);
  Crossings crossings;
  NodePairQueue queue(memory);
  queue.push({0.0F, 0, 0});
  while (!queue.empty()) {
    ++crossings.visits;
    const std::uint32_t child = childOf(tree, queue.pop().a);
    if (isTriangle(child)) {
      crossings.turns += turnsOf(tree.triangles()[triangleAt(child)], tree.center(), from, slope);
      continue;
    }
    const Slots may = mayMeet(tree.nodes()[child], sight);
    for (std::uint32_t slot = 0; slot < MeshTreeNode::kWidth; ++slot) {
      if (may[slot]) {
        queue.push({0.0F, (child << kSlotBits) + slot, 0});
      }
    }
  }
  return crossings;
}

}  // namespace collision_monitor
