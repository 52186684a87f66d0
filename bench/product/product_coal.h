// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/pipeline/setup.h"

namespace collision_monitor::test {

/// What is known of a state before Coal is asked.
struct KnownState {
  bool is_sure{false};   ///< nothing merely touches
  bool meets{false};     ///< surfaces cross, by FCL
  double distance{0.0};  ///< [m] the least of all pairs, exact; 0 where none is known
};

/// check_states' questions to Coal, at the same states: its times, and whether it answers as we do.
void measureCoal(const CycleSetup& setup, const std::vector<std::vector<Pose>>& world_from_element,
                 const std::vector<KnownState>& known);

}  // namespace collision_monitor::test
