// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "pipeline/trajectory/check_trajectory.h"

namespace collision_monitor {

Verdict verdictOf(const TrajectoryReport& report, const TrajectoryOptions& options) noexcept {
  Verdict verdict = report.pairs.empty() ? Verdict::unknown : Verdict::clear;
  for (std::size_t i = 0; i < report.pairs.size(); ++i) {
    const PairApproach& pair = report.pairs[i];
    const bool is_near = pair.nearest.measured.distance <= marginOf(options, i);
    const Verdict of_pair = pair.state == ApproachState::contact ? Verdict::contact
                            : pair.state != ApproachState::clear ? Verdict::unknown
                            : is_near                            ? Verdict::warning
                                                                 : Verdict::clear;
    verdict = std::max(verdict, of_pair);
  }
  return verdict;
}

}  // namespace collision_monitor
