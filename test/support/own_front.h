// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>

#include "narrow_phase/mesh_front/mesh_front.h"

namespace collision_monitor::test {

struct OwnProbes {
  std::array<KeptProbe, 32> own_probes{};
};

/// A front with its own pool, and room for some probes.
struct OwnFront : OwnProbes, FrontPool, MeshFront {
  explicit OwnFront(std::size_t room = MeshFront::kMostBlocks)
      : FrontPool(room),
        MeshFront(static_cast<FrontPool&>(*this), {own_probes.data(), own_probes.size()}) {}
};

}  // namespace collision_monitor::test
