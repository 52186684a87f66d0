// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "collision_monitor/pipeline/search_pairs.h"

namespace collision_monitor::pairs_tool {

/// One line a pair, with a header above and the numbers of all below.
std::string tableOf(const RobotModel& model, const std::vector<PairFound>& pairs,
                    std::size_t states);

/// "at shoulder=0.5 elbow=-1.25": a state in which the pair touches, of the joints that matter to
/// it, with all digits that it takes to see the same.
std::string stateText(const RobotModel& model, const PairFound& pair);

/// A pair that needs no checking.
struct PairLine {
  std::string link1, link2;
  const char* reason;  ///< as in an SRDF
};

struct PairLines {
  std::vector<PairLine> lines;
  std::vector<PairLine> left_out;  ///< that touched in no state drawn, or in all, without a proof
};

/// What is adjacent, or proven to touch always or never.
/// @param trusts_samples leaves none out
PairLines linesOf(const RobotModel& model, const std::vector<PairFound>& pairs,
                  bool trusts_samples);

/// An SRDF that says no more than these lines.
std::string newSrdf(const std::string& robot_name, const std::vector<PairLine>& lines);

}  // namespace collision_monitor::pairs_tool
