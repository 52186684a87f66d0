// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include "collision_monitor/model/kinematics.h"
#include "collision_monitor/pipeline/setup.h"

/// Which pairs of links of a robot can touch at all: for the rules that leave pairs out.
namespace collision_monitor {

/// How much of some work is done.
using WorkProgress = std::function<void(std::size_t done, std::size_t total)>;

struct PairSearchOptions {
  std::size_t states{10000};  ///< drawn; the first is the default one
  std::uint64_t seed{1};
  std::size_t most_cells{20000};  ///< into which a proof may cut the joints' ranges
  WorkProgress state_progress;    ///< told how many states are drawn; may be empty
  WorkProgress proof_progress;  ///< of how many pairs a proof was tried or not needed; may be empty
};

enum class PairFinding : unsigned char {
  adjacent,   ///< as PairReason::adjacent: the links of a joint touch by design; not looked at
  always,     ///< the geometries touch in every state that was looked at
  sometimes,  ///< they touch in one, and are apart in another
  unclear,    ///< what encloses them touches in some, and more is not known of their geometries
  never,      ///< apart in every state that was looked at
};

/// Of one pair of links.
struct PairFound {
  LinkId a{};
  LinkId b{};
  PairFinding finding{PairFinding::adjacent};
  /// Always, never: of all states within the joints' limits, by a proof and not by states drawn.
  bool is_proven{false};
  std::vector<JointId> joints{};  ///< with a variable, that move one of the two against the other
  JointPositions touching{};      ///< sometimes, unclear: such a state
  /// [m] Never: the least distance of enclosing shapes in the states drawn.
  double nearest{std::numeric_limits<double>::infinity()};
};

/// Looks at all pairs of links that have shapes, in random states of the joints: enclosing shapes
/// of several states at once, and the geometries where shapes touch. Pairs that were never seen to
/// touch, with three joint variables between them or fewer, are proven apart where that can be
/// done: the joints' ranges are cut into cells until the distance in the middle of each is more
/// than the links can come nearer within it (boundMotion).
///
/// Joints are drawn evenly within their limits; those without limits within half a turn, or a
/// metre, to both sides. The same seed draws the same states.
/// Error: links nearer than 1e-9 m touch.
/// Limits: states tell nothing of those between them: a pair that was never seen to touch may.
/// Source: Schwarzer, Saha, Latombe (2005) for the bound; subdivision as Moore, Kearfott, Cloud,
/// "Introduction to Interval Analysis" (2009), chapter 8.
/// @pre the setup has one robot.
/// @return sorted by (a, b).
std::vector<PairFound> searchPairs(const CycleSetup& setup, const PairSearchOptions& options);

}  // namespace collision_monitor
