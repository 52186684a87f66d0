// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <limits>
#include <type_traits>

#include "collision_monitor/geometry/ids.h"
#include "geometry/bvh/visit_held.h"
#include "narrow_phase/mesh/mesh_and_core.h"

namespace collision_monitor {
namespace {

MeshContact touchCore(const PlacedMesh& a, const InflatedCore& b, const Pose& world_from_b,
                      const MeshContactQuery& query, MeshQueryMemory& memory,
                      const TrianglePair& start) noexcept {
  const MeshAndCore pair = makeMeshAndCore(a, b, world_from_b);
  const double cutoff = std::max(query.distance + b.radius, pair.rounding);
  MeshContact found;
  NearestSearch search;
  search.best.squared_distance =
      std::nextafter(cutoff * cutoff, std::numeric_limits<double>::infinity());
  search.best.on_b = anyPointOf(b.core);
  if (start.a < a.tree.triangles().size()) {
    measureTriangle(pair, start.a, search.bounds, search);
  }
  if (search.nearest.a == kNone) {
    searchFromRoot(pair, cutoff, query.visit_budget, memory, search);
  }
  found.visits = 1 + search.visits;
  if (search.nearest.a != kNone) {
    found.state = MeshContact::State::contact;
    found.triangles = search.nearest;
  } else if (search.isComplete() && query.outside > 0.0) {
    found.outside = query.outside;
    found.state = MeshContact::State::apart;
  } else if (search.isComplete()) {
    const CoreInMesh lies = lookInside(pair, search, memory, query.asks_outside);
    found.visits += lies.visits;
    found.outside = lies.is_inside ? kInfinity : lies.hold;
    found.state = lies.is_inside ? MeshContact::State::contact : MeshContact::State::apart;
  }
  return found;
}

}  // namespace

MeshContact contactOf(const PlacedMesh& a, const PlacedConvex& b, const MeshContactQuery& query,
                      MeshQueryMemory& memory, const TrianglePair& start) noexcept {
  if (!isFinite(a.world_from_mesh) || !isFinite(b.world_from_body)) {
    return {};
  }
  const auto touch = [&](const auto& geometry) noexcept {
    if constexpr (std::is_same_v<decltype(geometry), const HalfSpace&>) {
      const double distance = measureHalfSpace(a, b.world_from_body).measured.distance;
      MeshContact found;
      found.state =
          distance <= query.distance ? MeshContact::State::contact : MeshContact::State::apart;
      return found;
    } else {
      return touchCore(a, inflatedCoreOf(geometry), b.world_from_body, query, memory, start);
    }
  };
  return visitHeld(touch, b.geometry);
}

}  // namespace collision_monitor
