// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

#include "pipeline/data/robot_speeds.h"
#include "pipeline/refine/sweep_pairs.h"

/// What a cycle needs of every checked link pair, found in one pass. Links stand in columns, and
/// each is joined with several neighbours at once.
namespace collision_monitor {

/// [m] How near pairs with some limits must be to matter at rest.
struct PairReach {
  double all{0.0};      ///< as activationDistanceOf
  double near{0.0};     ///< as nearActivationDistanceOf
  double stop{0.0};     ///< >= contact; up to this a pair may be stopped or held
  double contact{0.0};  ///< the largest contact distance of bodies
};

/// [m] PairReach of the pairs of a block, by lane.
struct LaneReaches {
  alignas(64) double all[kBlockLanes] = {};
  alignas(64) double stop[kBlockLanes] = {};
  alignas(64) double contact[kBlockLanes] = {};
};

/// A link and the links in slots from `pairs.first` on. PairIds are LinkPairIndices here.
struct LinkBlock {
  PairBlock pairs;
  /// [m] by lane: as thicknessOfPairs; infinite for links of two parts
  alignas(64) double thickness[kBlockLanes] = {};
};

/// The pairs [first, last) of one link of a robot with objects that one link or frame carries. All
/// these objects have the same twist.
struct ObjectRange {
  LinkPairIndex first{0};
  LinkPairIndex last{0};
  std::uint32_t link{0};     ///< slot
  std::uint32_t objects{0};  ///< slot of the first of all objects of this carrier
  double thickness{0.0};     ///< [m] the least of these pairs
  std::uint32_t limits{0};   ///< CheckedLinkPair::limits of all of them
};

/// The columns of links. World frame, [m] and [s], or per time between two cycles.
namespace link_column {
constexpr std::size_t center = 0;    ///< of its ball, x, y, z
constexpr std::size_t radius = 3;    ///< of its ball
constexpr std::size_t velocity = 4;  ///< a twist: linear, angular; NaN: unknown
constexpr std::size_t travel = 10;   ///< upper bound for any point of the ball since the last cycle
constexpr std::size_t last_center = 11;  ///< in the last cycle
constexpr std::size_t moved = 14;        ///< a twist per cycle: the motion since the last cycle
constexpr std::size_t bent = 20;         ///< a twist per cycle: bound of the motion off the screw
constexpr std::size_t time = 26;         ///< as Watched::time
constexpr std::size_t distance = 27;     ///< as Watched::distance
constexpr std::size_t count = 28;
}  // namespace link_column

/// The activation distances of all link pairs, and what is needed to find them.
struct ActivationDistances {
  // Made at set-up.
  /// By slot: links of checked pairs; of objects only those in blocks, and the first of each range.
  std::vector<LinkId> links;
  /// By slot: as linkBalls; the first object of a range has a ball about all objects of its
  /// carrier.
  std::vector<Ball> balls;
  std::vector<LinkBlock> blocks;       ///< without the pairs of ranges
  std::vector<LaneReaches> of_blocks;  ///< by block; empty if all pairs have the common limits
  std::vector<ObjectRange> ranges;
  std::vector<double> thickness;     ///< [m] by LinkPairIndex: as thicknessOfPairs
  std::vector<PairReach> of_limits;  ///< by CheckedLinkPair::limits
  PairReach farthest;                ///< the largest of each
  double least_near{0.0};            ///< [m] the least of PairReach::near
  double contact_time{0.0};          ///< [s] a contact may depend on a time to contact up to this
  double warning_time{0.0};          ///< [s] and a warning up to this
  bool is_split{false};              ///< links are in several parts

  BodyRows rows;  ///< of the links
  /// By LinkPairIndex: where these hold its numbers. Pairs of a range share one place.
  std::vector<std::uint32_t> place_of;
  std::vector<double> speed;   ///< [m/s] how fast its links may approach each other; may be unknown
  std::vector<double> motion;  ///< [m] up to this a pair matters by how its links move
  /// [m] Up to this the nearest bodies of two elements matter at rest: as PairReach::all, or less
  /// while only a nearer pair is told.
  std::vector<double> told;

  /// [m] Beyond this a pair matters only if nothing is nearer.
  double of(LinkPairIndex pair) const noexcept {
    return std::max(motion[place_of[pair]], told[place_of[pair]]);
  }
};

ActivationDistances makeActivationDistances(const CycleSetup& setup);

/// [m] By LinkPairIndex: the least sum of the thicknesses of two bodies. Pairs of thickness 0 do
/// not count: they never overlap.
std::vector<double> thicknessOfPairs(const CycleSetup& setup);

/// Finds for each link pair how near its bodies must be to be told, to touch or to lower the speed
/// scale within the horizon at present velocities, or to have touched since the last cycle.
/// Where a velocity is unknown, a pair has no time to contact and its scale follows from its
/// distance alone: beyond PairReach::stop only its nearest bodies matter, and what may have
/// touched. Fills RobotSpeeds::watched: a pair matters less far ahead where another one is expected
/// to touch sooner.
///
/// A distance changes no faster than the ball of B's bodies moves relative to A. Objects may be
/// large or without bounds, so it is the ball of the robot's link that moves relative to them.
///
/// If time has passed, it also fills `sweep.step`. To pass through a link unseen, another must
/// travel farther relative to it than both are thick. If only poses are checked, this travel
/// follows from the twists. If motions are checked, only the departure from the screws is unseen:
/// an even acceleration that changes the travel of a cycle by w bends the path by w / 8.
/// Pairs of two parts set no limit: their relative motion is unknown.
/// Error: step limits are estimates, since twists at one time represent the whole step. The same
/// bytes with every instruction set.
/// @pre `sweep` is filled by findMotions.
void findActivationDistances(const CycleSetup& setup, const LinkPoses& poses, RobotSpeeds& robots,
                             SweepWork& sweep, ActivationDistances& reaches) noexcept;

}  // namespace collision_monitor
