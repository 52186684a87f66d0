// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/geometry/ids.h"
#include "pipeline/look_ahead/link_walk.h"

namespace collision_monitor {

struct WalkQuestion {
  double reach;    ///< [m] as reachOf of the limits
  double near;     ///< [m] what is refined, or warned of
  double horizon;  ///< [s]
  bool has_step;   ///< the columns of the last step are filled
  bool has_bends;
};

/// The pair that goes farthest, measured by its thickness; of equal ones the first.
struct FarthestPair {
  double share{0.0};  ///< way / thickness
  LinkPairIndex pair{kNone};
};

struct Farthest {
  FarthestPair moved;
  FarthestPair bent;
};

/// Fills what reaches hold by pair, and tells of the last step what is asked.
Farthest walkLinkPairs(const WalkQuestion& question, ActivationDistances& reaches) noexcept;

}  // namespace collision_monitor
