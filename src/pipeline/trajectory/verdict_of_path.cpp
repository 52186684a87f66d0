// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "pipeline/trajectory/check_trajectory.h"

namespace collision_monitor {

Verdict verdictOf(const TrajectoryReport& report, double margin) noexcept {
  Verdict verdict = report.pairs.empty() ? Verdict::unknown : Verdict::clear;
  for (const PairApproach& pair : report.pairs) {
    const bool is_near = pair.nearest.measured.distance <= margin;
    const Verdict of_pair = pair.state == ApproachState::contact ? Verdict::contact
                            : pair.state != ApproachState::clear ? Verdict::unknown
                            : is_near                            ? Verdict::warning
                                                                 : Verdict::clear;
    verdict = std::max(verdict, of_pair);
  }
  return verdict;
}

}  // namespace collision_monitor
