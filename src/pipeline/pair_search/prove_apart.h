// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "pipeline/data/motion_bound.h"
#include "pipeline/pair_search/joint_ranges.h"
#include "pipeline/trajectory/link_pair_distance.h"

namespace collision_monitor {

/// Whether two links touch in one state.
enum class Touch : unsigned char { apart, touching, unclear };

Touch touchOf(const PairDistance& distance) noexcept;

/// The joints of these ranges between two links, as in chainBetween.
LinkChain chainOf(const RobotModel& model, const std::vector<JointRange>& ranges, LinkId a,
                  LinkId b);

struct ApartProof {
  bool is_proven{false};      ///< apart in every state within the ranges
  Touch found{Touch::apart};  ///< touching or unclear: in `state`, where the search ended
  JointPositions state;
  std::size_t cells{0};  ///< number of visited cells
};

/// Tries to prove two links apart, as described at searchPairs.
/// @param ranges from jointRanges.
ApartProof proveApart(LinkPairMeasures& measures, LinkPairIndex pair,
                      const std::vector<JointRange>& ranges, std::size_t most_cells);

}  // namespace collision_monitor
