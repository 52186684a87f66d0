// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "narrow_phase/mesh/mesh_distance.h"

namespace collision_monitor::test {

/// Whether two meshes overlap; unknown counts as overlap.
inline bool meshesOverlap(const PlacedMesh& a, const PlacedMesh& b, MeshQueryMemory& memory) {
  return contactOf(a, b, {}, memory).state != MeshContact::State::apart;
}

}  // namespace collision_monitor::test
