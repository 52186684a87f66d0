// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "collision_monitor/robot_query.h"
#include "library/monitor_parts.h"
#include "pipeline/answers/gradient_row.h"
#include "pipeline/answers/link_distances.h"
#include "pipeline/states/check_states.h"

namespace collision_monitor {

/// Scratch and answers of a query, sized when it is made.
struct QueryParts {
  explicit QueryParts(const RobotMonitor& its_monitor);

  RobotMonitor monitor;  ///< keeps the set-up alive
  const MonitorParts& shared;
  const CycleSetup& setup;
  JointPositions state;  ///< NaN for numbers that mean nothing
  LinkPoses poses;
  LinkDistances links;
  std::vector<NearestPair> near_bodies;    ///< by PairId
  std::vector<std::uint32_t> nearest_of;   ///< by ElementPairIndex: into near_bodies, or kNone
  std::vector<Verdict> verdicts;           ///< by LinkPairIndex, of what was measured
  std::vector<unsigned char> none_passed;  ///< by ElementPairIndex: 0
  std::optional<PairId> last_nearest;      ///< in the last state that nearest() was asked for
  double last_distance{0.0};               ///< [m] of that pair in that state
  GradientRows rows;
  DistanceTable table;
  MeasuredPair nearest;
  std::vector<TouchingPair> contacts;
  std::vector<StatesWork> of_threads;  ///< made when first needed
  std::vector<StateCheck> checks;
};

/// @throws ArgumentError unless there are as many numbers as variables
void checkStateSize(const RobotMonitor& monitor, Numbers state);

/// The numbers as joint positions; NaN where they mean nothing.
/// @param positions is overwritten
void readPositions(Numbers numbers, JointPositions& positions);

/// An answer of the core in the words of the library.
/// @param verdict of the pair of links
MeasuredPair measuredPair(const CycleSetup& setup, const PairDistance& distance, Verdict verdict);

/// An answer for two links of unknown relative pose.
MeasuredPair unknownPair(std::uint32_t pair);

/// The verdict of one measurement; clear, warning or contact.
Verdict verdictOf(const CycleSetup& setup, const PairDistance& distance) noexcept;

}  // namespace collision_monitor
