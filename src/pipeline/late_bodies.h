// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/pipeline/run_cycle.h"

namespace collision_monitor {

/// Bodies that are placed as a search comes to need them, in the order of PairBlocks::arrivals.
struct LateBodies {
  const CycleSetup& setup;
  const LinkPoses& poses;
  BodyRows& rows;
  std::uint32_t placed{0};  ///< of the arrivals
};

/// Places the first `count` of the arrivals. What is unknown is so as for placeBodies.
void placeArrivals(std::uint32_t count, LateBodies& late) noexcept;

}  // namespace collision_monitor
