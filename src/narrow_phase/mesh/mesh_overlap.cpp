// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
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

}  // namespace

std::optional<Eigen::Vector3d> pointHeld(const MeshPair& pair, MeshQueryMemory& memory) noexcept {
  if (pair.a.isClosed()) {
    for (const Eigen::Vector3d& piece : pair.b.pieces()) {
      const Eigen::Vector3d in_a = pair.a_from_b * piece;
      if (isInside(pair.a, in_a, memory)) {
        return in_a;
      }
    }
  }
  if (pair.b.isClosed()) {
    const Pose b_from_a = inverse(pair.a_from_b);
    for (const Eigen::Vector3d& piece : pair.a.pieces()) {
      if (isInside(pair.b, b_from_a * piece, memory)) {
        return piece;
      }
    }
  }
  return std::nullopt;
}

bool overlap(const PlacedMesh& a, const PlacedMesh& b, MeshQueryMemory& memory) noexcept {
  if (!isFinite(a.world_from_mesh) || !isFinite(b.world_from_mesh)) {
    return true;
  }
  const MeshPair pair = makeMeshPair(a, b);
  return surfacesMeet(pair, memory) || pointHeld(pair, memory).has_value();
}

}  // namespace collision_monitor
