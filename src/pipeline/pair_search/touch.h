// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pipeline/trajectory/link_pair_distance.h"

namespace collision_monitor {

/// Whether two links touch in one state.
enum class Touch : unsigned char { apart, touching, unclear };

/// Error: links nearer than 1e-9 m touch.
Touch touchOf(const PairDistance& distance) noexcept;

}  // namespace collision_monitor
