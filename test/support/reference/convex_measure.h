// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/narrow_phase/convex_distance.h"

namespace collision_monitor::test {

/// Measures without a warm start, in its own workspace.
inline ConvexDistance measureCold(const ConvexGeometry& a, const Pose& world_from_a,
                                  const ConvexGeometry& b, const Pose& world_from_b) {
  static thread_local ConvexWorkspace workspace;
  ConvexWarmStart warm;
  ConvexSearch search{workspace, warm};
  return signedDistanceBetween(a, world_from_a, b, world_from_b, search);
}

}  // namespace collision_monitor::test
