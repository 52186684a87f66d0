// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pipeline/refine/sweep_pairs.h"

namespace collision_monitor {

struct MovingElement {
  const Element& element;
  const Ball& ball;  ///< ballOf its geometry
  const ScrewMotion& motion;
};

/// First contact of what two elements are, grown by their paddings; `measured` is of what is
/// padded. Work is counted as measureElements does.
/// @return undecided also for a contact of what only surrounds a geometry.
SweptContact sweepElements(const MovingElement& a, const MovingElement& b,
                           const SweepLimits& limits, RefineScratch& scratch) noexcept;

}  // namespace collision_monitor
