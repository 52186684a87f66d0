// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include "narrow_phase/mesh/mesh_search.h"
#include "narrow_phase/mesh_inside/mesh_inside.h"
#include "narrow_phase/triangle/triangle_edges.h"

namespace collision_monitor {
namespace {

// True if two triangles are within a distance. The direction along which the last two triangles
// were apart is tried first, since it often parts their neighbors, too.
bool areWithin(const MeshPair& pair, const TrianglePair& triangles, double distance,
               Eigen::Vector3d& direction) noexcept {
  const Triangle& of_a = pair.a.triangles()[triangles.a];
  const Triangle of_b = triangleOfB(pair, triangles.b);
  if (distance <= 0.0) {
    return overlap(of_a, of_b);
  }
  PointPair start;
  start.squared_distance =
      std::nextafter(distance * distance, std::numeric_limits<double>::infinity());
  start.on_b = direction;
  const TriangleDistance found = boundedDistance(of_a, of_b, start, start.squared_distance);
  direction = found.visits > 1 ? direction : found.direction;
  return found.nearest.squared_distance < start.squared_distance;
}

void searchContact(const MeshPair& pair, const MeshContactQuery& query, MeshQueryMemory& memory,
                   MeshContact& found) noexcept {
  // The least float above 0: only bounds that touch, up to the slack, are opened.
  constexpr float kTouching = std::numeric_limits<float>::min();
  const float limit = query.distance <= 0.0 ? kTouching : asLimit(query.distance * query.distance);
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();
  NodePairQueue queue(memory);
  queue.push({0.0F, 0, 0});
  while (!queue.empty()) {
    if (found.visits >= query.visit_budget) {
      return;
    }
    ++found.visits;
    const MeshQueryMemory::NodePair next = queue.pop();
    const std::uint32_t child_a = childOf(pair.a, next.a);
    const std::uint32_t child_b = childOf(pair.b, next.b);
    if (!isTriangle(child_a) || !isTriangle(child_b)) {
      openLarger(pair, next, limit, queue);
      continue;
    }
    found.visits += kVisitsToMeasure - 1;
    const TrianglePair triangles{triangleAt(child_a), triangleAt(child_b)};
    if (areWithin(pair, triangles, query.distance, direction)) {
      found.state = MeshContact::State::contact;
      found.triangles = triangles;
      return;
    }
  }
  found.state = MeshContact::State::apart;
}

// The points of `other` for which `solid` is asked.
const std::vector<Eigen::Vector3d>& probesOf(const MeshTree& other,
                                             const MeshTree& solid) noexcept {
  return solid.isClosed() ? other.pieces() : other.probes();
}

// Two meshes, one of which is asked whether it holds a probe of the other.
struct Asked {
  const MeshTree& solid;
  const MeshTree& other;
  Pose solid_from_other;
  std::size_t first;  // HeldProbe of the first probe
};

// What is kept of a probe; nullptr if nothing is.
KeptProbe* keptOf(const HoldingQuery& query, std::size_t probe) noexcept {
  return query.asks_outside && probe < query.kept.count ? query.kept.first + probe : nullptr;
}

// Finds a probe inside; none: kNone.
std::uint32_t findHeld(const Asked& asked, const HoldingQuery& query, MeshQueryMemory& memory,
                       Holding& holding) noexcept {
  const MeshTree& solid = asked.solid;
  if (!solid.hasInside()) {
    return kNone;
  }
  const ConvexHull::Face* last = nullptr;  // a probe was beyond it
  const std::vector<Eigen::Vector3d>& probes = probesOf(asked.other, solid);
  for (std::uint32_t i = 0; i < probes.size(); ++i) {
    const Eigen::Vector3d point = asked.solid_from_other * probes[i];
    KeptProbe* const kept = keptOf(query, asked.first + i);
    if (const auto left = kept != nullptr ? kept->leftAt(point) : std::nullopt) {
      holding.outside = std::min(holding.outside, std::max(*left, leastHold(solid)));
      continue;
    }
    const auto is_beyond = [&](const ConvexHull::Face& face) {
      return face.normal.dot(point) > face.offset;
    };
    if (!query.asks_outside && !solid.isClosed() &&
        isBeyondAnyFace(*solid.openSurface(), last, is_beyond)) {
      continue;
    }
    const PointInMesh lies = lookInside(solid, point, memory, query.asks_outside);
    holding.visits += lies.visits;
    if (lies.is_inside) {
      return i;
    }
    holding.outside = std::min(holding.outside, std::max(lies.hold, leastHold(solid)));
    if (kept != nullptr) {
      *kept = {point, lies.hold, query.apart};
    }
  }
  return kNone;
}

}  // namespace

double leastHold(const MeshTree& open) noexcept { return 1e-3 * open.radius(); }

std::size_t countProbes(const MeshTree& a, const MeshTree& b) noexcept {
  return probesOf(b, a).size() + probesOf(a, b).size();
}

Holding pointHeld(const MeshPair& pair, MeshQueryMemory& memory,
                  const HoldingQuery& asked) noexcept {
  Holding holding;
  HoldingQuery query = asked;
  if (countProbes(pair.a, pair.b) > query.kept.count) {
    query.kept = {};  // of many probes one would expire in each query, and all are asked then
  }
  const std::vector<Eigen::Vector3d>& of_b = probesOf(pair.b, pair.a);
  const Asked asked_a{pair.a, pair.b, pair.a_from_b, 0};
  const std::uint32_t in_a = findHeld(asked_a, query, memory, holding);
  if (in_a != kNone) {
    holding.point = pair.a_from_b * of_b[in_a];
    holding.probe = in_a;
    return holding;
  }
  const Asked asked_b{pair.b, pair.a, inverse(pair.a_from_b), of_b.size()};
  const std::uint32_t in_b = findHeld(asked_b, query, memory, holding);
  if (in_b != kNone) {
    holding.point = probesOf(pair.a, pair.b)[in_b];
    holding.probe = static_cast<HeldProbe>(of_b.size()) + in_b;
  }
  return holding;
}

Holding probeHeld(const MeshPair& pair, HeldProbe probe, MeshQueryMemory& memory) noexcept {
  Holding holding;
  const auto& of_b = probesOf(pair.b, pair.a);
  const auto& of_a = probesOf(pair.a, pair.b);
  const bool is_of_b = probe < of_b.size();
  const MeshTree& solid = is_of_b ? pair.a : pair.b;
  const std::size_t place = is_of_b ? probe : probe - of_b.size();
  if (probe == kNone || !solid.hasInside() || (!is_of_b && place >= of_a.size())) {
    return holding;
  }
  const Eigen::Vector3d in_a = is_of_b ? Eigen::Vector3d(pair.a_from_b * of_b[place]) : of_a[place];
  const Eigen::Vector3d point = is_of_b ? in_a : Eigen::Vector3d(inverse(pair.a_from_b) * in_a);
  const PointInMesh lies = lookInside(solid, point, memory, false);
  holding.visits = lies.visits;
  if (lies.is_inside) {
    holding.point = in_a;
    holding.probe = probe;
  }
  return holding;
}

MeshContact contactOf(const PlacedMesh& a, const PlacedMesh& b, const MeshContactQuery& query,
                      MeshQueryMemory& memory, const TrianglePair& start) noexcept {
  MeshContact found;
  if (!isFinite(a.world_from_mesh) || !isFinite(b.world_from_mesh)) {
    return found;
  }
  const MeshPair pair = makeMeshPair(a, b);
  const Holding last = probeHeld(pair, query.held, memory);
  found.visits += last.visits;
  if (last.point) {
    found.state = MeshContact::State::contact;
    found.held = last.probe;
    return found;
  }
  if (start.a < a.tree.triangles().size() && start.b < b.tree.triangles().size()) {
    ++found.visits;
    Eigen::Vector3d direction = Eigen::Vector3d::Zero();
    if (areWithin(pair, start, query.distance, direction)) {
      found.state = MeshContact::State::contact;
      found.triangles = start;
      return found;
    }
  }
  searchContact(pair, query, memory, found);
  if (found.state == MeshContact::State::apart && query.outside > 0.0) {
    found.outside = query.outside;
  } else if (found.state == MeshContact::State::apart) {
    const Holding held =
        pointHeld(pair, memory, {query.asks_outside, query.distance, query.probes});
    found.visits += held.visits;
    found.outside = held.outside;
    found.held = held.probe;
    found.state = held.point ? MeshContact::State::contact : MeshContact::State::apart;
  }
  return found;
}

}  // namespace collision_monitor
