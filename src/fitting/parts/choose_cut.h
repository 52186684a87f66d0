// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "fitting/shapes/mesh_part.h"
#include "fitting/shapes/rough_fit.h"

namespace collision_monitor {

/// The cost by which sets of shapes are compared. Units: metres.
double costOf(const Overshoot& overshoot) noexcept;

/// A cut and the shapes it leads to.
struct CutChoice {
  CutPlane plane;
  RoughFit below;
  RoughFit above;
  double cost{std::numeric_limits<double>::infinity()};  ///< [m]
  bool is_idle{false};                                   ///< it gains nothing by itself
};

/// The plane whose pair of shapes costs least, among planes across the frames' axes at several
/// places. The best cuts of a few axes are compared after both shapes have moved to where they
/// stick out least.
/// @param samples points of the part's surface, dense relative to its size.
/// @param whole the present shape of the part.
/// @return nothing when the part has no extent along any axis.
std::optional<CutChoice> chooseCut(const Points& samples, const TurnedCore& whole,
                                   const RoughGoal& goal);

}  // namespace collision_monitor
