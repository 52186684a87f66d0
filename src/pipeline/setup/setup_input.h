// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/pipeline/setup.h"

namespace collision_monitor {

/// What descriptions and rules say, before any shape is fitted.
struct SetupInput {
  RobotModel model;
  std::vector<SrdfPairs> srdfs;       ///< of each robot that has one
  std::vector<LinkRules> link_rules;  ///< by LinkId
  std::vector<LinkIdPair> ignored;    ///< of SetupOptions::ignored_pairs
  std::vector<PairRule> pair_rules;
};

/// Checks the numbers of the options.
void checkOptions(const SetupOptions& options, SetupReport& report);

/// Reads all texts and finds the links that they name. After a fault the model is what could be
/// read, for further checks of names alone; report.awaits_names if names are missing then.
/// @param report gets every fault; names that it awaits are none
SetupInput readInput(const std::vector<RobotDescription>& robots,
                     const ResourceLoader& load_resource, const SetupOptions& options,
                     SetupReport& report);

/// As buildSetup, from what was read.
/// @param report has the warnings of reading, and no errors
CycleSetup buildFrom(SetupInput input, const SetupOptions& options, SetupReport report);

}  // namespace collision_monitor
