// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/mesh_inside/mesh_inside.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "collision_monitor/geometry/ids.h"
#include "geometry/constants.h"
#include "geometry/point_triangle.h"
#include "narrow_phase/mesh/mesh_search.h"
#include "narrow_phase/mesh_inside/mesh_crossings.h"
#include "narrow_phase/mesh_inside/mesh_winding.h"

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
void addRim(const MeshTree& tree, std::uint32_t node, const Vector3d& point, RimAtPoint& rim,
            std::uint32_t& parts) noexcept {
  constexpr double kFar = 2.0;  // radii
  const OpenSurface& open = *tree.openSurface();
  const auto length = static_cast<double>(open.rim_lengths[node]);
  if (!(length > 0.0)) {
    return;
  }
  ++parts;
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
      addRim(tree, child, point, rim, parts);
    }
  }
}

RimAtPoint rimAt(const MeshTree& tree, const Vector3d& point, std::uint32_t& parts) noexcept {
  const OpenSurface& open = *tree.openSurface();
  if (open.moments.empty()) {
    parts += static_cast<std::uint32_t>(kPartsPerBlock * open.rim.blocks().size());
    return rimAt(point, open.rim);
  }
  RimAtPoint rim;
  addRim(tree, 0, point, rim, parts);
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
double changeWithin(double travel, const MeshTree& tree, const Vector3d& point,
                    std::uint32_t& parts) noexcept {
  if (travel < leastHold(tree)) {
    return 0.0;
  }
  const RimAtPoint rim = rimAt(tree, point, parts);
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
  if (!point.allFinite()) {
    answer.hold = 0.0;
    return answer;
  }
  const double outside = outsideBounds(tree, point);
  if (!(outside < (asks_hold ? kBeside * tree.radius() : 0.0))) {
    answer.hold = std::max(0.0, outside);
    return answer;
  }
  const WindingNumber number =
      windingByLimit(tree, point, 0.5, kLeastError, memory, asks_hold ? kShareForHold : 1.0);
  const double beyond = std::abs(number.value) - 0.5;
  const bool is_above = beyond > number.error;
  std::uint32_t parts = number.parts;
  answer.visits = 1 + parts / kPartsPerVisit;
  const double from_hull = is_above ? std::max(outside, beyondHull(tree, point)) : 0.0;
  answer.is_inside = is_above && from_hull < 0.0;
  if (!asks_hold) {
    return answer;
  }
  if (is_above && !answer.is_inside) {
    answer.hold = from_hull;
    return answer;
  }
  const RimAtPoint rim = rimAt(tree, point, parts);
  answer.visits = 1 + parts / kPartsPerVisit;
  answer.hold = holdFor(std::abs(beyond) - number.error, rim);
  answer.hold =
      answer.is_inside ? std::min(answer.hold, -from_hull) : std::max(answer.hold, outside);
  return answer;
}

bool staysOutside(const MeshTree& tree, const Vector3d& point, double travel,
                  MeshQueryMemory& memory, std::uint32_t& visits) noexcept {
  if (!point.allFinite() || std::isnan(travel)) {
    return false;
  }
  if (tree.isClosed()) {
    return !isInside(tree, point, memory);
  }
  if (outsideBounds(tree, point) > travel) {
    return true;
  }
  std::uint32_t parts = 0;
  const double limit = 0.5 - changeWithin(travel, tree, point, parts);
  visits += 1 + parts / kPartsPerVisit;
  if (!(limit > 0.0)) {
    return false;
  }
  const WindingNumber number = windingByLimit(tree, point, limit, kLeastError, memory);
  visits += number.parts / kPartsPerVisit;
  return std::abs(number.value) + number.error < limit;
}

bool isInside(const MeshTree& tree, const Vector3d& point, MeshQueryMemory& memory) noexcept {
  const Vector3d centered = point - tree.center();
  if (!(centered.norm() <= tree.radius())) {
    return false;
  }
  return crossingsAbove(tree, point, Eigen::Vector2d::Zero(), memory).turns != 0;
}

}  // namespace collision_monitor
