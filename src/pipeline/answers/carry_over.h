// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/pipeline/setup.h"
#include "pipeline/data/cycle_data.h"
#include "pipeline/look_ahead/link_velocities.h"

/// What a set-up takes over from the one before it, when it is swapped in between two cycles. Links
/// are the same if their tf frames are the same; of objects, if their names are the same.
namespace collision_monitor {

/// Which parts of two set-ups are the same. Finding out takes long where there are many pairs, so
/// it is done before the swap.
struct CarryPlan {
  std::vector<std::uint32_t> link_of;   ///< by new LinkId: the former LinkId, or kNone
  std::vector<std::uint32_t> robot_of;  ///< by new RobotId: the former RobotId, or kNone
  std::vector<LinkPairIndex> pair_of;   ///< by new LinkPairIndex: the former one, or kNone
  std::vector<LinkPairIndex> pair_to;   ///< by former LinkPairIndex: the new one, or kNone
};

CarryPlan planCarryOver(const CycleSetup& from, const CycleSetup& to);

/// Copies the speed scale, and the reported verdicts of link pairs that both set-ups check. Takes
/// no longer for pairs that are clear.
/// @return pairs that only the former set-up checks and whose reported verdict is not clear.
std::vector<LinkPairIndex> carryOver(const CarryPlan& plan, const PairMemory& reported,
                                     PairMemory& memory);

/// What is known of the last cycle of the former set-up.
struct FormerMotion {
  const LinkPoses& poses;
  const LastPoses& last;
  const VelocityTracker& tracker;
};

/// Copies the poses of the last cycle and the velocities, so that contacts on the way to the first
/// cycle are found and times to contact stay known. An object counts as having been where its
/// carrier had it then, if it had been joined to it as now: a move by a user is no motion. A new
/// frame counts as at rest if only static transforms place it.
///
/// If other links were known, the first cycle judges all pairs.
/// @param poses those that memory was learnt with, see keepPoses
void carryMotion(const CarryPlan& plan, const CycleSetup& to, const FormerMotion& former,
                 const LinkPoses& poses, PairMemory& memory, VelocityTracker& tracker);

}  // namespace collision_monitor
