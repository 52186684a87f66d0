// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/mesh/mesh_inside.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "collision_monitor/geometry/ids.h"
#include "geometry/constants.h"
#include "geometry/point_triangle.h"
#include "narrow_phase/mesh/mesh_search.h"
#include "narrow_phase/mesh/mesh_winding.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

// Winding numbers are not asked for more closely.
constexpr double kLeastError = 0.01;

// Where `hold` is asked for: the error of a winding number as a share of what is left to 1/2. Less
// takes longer than it saves.
constexpr double kShareForHold = 0.5;

// Share of the radius: points this near to the box may soon be in it. Their winding numbers are
// asked for, too, because they mostly hold for longer.
constexpr double kBeside = 0.01;

// Parts of an open surface that take the time of one node.
constexpr std::uint32_t kPartsPerVisit = 8;

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

bool isAbove(const Triangle& triangle, const Vector3d& point) noexcept {
  const Vector3d normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
  return normal.dot(triangle[0] - point) * normal.z() > 0.0;
}

// True if a line up from the point may meet the child. `slack` covers the point's rounding.
bool mayMeet(const MeshTreeNode& node, std::uint32_t slot, const Eigen::Vector3f& point,
             float slack) noexcept {
  return std::abs(node.center[0][slot] - point.x()) <= node.half[0][slot] + slack &&
         std::abs(node.center[1][slot] - point.y()) <= node.half[1][slot] + slack &&
         node.center[2][slot] + node.half[2][slot] + slack >= point.z();
}

// [m] How far the point is outside the box or the slab about the mesh; < 0 inside both.
double outsideBounds(const MeshTree& tree, const Vector3d& point) noexcept {
  const Bound bound = boundAt(tree, 0);
  const Vector3d centered = point - tree.center();
  const Vector3d from_box = (centered - bound.center.cast<double>()).cwiseAbs();
  const double height =
      bound.normal.cast<double>().dot(centered) - static_cast<double>(bound.slab_center);
  return std::max((from_box - bound.half.cast<double>()).maxCoeff(),
                  std::abs(height) - static_cast<double>(bound.slab_half));
}

// [m] How far the point is beyond the hull of an open surface; at most 0 within.
double beyondHull(const MeshTree& tree, const Vector3d& point) noexcept {
  const OpenSurface& open = *tree.openSurface();
  const double from_center = (point - tree.center()).norm();
  if (from_center < open.hull_ball) {
    return from_center - open.hull_ball;
  }
  double beyond = -kInfinity;
  for (const ConvexHull::Face& face : open.hull) {
    beyond = std::max(beyond, face.normal.dot(point) - face.offset);
  }
  return beyond;
}

// What the rim of an open surface does to winding numbers near a point. Their gradient is the sum
// of dl / (4 pi r^2) over the rim, by Biot and Savart.
struct RimAtPoint {
  double gradient{0.0};       // [1/m] an upper bound at the point
  double nearest{kInfinity};  // [m] a lower bound of the distance of the rim
  std::uint32_t visits{0};

  void add(double length, double distance) noexcept {
    gradient += length / (4.0 * kPi * distance * distance);
    nearest = std::min(nearest, distance);
  }
};

void addSides(const Triangle& triangle, std::uint8_t sides, const Vector3d& point,
              RimAtPoint& rim) noexcept {
  for (std::size_t i = 0; i < 3; ++i) {
    if ((sides >> i & 1U) != 0) {
      const Vector3d& from = triangle[i];
      const Vector3d& to = triangle[(i + 1) % 3];
      rim.add((to - from).norm(), (closestPointOnSegment(point, from, to) - point).norm());
    }
  }
}

// Recursion is as deep as the tree. Far nodes count as if all of their rim were at their ball.
void addRim(const MeshTree& tree, std::uint32_t node, const Vector3d& point,
            RimAtPoint& rim) noexcept {
  constexpr double kFar = 2.0;  // radii
  const OpenSurface& open = *tree.openSurface();
  const auto length = static_cast<double>(open.rim_lengths[node]);
  if (!(length > 0.0)) {
    return;
  }
  ++rim.visits;
  const WindingMoments& ball = open.moments[node];
  const double distance = (point - ball.center).norm() - ball.radius;
  if (distance > kFar * ball.radius) {
    rim.add(length, distance);
    return;
  }
  for (const std::uint32_t child : tree.nodes()[node].child) {
    if (child == kNone) {
      continue;
    }
    if (isTriangle(child)) {
      addSides(tree.triangles()[triangleAt(child)], open.rim_sides[triangleAt(child)], point, rim);
    } else {
      addRim(tree, child, point, rim);
    }
  }
}

RimAtPoint rimAt(const MeshTree& tree, const Vector3d& point) noexcept {
  RimAtPoint rim;
  addRim(tree, 0, point, rim);
  return rim;
}

// [m] How far a point may travel before its winding number can change by `change`. On the way each
// piece of the rim comes nearer by at most the travel t: over all pieces L_i at r_i the change is
// at most sum L_i t / (4 pi r_i (r_i - t)), which is at most gradient * t / (1 - t / nearest).
double holdFor(double change, const RimAtPoint& rim) noexcept {
  if (!(rim.gradient > 0.0)) {
    return kInfinity;
  }
  return change > 0.0 && rim.nearest > 0.0 ? change / (rim.gradient + change / rim.nearest) : 0.0;
}

// By how much the winding number may change while the point travels: holdFor, solved for `change`.
double changeWithin(double travel, const MeshTree& tree, const Vector3d& point) noexcept {
  if (travel < leastHold(tree)) {
    return 0.0;
  }
  const RimAtPoint rim = rimAt(tree, point);
  if (!(rim.gradient > 0.0)) {
    return 0.0;
  }
  return travel < rim.nearest ? rim.gradient * travel / (1.0 - travel / rim.nearest) : kInfinity;
}

}  // namespace

PointInMesh lookInside(const MeshTree& tree, const Vector3d& point, MeshQueryMemory& memory,
                       bool asks_hold) noexcept {
  PointInMesh answer;
  if (tree.isClosed()) {
    answer.is_inside = isInside(tree, point, memory);
    return answer;
  }
  const double outside = outsideBounds(tree, point);
  if (!(outside < (asks_hold ? kBeside * tree.radius() : 0.0))) {
    answer.hold = outside;
    return answer;
  }
  const WindingNumber number =
      windingByLimit(tree, point, 0.5, kLeastError, memory, asks_hold ? kShareForHold : 1.0);
  const double beyond = std::abs(number.value) - 0.5;
  const bool is_above = beyond > number.error;
  answer.visits = 1 + number.visits / kPartsPerVisit;
  const double from_hull = is_above ? std::max(outside, beyondHull(tree, point)) : 0.0;
  answer.is_inside = is_above && from_hull < 0.0;
  if (!asks_hold) {
    return answer;
  }
  if (is_above && !answer.is_inside) {
    answer.hold = from_hull;
    return answer;
  }
  const RimAtPoint rim = rimAt(tree, point);
  answer.visits += rim.visits / kPartsPerVisit;
  answer.hold = holdFor(std::abs(beyond) - number.error, rim);
  answer.hold =
      answer.is_inside ? std::min(answer.hold, -from_hull) : std::max(answer.hold, outside);
  return answer;
}

bool staysOutside(const MeshTree& tree, const Vector3d& point, double travel,
                  MeshQueryMemory& memory, std::uint32_t& visits) noexcept {
  if (tree.isClosed()) {
    return !isInside(tree, point, memory);
  }
  if (outsideBounds(tree, point) > travel) {
    return true;
  }
  const double limit = 0.5 - changeWithin(travel, tree, point);
  if (!(limit > 0.0)) {
    return false;
  }
  const WindingNumber number = windingByLimit(tree, point, limit, kLeastError, memory);
  visits += 1 + number.visits / kPartsPerVisit;
  return std::abs(number.value) + number.error < limit;
}

bool isInside(const MeshTree& tree, const Vector3d& point, MeshQueryMemory& memory) noexcept {
  const Vector3d centered = point - tree.center();
  if (!(centered.norm() <= tree.radius())) {
    return false;
  }
  const Eigen::Vector3f rough = centered.cast<float>();
  const auto slack = static_cast<float>(1e-6 * tree.radius());
  NodePairQueue queue(memory);
  queue.push({0.0F, 0, 0});
  int turns = 0;
  while (!queue.empty()) {
    const std::uint32_t child = childOf(tree, queue.pop().a);
    if (isTriangle(child)) {
      const Triangle& triangle = tree.triangles()[triangleAt(child)];
      const int cover = coverOf(triangle, point);
      turns += cover != 0 && isAbove(triangle, point) ? cover : 0;
      continue;
    }
    const MeshTreeNode& node = tree.nodes()[child];
    for (std::uint32_t slot = 0; slot < MeshTreeNode::kWidth; ++slot) {
      if (mayMeet(node, slot, rough, slack)) {
        queue.push({0.0F, (child << kSlotBits) + slot, 0});
      }
    }
  }
  return turns != 0;
}

}  // namespace collision_monitor
