// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/narrow_phase/convex_distance.h"
#include "narrow_phase/gjk/convex_pair.h"

namespace collision_monitor {

/// Measures two cores by the search that settles them: closed forms for parallel axes, separating
/// axes for small hulls, GJK for cores that are apart, the faces of a hull about a point, EPA for
/// other overlaps. Frames: A's. Error: see convex_distance.h.
ConvexDistance searchCores(ConvexPair& pair, ConvexSearch& search) noexcept;

}  // namespace collision_monitor
