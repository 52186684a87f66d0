// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include "collision_monitor/model/kinematics.h"
#include "collision_monitor/pipeline/setup.h"

/// Finds which pairs of links of a robot can touch at all, for rules that leave pairs out.
namespace collision_monitor {

/// Reports how much of some work is done.
using WorkProgress = std::function<void(std::size_t done, std::size_t total)>;

struct PairSearchOptions {
  std::size_t states{10000};  ///< how many are drawn; the first is the default state
  std::uint64_t seed{1};
  std::size_t most_cells{20000};  ///< how many cells a proof may cut the joints' ranges into
  WorkProgress state_progress;    ///< states drawn so far; may be empty
  WorkProgress proof_progress;    ///< pairs whose proof was tried or not needed; may be empty
};

enum class PairFinding : unsigned char {
  adjacent,   ///< as PairReason::adjacent: links of a joint touch by design; not measured
  always,     ///< the geometries touch in every state drawn
  sometimes,  ///< the geometries touch in some states and are apart in others
  unclear,    ///< enclosing shapes touch in some states; whether geometries do is unknown
  never,      ///< apart in every state drawn
};

/// The finding for one pair of links.
struct PairFound {
  LinkId a{};
  LinkId b{};
  PairFinding finding{PairFinding::adjacent};
  /// `always` and `never` hold for all states within the joints' limits, by a proof.
  bool is_proven{false};
  std::vector<JointId> joints{};  ///< joints with a variable that move one link against the other
  JointPositions touching{};      ///< `sometimes` and `unclear`: a state in which they touch
  /// [m] `never`: the least distance of enclosing shapes in the states drawn.
  double nearest{std::numeric_limits<double>::infinity()};
};

/// Measures all pairs of links that have shapes, in random states of the joints: enclosing shapes
/// of several states at once, and geometries where shapes touch. Then tries to prove apart the
/// pairs that never touched, if at most three joint variables are between them. The proof cuts the
/// joints' ranges into cells until the distance at the center of each cell exceeds the motion
/// within it (boundMotion).
///
/// Joints are drawn uniformly within their limits; joints without limits within half a turn or one
/// metre to both sides. The same seed draws the same states.
/// Error: links nearer than 1e-9 m touch.
/// Limits: states say nothing of what is between them: a pair that never touched may still touch.
/// Source: Schwarzer, Saha, Latombe (2005) for the bound; subdivision as Moore, Kearfott, Cloud,
/// "Introduction to Interval Analysis" (2009), chapter 8.
/// @pre the setup has one robot.
/// @return sorted by (a, b).
std::vector<PairFound> searchPairs(const CycleSetup& setup, const PairSearchOptions& options);

}  // namespace collision_monitor
