// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/geometry/ids.h"
#include "pipeline/look_ahead/link_walk.h"

namespace collision_monitor {

struct WalkQuestion {
  bool has_step;  ///< the columns of the last motion are filled
  bool has_bends;
};

/// The pair of the largest travel relative to its thickness; of equal ones the first.
struct FarthestPair {
  double share{0.0};  ///< travel / thickness
  LinkPairIndex pair{kNone};
};

struct Farthest {
  FarthestPair moved;
  FarthestPair bent;
};

/// Fills the distances by link pair in `reaches`; returns the farthest pairs.
Farthest walkLinkPairs(const WalkQuestion& question, ActivationDistances& reaches) noexcept;

}  // namespace collision_monitor
