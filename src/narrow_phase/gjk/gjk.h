// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include "narrow_phase/gjk/convex_pair.h"
#include "narrow_phase/gjk/simplex.h"

namespace collision_monitor {

/// What GJK knows of two cores. The true distance lies between `lower` and that of the simplex.
struct GjkResult {
  enum class State : unsigned char {
    settled,     ///< both bounds have met
    stopped,     ///< proven to be farther apart than the cutoff
    near,        ///< shown to be nearer than asked
    paused,      ///< did all steps that were asked for
    stalled,     ///< rounding or the step limit keeps the bounds apart
    overlapping  ///< the simplex holds the origin, or touches it
  };

  State state{State::stalled};
  Simplex simplex;
  double gap{-std::numeric_limits<double>::infinity()};  ///< along the simplex's normal
  double lower{-std::numeric_limits<double>::infinity()};
  Eigen::Vector3d lower_direction{Eigen::Vector3d::UnitX()};  ///< unit, from A to B, in A's frame
  int steps{0};
};

/// Limits at which GJK may stop early. The defaults have no effect.
struct GjkLimits {
  double cutoff{std::numeric_limits<double>::infinity()};  ///< [m] stops at a greater lower bound
  double near{0.0};                            ///< [m] stops once the distance is known to be less
  int steps{std::numeric_limits<int>::max()};  ///< pauses after so many, counted from the start
};

/// Runs GJK from the simplex of the last search.
///
/// Error: if settled, the bounds differ by at most toleranceOf(pair).
/// Limits: at most 128 steps; polytopes take fewer than ten, cylinders some tens.
/// Source: Gilbert, Johnson, Keerthi (1988); van den Bergen (2003), section 4.3, for the bound
/// that the support plane proves; Cameron, "Enhancing GJK" (1997), for the warm start.
GjkResult runGjk(ConvexPair& pair, const ConvexWarmStart& warm, const GjkLimits& limits) noexcept;

/// Goes on where a search has paused.
void resumeGjk(ConvexPair& pair, const GjkLimits& limits, GjkResult& result) noexcept;

/// Runs GJK from the points that are nearest along a direction, from A to B in A's frame.
GjkResult runGjk(ConvexPair& pair, const Eigen::Vector3d& direction,
                 const GjkLimits& limits) noexcept;

/// Keeps some points of the difference, from which the next search of the pair may start.
void keepWarm(const SupportVertex* vertices, int count, const ConvexPair& pair,
              ConvexWarmStart& warm) noexcept;

}  // namespace collision_monitor
