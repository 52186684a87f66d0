// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "narrow_phase/mesh_front/mesh_front.h"

namespace collision_monitor::test {

/// A front with its own pool.
struct OwnFront : FrontPool, MeshFront {
  explicit OwnFront(std::size_t room = MeshFront::kMostBlocks)
      : FrontPool(room), MeshFront(static_cast<FrontPool&>(*this)) {}
};

}  // namespace collision_monitor::test
