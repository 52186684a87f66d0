// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "collision_monitor/fitting/enclose.h"
#include "fitting/proofs/distance_grid.h"
#include "fitting/proofs/rough_overshoot.h"
#include "fitting/search/core_descent.h"
#include "fitting/shapes/mesh_part.h"

namespace collision_monitor {

/// The goal of a search: the allowed kinds, and what shapes stick out over.
struct RoughGoal {
  static constexpr double kNoBound = std::numeric_limits<double>::infinity();

  const DistanceGrid& grid;
  ShapeKinds kinds;
  std::vector<TurnedCore> others;  ///< points inside other shapes do not count
  std::optional<CutPlane> plane;   ///< points near it do not count

  /// @param bound see costOf.
  OvershootSum overshootOf(const TurnedCore& core, double bound = kNoBound) const;
  /// Between the mean and the maximum. Units: metres.
  /// @param bound if the cost is not below it, the result may be any value not below it. A part of
  /// the work often shows that.
  double costOf(const TurnedCore& core, double bound = kNoBound) const;
};

/// A shape found by search on a grid.
struct RoughFit {
  TurnedCore core;
  std::size_t kind{0};                                   ///< index of the alternative of Shape
  double cost{std::numeric_limits<double>::infinity()};  ///< [m]
};

/// The smallest box along a frame's axes around points. @pre there is a point.
TurnedCore boxAround(const Eigen::Matrix3d& frame, const Points& points);

/// The best of some shapes with axes along one of the frames. Encloses the points.
RoughFit fitRoughly(const Points& points, const std::vector<Eigen::Matrix3d>& frames,
                    const RoughGoal& goal);

/// Moves a fit, of unchanged kind, to a local minimum of its cost. Encloses the points.
RoughFit polished(const RoughFit& fit, const Points& points, const RoughGoal& goal);

/// Converts exactly between a core and a shape of its kind.
PosedShape placedShape(const RoughFit& fit);
TurnedCore coreOf(const PosedShape& shape) noexcept;

}  // namespace collision_monitor
