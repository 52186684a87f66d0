// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "narrow_phase/mesh/mesh_inside.h"
#include "narrow_phase/mesh/mesh_search.h"

namespace collision_monitor {
namespace {

bool surfacesMeet(const MeshPair& pair, MeshQueryMemory& memory) noexcept {
  // The least float above 0: only bounds that touch, up to the slack, are opened.
  constexpr float kTouching = std::numeric_limits<float>::min();
  WaitingPairs waiting(memory);
  waiting.push({0.0F, 0, 0});
  while (!waiting.empty()) {
    const MeshQueryMemory::Waiting next = waiting.pop();
    const std::uint32_t child_a = childOf(pair.a, next.a);
    const std::uint32_t child_b = childOf(pair.b, next.b);
    if (!isTriangle(child_a) || !isTriangle(child_b)) {
      openLarger(pair, next, kTouching, waiting);
    } else if (overlap(pair.a.triangles()[triangleAt(child_a)],
                       triangleOfB(pair, triangleAt(child_b)))) {
      return true;
    }
  }
  return false;
}

// A point of `other` that is in `solid`, in the frame of `other`.
const Eigen::Vector3d* findHeld(const MeshTree& solid, const MeshTree& other,
                                const Pose& solid_from_other, MeshQueryMemory& memory,
                                Holding& holding) noexcept {
  if (!solid.hasInside()) {
    return nullptr;
  }
  for (const Eigen::Vector3d& probe : solid.isClosed() ? other.pieces() : other.probes()) {
    const PointInMesh lies = lookInside(solid, solid_from_other * probe, memory);
    holding.visits += lies.visits;
    if (lies.is_inside) {
      return &probe;
    }
    holding.outside = std::min(holding.outside, std::max(lies.hold, leastHold(solid)));
  }
  return nullptr;
}

}  // namespace

double leastHold(const MeshTree& open) noexcept { return 1e-3 * open.radius(); }

Holding pointHeld(const MeshPair& pair, MeshQueryMemory& memory) noexcept {
  Holding holding;
  if (const auto* of_b = findHeld(pair.a, pair.b, pair.a_from_b, memory, holding)) {
    holding.point = pair.a_from_b * *of_b;
  } else if (const auto* of_a = findHeld(pair.b, pair.a, inverse(pair.a_from_b), memory, holding)) {
    holding.point = *of_a;
  }
  return holding;
}

bool overlap(const PlacedMesh& a, const PlacedMesh& b, MeshQueryMemory& memory) noexcept {
  if (!isFinite(a.world_from_mesh) || !isFinite(b.world_from_mesh)) {
    return true;
  }
  const MeshPair pair = makeMeshPair(a, b);
  return surfacesMeet(pair, memory) || pointHeld(pair, memory).point.has_value();
}

}  // namespace collision_monitor
