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

/// What a search goes by: shapes of the kinds allowed, and what they stick out over a mesh.
struct RoughGoal {
  static constexpr double kNoBound = std::numeric_limits<double>::infinity();

  const DistanceGrid& grid;
  ShapeKinds kinds;
  std::vector<TurnedCore> others;  ///< points in other shapes do not count
  std::optional<CutPlane> plane;   ///< points near it do not count

  /// @param bound see costOf.
  OvershootSum overshootOf(const TurnedCore& core, double bound = kNoBound) const noexcept;
  /// Between the mean and the maximum. Units: metres.
  /// @param bound where the cost is not below it, the answer may be anything not below it: a part
  /// of the work often tells.
  double costOf(const TurnedCore& core, double bound = kNoBound) const noexcept;
};

/// A shape that was found by search on a grid.
struct RoughFit {
  TurnedCore core;
  std::size_t kind{0};                                   ///< index of the alternative of Shape
  double cost{std::numeric_limits<double>::infinity()};  ///< [m]
};

/// The least box along a frame's axes around points. @pre there is a point.
TurnedCore boxAround(const Eigen::Matrix3d& frame, const Points& points);

/// The best of some shapes with axes along one of the frames. Encloses the points.
RoughFit fitRoughly(const Points& points, const std::vector<Eigen::Matrix3d>& frames,
                    const RoughGoal& goal);

/// Moves the fit of the same kind towards a local minimum of its cost. Encloses the points.
RoughFit polished(const RoughFit& fit, const Points& points, const RoughGoal& goal);

/// The same shape as one of the kinds, exactly, and the other way round.
PosedShape placedShape(const RoughFit& fit);
TurnedCore coreOf(const PosedShape& shape) noexcept;

}  // namespace collision_monitor
