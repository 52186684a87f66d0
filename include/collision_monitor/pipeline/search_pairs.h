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

/// How long a search goes on, and from where.
struct PairSearchOptions {
  std::size_t states{10000};         ///< how many are drawn; the first is the default state
  std::uint64_t seed{1};             ///< the same seed draws the same states
  std::size_t most_cells{20000000};  ///< how many cells a proof may cut the joints' ranges into
  double time_limit{60.0};           ///< [s] for all proofs; those that are not done then stay open
  std::vector<Pose> world_from_root;  ///< by RobotId; robots that are not in it stand at the origin
  WorkProgress state_progress;        ///< states drawn so far; may be empty
  WorkProgress proof_progress;        ///< pairs whose proof is over or not needed; may be empty
};

/// What a search found of a pair.
enum class PairFinding : unsigned char {
  adjacent,   ///< as PairReason::adjacent: links of a joint touch by design; not measured
  always,     ///< the geometries touch in every state drawn
  sometimes,  ///< the geometries touch in some states and are apart in others
  unclear,    ///< enclosing shapes touch in some states; whether geometries do is unknown
  never,      ///< apart in every state drawn
};

/// The finding for one pair of links.
struct PairFound {
  LinkId a{};                                  ///< a < b
  LinkId b{};                                  ///< the other link
  PairFinding finding{PairFinding::adjacent};  ///< what was found
  /// `always` and `never` hold for all states within the joints' limits, by a proof.
  bool is_proven{false};
  std::vector<JointId> joints{};  ///< joints with a variable that move one link against the other
  JointPositions touching{};      ///< `sometimes` and `unclear`: a state in which they touch
  /// [m] `never`: the least distance of enclosing shapes in the states drawn.
  double nearest{std::numeric_limits<double>::infinity()};
};

/// Measures all pairs of links that have shapes, in random states of the joints: enclosing shapes
/// of several states at once, and geometries where shapes touch. Descends from the nearest state of
/// each pair that did not touch, to a state that touches if it can. Then tries to prove what the
/// states showed, on all cores: that a pair never touches, or always does.
///
/// Proofs. The ranges of the joints between two links are a box of as many dimensions. It is cut
/// into cells, and a cell is cut in two, until a bound holds in each of them (branch and bound).
/// The variable is cut that moves the pair most. A bound follows the chain of joints from one link
/// to the other and holds in the whole cell. Links are apart in it where one of these holds for
/// each pair of their elements, the cheap ones first:
///
/// 1. Balls that enclose them, swept by one joint after the other, are apart. This holds in wide
///    cells: joints at the end of a chain need not be cut at all.
/// 2. In the middle of the cell they are farther apart than joints can move them: the sum of
///    chords times lever arms.
/// 3. Along the normal of their hulls in the middle, the gap of no two vertices can close: first
///    derivatives at each vertex, and a bound of second derivatives in the cell. What moves along
///    the gap's sides costs little, so cells may be wide where 2. needs narrow ones.
/// 4. As 2. by the distance of meshes, where hulls do not suffice.
///
/// Links touch in a cell where a penetration depth in its middle exceeds what joints can move: then
/// no direction separates them. It is that of convex geometries that are elements, or are proven to
/// lie in them.
///
/// Every bound must exceed the rounding of all that it was computed from, 1e-8 m and 1e-10 of the
/// chain's length. No proof covers planar and floating joints, and joints that may leave their
/// range. Proofs depend on nothing but their pair, so the number of threads changes no answer;
/// `time_limit` can.
///
/// Joints are drawn uniformly within their limits; joints without limits within half a turn or one
/// metre to both sides. The same seed draws the same states.
/// Error: links nearer than 1e-9 m touch.
/// Limits: states say nothing of what is between them: a pair that never touched may still touch.
/// Source: lever arms: Schwarzer, Saha, Latombe, "Adaptive Dynamic Collision Checking for Single
/// and Multiple Articulated Robots in Complex Environments" (2005), section IV. Cells and the mean
/// value form: Moore, Kearfott, Cloud, "Introduction to Interval Analysis" (2009), chapters 6
/// and 8.
/// @pre world_from_root has at most one pose per robot.
/// @return sorted by (a, b).
std::vector<PairFound> searchPairs(const CycleSetup& setup, const PairSearchOptions& options);

}  // namespace collision_monitor
