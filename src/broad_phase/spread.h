// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "collision_monitor/broad_phase/small_box.h"

namespace collision_monitor {

/// How boxes lie along one axis. Units: metres.
struct Spread {
  double mean_width{0.0};
  double range{0.0};  ///< of centers, were they spread evenly: outliers hardly count
};

/// Of some thousand boxes, evenly chosen; those without end are left out.
std::array<Spread, 3> spreadsOf(const std::vector<SmallBox>& boxes) noexcept;

}  // namespace collision_monitor
