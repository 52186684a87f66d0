// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "collision_monitor/broad_phase/small_box.h"

namespace collision_monitor {

/// How boxes are distributed along one axis. Units: metres.
struct Spread {
  double mean_width{0.0};
  double range{0.0};  ///< of the centers as if spread evenly; outliers hardly count
};

/// Measures about a thousand boxes, evenly chosen. Infinite ones are left out.
std::array<Spread, 3> spreadsOf(const std::vector<SmallBox>& boxes) noexcept;

}  // namespace collision_monitor
