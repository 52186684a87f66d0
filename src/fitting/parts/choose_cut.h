// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "fitting/shapes/mesh_part.h"
#include "fitting/shapes/rough_fit.h"

namespace collision_monitor {

/// By which one set of shapes is better than another. Units: metres.
double costOf(const Overshoot& overshoot) noexcept;

/// A cut and what it leads to.
struct CutChoice {
  CutPlane plane;
  RoughFit below;
  RoughFit above;
  double cost{std::numeric_limits<double>::infinity()};  ///< [m]
  bool is_idle{false};                                   ///< it is worth nothing by itself
};

/// The plane that leaves the least coarse pair of shapes, among planes across the axes of the
/// frames at several places along each. The best of a few axes are compared with both shapes moved
/// to where they stick out least.
/// @param samples points of the part's surface, close together against its size.
/// @param whole the shape that the part has.
/// @return nothing when the part has no extent along any axis.
std::optional<CutChoice> chooseCut(const Points& samples, const TurnedCore& whole,
                                   const RoughGoal& goal);

}  // namespace collision_monitor
