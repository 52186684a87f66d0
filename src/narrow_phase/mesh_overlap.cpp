// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/mesh_inside.h"
#include "narrow_phase/mesh_search.h"

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

}  // namespace

bool holdsOther(const MeshPair& pair, const Eigen::Vector3d& point_on_a,
                const Eigen::Vector3d& point_on_b, MeshQueryMemory& memory) noexcept {
  return (pair.a.isClosed() && isInside(pair.a, point_on_b, memory)) ||
         (pair.b.isClosed() && isInside(pair.b, inverse(pair.a_from_b) * point_on_a, memory));
}

bool overlap(const PlacedMesh& a, const PlacedMesh& b, MeshQueryMemory& memory) noexcept {
  if (!isFinite(a.world_from_mesh) || !isFinite(b.world_from_mesh)) {
    return true;
  }
  const MeshPair pair = makeMeshPair(a, b);
  return surfacesMeet(pair, memory) ||
         holdsOther(pair, pair.a.triangles().front()[0], triangleOfB(pair, 0)[0], memory);
}

}  // namespace collision_monitor
