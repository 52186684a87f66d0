// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "fit_robot.h"

namespace collision_monitor::fit_tool {

/// Texts about one part, for a table or a page.
struct PartText {
  std::string shapes;                         ///< "2 capsule, 1 box"
  std::string triangles;                      ///< "-" if there is no mesh
  std::string volume_ratio;                   ///< shapes to convex hull; "-" if the hull is flat
  std::string overshoot_max, overshoot_mean;  ///< [mm], "-" if not measured
  std::string inner_radius;                   ///< [mm], "-" if there is no inner sphere
  std::string proof;  ///< "proven", "proven, +0.002 mm" if it was widened, "NOT PROVEN"
};

PartText textOf(const FittedPart& part);

/// With this many decimals.
std::string fixed(double value, int decimals);

/// Figures of all parts together. Units: metres, seconds, cubic metres.
struct Totals {
  std::size_t links{0}, parts{0}, triangles{0}, shapes{0}, unproven{0};
  double hull_volume{0.0}, shape_volume{0.0};
  double worst_overshoot{0.0};
  std::string worst;  ///< the part with that overshoot: "forearm, collision_0"
  double seconds{0.0};
};

Totals totalsOf(const FittedRobot& robot);

/// "8 links, 2364 triangles, 21 shapes, ..."
std::string sentenceOf(const Totals& totals);

/// One line per part with right-aligned numbers, a header above and the totals below.
std::string tableOf(const FittedRobot& robot);

}  // namespace collision_monitor::fit_tool
