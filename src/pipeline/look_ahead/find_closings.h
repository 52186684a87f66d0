// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/pipeline/setup.h"
#include "pipeline/data/cycle_data.h"

namespace collision_monitor {

/// Fills the closing speed and the time to contact of a pair; unknown where a link's velocity is.
void findClosing(const CycleSetup& setup, const LinkPoses& poses, PairDistance& distance) noexcept;

/// Fills closing speeds and times to contact; unknown where a link's velocity is unknown.
void findClosings(const CycleSetup& setup, const LinkPoses& poses,
                  PairDistances& distances) noexcept;

}  // namespace collision_monitor
