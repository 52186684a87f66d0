// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/fitting/fit_parts.h"

namespace collision_monitor {

std::vector<Fit> fitGeometries(const std::vector<Geometry>& geometries, const FitLimits& limits) {
  std::vector<Fit> fits;
  for (const auto& geometry : geometries) {
    Fit fit;
    fit.shapes.push_back(encloseTightly(geometry, limits.kinds));
    fit.overshoot = fit.shapes.front().overshoot;
    fits.push_back(fit);
  }
  return fits;
}

}  // namespace collision_monitor
