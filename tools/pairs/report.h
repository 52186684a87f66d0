// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "collision_monitor/pipeline/search_pairs.h"

namespace collision_monitor::pairs_tool {

/// One line per pair, with a header above and all counts below.
std::string tableOf(const RobotModel& model, const std::vector<PairFound>& pairs,
                    std::size_t states);

/// "at shoulder=0.5 elbow=-1.25": a state in which the pair touches, with only the joints that
/// affect it, and enough digits to reproduce it.
std::string stateText(const RobotModel& model, const PairFound& pair);

/// A pair that needs no checking.
struct PairLine {
  std::string link1, link2;
  const char* reason;  ///< as in an SRDF
};

struct PairLines {
  std::vector<PairLine> lines;
  std::vector<PairLine> left_out;  ///< touched in no or all sampled states, without a proof
};

/// Lines for pairs that are adjacent, or proven to touch always or never.
/// @param trusts_samples include pairs without a proof
PairLines linesOf(const RobotModel& model, const std::vector<PairFound>& pairs,
                  bool trusts_samples);

/// An SRDF with only these lines.
std::string newSrdf(const std::string& robot_name, const std::vector<PairLine>& lines);

/// A YAML file of the monitor's parameter ignore_pairs with these lines. Names are quoted.
std::string ignoredPairsYaml(const std::vector<PairLine>& lines);

}  // namespace collision_monitor::pairs_tool
