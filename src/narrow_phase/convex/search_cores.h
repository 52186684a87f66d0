// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/narrow_phase/convex_distance.h"
#include "narrow_phase/gjk/convex_pair.h"

namespace collision_monitor {

/// Signed distance of two cores by whatever search settles it: closed forms where axes are
/// parallel, GJK while they are apart, faces of a hull about a point, EPA where they overlap.
/// Frames: A's. See convex_distance.h for the error.
ConvexDistance searchCores(ConvexPair& pair, ConvexSearch& search) noexcept;

}  // namespace collision_monitor
