// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/mesh_depth/depth_search.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "collision_monitor/geometry/ids.h"
#include "narrow_phase/mesh/mesh_search.h"
#include "narrow_phase/mesh_depth/depth_front.h"
#include "narrow_phase/mesh_depth/point_on_mesh.h"
#include "narrow_phase/mesh_inside/mesh_inside.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

// What was measured of a place, and whether its corners may be deep enough to count.
struct MeasuredPlace {
  bool is_deep{false};
  double distance{0.0};  // signed, of its center
  double deepest{0.0};   // [m] none of its corners is deeper
  PointOnMesh nearest;
};

// A point is never deeper in the solid than in the box about it.
double depthInBox(const MeshTree& solid, const Vector3d& point) noexcept {
  const Bound box = boundAt(solid, 0);
  const Vector3d from_center = point - solid.center() - box.center.cast<double>();
  return (box.half.cast<double>() - from_center.cwiseAbs()).minCoeff();
}

// @param is_known the point is known to be inside. For an open solid this does not suffice, because
// it gives no hold.
PointInMesh lookInside(const DepthSearch& search, const Vector3d& point, bool is_known,
                       bool asks_hold) noexcept {
  const bool is_about_deepest = (point - search.deepest.at).norm() < search.deepest.depth;
  PointInMesh lies;
  lies.is_inside = search.solid.isClosed() && (is_known || is_about_deepest);
  return lies.is_inside ? lies : lookInside(search.solid, point, search.memory, asks_hold);
}

// A corner of an open solid is at most as deep as its distance to the outside through a hole.
void holdBack(double hold, const Vector3d& corner, MeasuredPlace& found) noexcept {
  if (hold < found.distance) {
    const double share = hold / found.distance;
    found.nearest.point = corner + share * (found.nearest.point - corner);
    found.distance = hold;
  }
}

MeasuredPlace measurePlace(DepthSearch& search, const Vector3d& center, double radius,
                           std::uint32_t start, bool is_inside = false) noexcept {
  MeasuredPlace found;
  found.nearest.triangle = start;
  const double in_box = depthInBox(search.solid, center);
  found.deepest = radius + in_box;
  if (!(found.deepest > search.beyond)) {
    return found;
  }
  const double cutoff = std::max(search.beyond - radius, 0.0);
  found.nearest = nearestOnMesh(search.solid, center, start, {cutoff}, search.memory);
  search.points += found.nearest.visits > 0 ? 1 : 0;
  search.visits += found.nearest.visits;
  found.distance = found.nearest.distance;
  found.deepest = radius + found.distance;
  if (!(found.deepest > search.beyond)) {
    return found;
  }
  const PointInMesh lies =
      in_box > 0.0 ? lookInside(search, center, is_inside, radius == 0.0) : PointInMesh();
  search.visits += lies.visits;
  if (lies.is_inside) {
    if (radius == 0.0) {
      holdBack(lies.hold, center, found);
    }
    found.distance = -found.distance;
  }
  // Outside of an open solid, a point may be nearer to the inside than to the surface.
  const bool is_by_surface = lies.is_inside || search.solid.isClosed();
  found.deepest = radius - (is_by_surface ? found.distance : 0.0);
  found.is_deep = found.deepest > search.beyond;
  return found;
}

Vector3d positionOf(const DepthSearch& search, const KeptDepth::Corner& corner) noexcept {
  const std::uint32_t triangle = triangleAt(childOf(search.mesh, corner.bound));
  return search.solid_from_mesh * search.mesh.triangles()[triangle][corner.at];
}

void setDeepest(DepthSearch& search, const KeptDepth::Corner& corner, const Vector3d& at,
                const MeasuredPlace& found) noexcept {
  search.beyond = found.deepest;
  search.deepest = {
      {corner.bound, corner.at, found.nearest.triangle}, search.beyond, at, found.nearest.point};
}

Vector3d centerOf(const DepthSearch& search, const Bound& bound) noexcept {
  return search.solid_from_mesh * (search.mesh.center() + bound.center.cast<double>());
}

// Opens the children, first the one that lies deepest behind the surface near their center.
void openNode(DepthSearch& search, std::uint32_t node, const Vector3d& center,
              const MeasuredPlace& found) noexcept {
  const Vector3d inwards = found.distance * (found.nearest.point - center);
  const double limit = found.deepest - search.moved;
  std::array<std::pair<double, Slot>, MeshTreeNode::kWidth> children;  // by height
  auto end = children.begin();
  for (std::uint32_t i = 0; i < MeshTreeNode::kWidth; ++i) {
    if (search.mesh.nodes()[node].child[i] != kNone) {
      const Slot slot = (node << kSlotBits) + i;
      *end = {inwards.dot(centerOf(search, boundAt(search.mesh, slot))), slot};
      std::rotate(std::upper_bound(children.begin(), end, *end), end, end + 1);
      ++end;
    }
  }
  makeRoom(MeshTreeNode::kWidth, search.side);
  for (auto child = children.begin(); child != end; ++child) {
    putFirst({child->second, found.nearest.triangle, limit}, search.side);
  }
}

// Passes a triangle over with the solid's triangle that is nearest to its deepest corner.
void measureTriangle(DepthSearch& search, const KeptDepth::Place& place) noexcept {
  KeptDepth::Place others{place.bound, place.nearest, -std::numeric_limits<double>::infinity()};
  for (std::uint32_t i = 0; i < 3; ++i) {
    const KeptDepth::Corner corner{place.bound, i, others.nearest};
    const Vector3d at = positionOf(search, corner);
    if (search.deepest.depth > 0.0 && at == search.deepest.at) {
      continue;  // triangles share corners
    }
    const MeasuredPlace found = measurePlace(search, at, 0.0, corner.nearest);
    if (found.is_deep) {
      passOverDeepest(search);
      setDeepest(search, corner, at, found);
    } else if (found.deepest - search.moved > others.limit) {
      others.limit = found.deepest - search.moved;
      others.nearest = found.nearest.triangle;
    }
  }
  passOver(others, search.side);
}

void lookAt(DepthSearch& search, const KeptDepth::Place& place) noexcept {
  const std::uint32_t child = childOf(search.mesh, place.bound);
  if (isTriangle(child)) {
    measureTriangle(search, place);
    return;
  }
  const Bound bound = boundAt(search.mesh, place.bound);
  const Vector3d center = centerOf(search, bound);
  const double radius = bound.half.cast<double>().norm();
  const MeasuredPlace found = measurePlace(search, center, radius, place.nearest);
  if (found.is_deep) {
    openNode(search, child, center, found);
  } else {
    passOver({place.bound, found.nearest.triangle, found.deepest - search.moved}, search.side);
  }
}

// Limit above which a place may have a deeper corner.
double leastLimit(const DepthSearch& search) noexcept {
  return search.beyond + kDepthRounding - search.moved;
}

void searchQueue(DepthSearch& search, std::uint32_t point_budget) noexcept {
  while (search.side.open_count > 0 && search.points < point_budget) {
    const KeptDepth::Place next = takeNext(search.side);
    if (next.limit > leastLimit(search)) {
      lookAt(search, next);
    } else {
      passOver(next, search.side);
    }
  }
}

}  // namespace

void measureDeepest(const KeptDepth::Corner& corner, bool is_inside, DepthSearch& search) noexcept {
  const Vector3d at = positionOf(search, corner);
  const MeasuredPlace found = measurePlace(search, at, 0.0, corner.nearest, is_inside);
  if (found.is_deep) {
    setDeepest(search, corner, at, found);
  } else {
    passOver({corner.bound, found.nearest.triangle, found.deepest - search.moved}, search.side);
  }
}

void passOverDeepest(DepthSearch& search) noexcept {
  const DeepCorner& deepest = search.deepest;
  if (deepest.depth > 0.0) {
    passOver({deepest.corner.bound, deepest.corner.nearest, deepest.depth - search.moved},
             search.side);
  }
}

void searchDeepest(std::uint32_t point_budget, DepthSearch& search) noexcept {
  // Places that earlier queries left open come first, so that each has its turn.
  searchQueue(search, point_budget);
  if (search.side.open_count == 0) {
    recall(leastLimit(search), search.side);
    searchQueue(search, point_budget);
  }
}

}  // namespace collision_monitor
