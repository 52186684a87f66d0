// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pipeline/refine/sweep_pairs.h"

namespace collision_monitor {

struct MovingElement {
  const Element& element;
  const Ball& ball;  ///< ballOf its element
  const ScrewMotion& motion;
};

/// Finds the first contact of two elements inflated by their paddings. `measured` is between the
/// padded elements. Work is counted as in measureElements.
/// @return undecided also where only what surrounds a geometry touches.
SweptContact sweepElements(const MovingElement& a, const MovingElement& b,
                           const SweepLimits& limits, RefineScratch& scratch) noexcept;

}  // namespace collision_monitor
