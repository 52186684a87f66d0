// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/pipeline/setup.h"
#include "pipeline/cycle/link_walk.h"
#include "pipeline/data/cycle_data.h"
#include "pipeline/refine/refine_pairs.h"
#include "pipeline/refine/sweep_pairs.h"

namespace collision_monitor {

/// All arrays of one cycle, sized so that no cycle allocates.
struct CycleBuffers {
  BodyPoses body_poses;
  BodyBounds bounds;
  PairReaches reaches;
  std::vector<PairId> candidates;
  std::vector<PairId> waiting;  ///< as measureWaiting
  PairDistances distances;
  RefineWork refine;
  SweepWork sweep;
  PairEvents events;
  PairMemory memory;
  CycleCounters counters;
  BroadPhase broad_phase;
  bool culls_by_boxes{false};  ///< BroadPhaseKind::combination
};

/// Sized for the set-up, nothing known.
BodyPoses makeBodyPoses(const CycleSetup& setup);

/// For findContact; shapes that overlap as in checkStates.
ContactDistances contactDistancesOf(const CycleSetup& setup);

CycleBuffers makeBuffers(const CycleSetup& setup, BroadPhaseKind kind);

/// Forgets where links were: after a jump in time, or when nobody was told. What happened between
/// the last cycle and the next one is then not looked into. The verdicts that were reported and the
/// speed scale stay: they hold until new poses say otherwise.
void forgetPoses(CycleBuffers& buffers) noexcept;

/// Forgets all that earlier cycles left, as if there had been none.
void resetMemory(CycleBuffers& buffers) noexcept;

/// Takes over the speed scale and, of pairs of links that both set-ups check, what was reported of
/// them. Links are the same if their tf frames are.
/// @return pairs of `from` that were not reported as clear, and that `to` does not check.
std::vector<LinkPairIndex> carryOver(const CycleSetup& from, const PairMemory& reported,
                                     const CycleSetup& to, PairMemory& memory);

/// Measures what one cycle may have no budget for, and judges nothing: where many links come to be
/// known at once, as at the start, the next cycle would else call contacts of enclosing shapes.
/// Takes the time of as many cycles as that needs, of 50 at most. @pre as runCycle
void learnPairs(const CycleSetup& setup, const LinkPoses& poses, CycleBuffers& buffers) noexcept;

/// One cycle: poses in, events out. Same input and memory, same bytes out,
/// whichever broad phase. Neither allocates, locks nor throws.
/// @pre buffers were made for this set-up; poses are sized for its model.
void runCycle(const CycleSetup& setup, const LinkPoses& poses, CycleBuffers& buffers) noexcept;

/// The stages of runCycle, in order, with those of sweep_pairs.h and link_walk.h, for those who
/// need a part of it.

void placeBodies(const CycleSetup& setup, const LinkPoses& poses, BodyPoses& body_poses) noexcept;

/// The rows of placeBodies alone, to the last bit: for those who measure all pairs of one pose.
/// Parts that float are not told apart here.
/// @pre all known links stand in one part
void placeRows(const CycleSetup& setup, const LinkPoses& poses, BodyRows& rows) noexcept;

/// Whether any pair is in contact when the links are in these poses: as placeBodies and then
/// findContact of pair_blocks.h, but bodies are placed in `rows` only as the search comes to them.
/// @pre as placeRows
void findContact(const CycleSetup& setup, const LinkPoses& poses, const ContactDistances& limits,
                 BodyRows& rows, FoundContact& found) noexcept;

/// What stands behind the bodies, for stages that refine.
/// @pre the bodies are placed.
void placeElements(const CycleSetup& setup, const LinkPoses& poses, BodyPoses& body_poses) noexcept;

/// Boxes grown by `reach` / 2 [m], so that bodies within reach of each other have boxes that meet.
void boundBodies(const CycleSetup& setup, const BodyPoses& body_poses, double reach,
                 BodyBounds& bounds) noexcept;

/// Grows the boxes by as far as their bodies can get in `duration` [s], so that bodies that may be
/// within reach by then have boxes that meet, too. What all links share, the first robot's root
/// moving with them, counts for nothing. Links of parts that float share nothing with the others.
void growBounds(const CycleSetup& setup, const LinkPoses& poses, double duration,
                BodyBounds& bounds) noexcept;

/// Nothing known.
KnownGaps makeKnownGaps(const CycleSetup& setup);

/// Follows how far bodies have come, so that gaps stay what they are.
/// Where a link was not known in the last cycle, or in another part, all gaps are forgotten.
/// @pre bodies are placed and bounded; motions are found; memory.last is that of the last cycle.
void followWays(const CycleSetup& setup, const LinkPoses& poses, CycleBuffers& buffers) noexcept;

/// Takes out candidates that are too far apart to matter: by the distances that were measured
/// before, less the ways since, by bounding spheres, which do not turn, and in a combined run what
/// is left by the separating axes of the boxes about their cores. Counts all three. Of two elements
/// that were refined in the last cycle it also takes out the bodies that cannot be the nearest, and
/// lets them wait.
void cullCandidates(const CycleSetup& setup, CycleBuffers& buffers) noexcept;

/// @pre `pairs` is sorted by id and joins known bodies only; `distances` has room for every pair.
void measurePairs(const CycleSetup& setup, const BodyPoses& body_poses,
                  const std::vector<PairId>& pairs, PairDistances& distances) noexcept;

/// As measurePairs, after what `distances` hold already.
void addPairs(const CycleSetup& setup, const BodyPoses& body_poses,
              const std::vector<PairId>& pairs, PairDistances& distances) noexcept;

/// Keeps of what was measured the pairs that are near, and of each two elements within reach the
/// nearest bodies: what is left does not depend on what was culled, nor by what. Remembers all
/// distances as gaps.
void keepNear(const CycleSetup& setup, CycleBuffers& buffers) noexcept;

/// Measures what waits as well, where the elements were not refined in this cycle: `distances` are
/// then as if nothing had waited. What still waits then is what was measured.
void measureWaiting(const CycleSetup& setup, CycleBuffers& buffers) noexcept;

/// Makes sure that the closest of all known pairs is among `distances`, which hold the
/// nearest within `reach` and what `refined` made of them. Costs nothing when one is that near;
/// otherwise searches all pairs, except those that were refined and those across two parts. What it
/// adds is not refined.
void measureClosest(const CycleSetup& setup, const BodyPoses& body_poses, RefineWork& refined,
                    double reach, PairDistances& distances) noexcept;

/// Fills closing speeds and times to contact; unknown where a link's velocity is.
void findClosings(const CycleSetup& setup, const LinkPoses& poses,
                  PairDistances& distances) noexcept;

void judgePairs(const CycleSetup& setup, const BodyPoses& body_poses,
                const LinkVelocities& velocities, const PairDistances& distances,
                PairMemory& memory, PairEvents& events) noexcept;

/// The speed scale of all pairs: the least that one asks for; 0 while a pair is unknown, and where
/// links met since the last cycle.
void scaleSpeed(const CycleSetup& setup, std::int64_t stamp_ns, const PairDistances& distances,
                const PairEvents& events, SpeedScale& speed) noexcept;

/// Pairs at this distance or nearer matter to a cycle: to be published, warned of or kept by
/// hysteresis. Units: metres.
double reachOf(const Limits& limits) noexcept;

/// The same without what is only published: to be refined, warned of or kept by hysteresis.
double nearReachOf(const CycleSetup& setup) noexcept;

}  // namespace collision_monitor
