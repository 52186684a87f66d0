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

/// An SRDF that disables what is adjacent, always touching or proven apart.
struct PairSrdf {
  std::string text;
  std::size_t left_out{0};  ///< pairs that were never seen to touch and are not proven apart
};

/// @param trusts_samples leaves none out
PairSrdf writeSrdf(const RobotModel& model, const std::vector<PairFound>& pairs,
                   bool trusts_samples);

}  // namespace collision_monitor::pairs_tool
