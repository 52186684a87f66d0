// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/lanes/lane_targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/look_ahead/walk_link_pairs.cpp"
#include "hwy/foreach_target.h"
// The order matters: Highway first includes this file once for each target.
#include "pipeline/blocks/block_lanes-inl.h"
#include "pipeline/look_ahead/walk_link_pairs.h"

HWY_BEFORE_NAMESPACE();
namespace collision_monitor {
namespace HWY_NAMESPACE {

/// The link pairs of one vector.
struct LinkLanes {
  OneShape one;
  ShapeLanes row;
  const PairReach& common;
  const LaneReaches* own;   ///< null: the common ones
  const double* thickness;  ///< [m] of these pairs
  std::size_t lane;         ///< of the block, where these pairs begin
  BlockPart part;
};

HWY_INLINE Number reachOf(const LinkLanes& pairs, double PairReach::*common,
                          double (LaneReaches::*own)[kBlockLanes]) {
  return pairs.own == nullptr ? number(pairs.common.*common)
                              : hn::Load(Lanes(), pairs.own->*own + pairs.lane);
}

/// The motion of B's ball relative to A.
struct SeenMotion {
  Number moved;   ///< of its center, squared
  Number turned;  ///< squared angle
  Number radius;
};

/// @param c first column of a twist
HWY_INLINE SeenMotion motionSeen(const LinkLanes& pairs, std::size_t c, std::size_t center) {
  const Vector3 linear = vectorAt(pairs.row, c) - vectorAt(pairs.one, c);
  const Vector3 angular = vectorAt(pairs.row, c + 3) - vectorAt(pairs.one, c + 3);
  const Vector3 velocity = linear + cross(angular, vectorAt(pairs.row, center));
  return {dot(velocity, velocity), dot(angular, angular), pairs.row.at(link_column::radius)};
}

HWY_INLINE Number travelOf(const SeenMotion& motion) {
  return hn::Add(hn::Sqrt(motion.moved), hn::Mul(hn::Sqrt(motion.turned), motion.radius));
}

HWY_INLINE Number largerOf(const LinkLanes& pairs, std::size_t column) {
  return hn::Max(pairs.one.at(column), pairs.row.at(column));
}

/// [m] How near pairs must be to matter to past or future motion. No time follows from a speed that
/// is unknown.
HWY_INLINE Number reachByMotion(const LinkLanes& pairs, Number speed) {
  const Number time = largerOf(pairs, link_column::time);
  const Number stop = reachOf(pairs, &PairReach::stop, &LaneReaches::stop);
  const Number asked = hn::Add(stop, hn::Mul(speed, time));
  const Number contact = reachOf(pairs, &PairReach::contact, &LaneReaches::contact);
  const Number came = hn::Add(hn::Add(contact, pairs.one.at(link_column::travel)),
                              pairs.row.at(link_column::travel));
  return hn::Max(hn::IfThenElse(hn::Eq(asked, asked), asked, stop), came);
}

HWY_INLINE void findFarther(const LinkLanes& pairs, std::size_t twist, FarthestPair& farthest) {
  const SeenMotion motion = motionSeen(pairs, twist, link_column::last_center);
  const Number thickness = hn::Load(Lanes(), pairs.thickness);
  // The square of the travel is at most twice this sum, so most pairs need no root.
  const Number least = hn::Mul(number(farthest.share), thickness);
  const Number turned = hn::Mul(motion.turned, hn::Mul(motion.radius, motion.radius));
  const Number most = hn::Mul(number(2.0), hn::Add(motion.moved, turned));
  const std::uint32_t which = bitsOf(hn::Gt(most, hn::Mul(least, least))) & pairs.part.is_pair;
  if (which == 0) {
    return;
  }
  forLanes(pairs.part, which, hn::Div(travelOf(motion), thickness),
           [&](std::uint32_t pair, std::size_t, double share) HWY_ATTR {
             farthest = share > farthest.share ? FarthestPair{share, pair} : farthest;
           });
}

void walkInLanes(const WalkQuestion& question, ActivationDistances& reaches, Farthest& farthest) {
  const double* columns = reaches.rows.numbers.data();
  const LaneReaches* const own = reaches.of_blocks.empty() ? nullptr : reaches.of_blocks.data();
  for (std::size_t i = 0; i < reaches.blocks.size(); ++i) {
    const LinkBlock& block = reaches.blocks[i];
    forParts(block.pairs, [&](std::size_t lane, const BlockPart& part) HWY_ATTR {
      const LinkLanes pairs{{columns + part.one, reaches.rows.stride},
                            {columns + part.first, reaches.rows.stride},
                            reaches.of_limits.front(),
                            own == nullptr ? nullptr : own + i,
                            block.thickness + lane,
                            lane,
                            part};
      const Number speed = travelOf(motionSeen(pairs, link_column::velocity, link_column::center));
      storeByPair(part, speed, reaches.speed);
      storeByPair(part, reachByMotion(pairs, speed), reaches.motion);
      storeByPair(part,
                  hn::Min(reachOf(pairs, &PairReach::all, &LaneReaches::all),
                          largerOf(pairs, link_column::distance)),
                  reaches.told);
      if (question.has_step) {
        findFarther(pairs, link_column::moved, farthest.moved);
      }
      if (question.has_step && question.has_bends) {
        findFarther(pairs, link_column::bent, farthest.bent);
      }
      return true;
    });
  }
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace collision_monitor
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace collision_monitor {
namespace {
HWY_EXPORT(walkInLanes);
}  // namespace

Farthest walkLinkPairs(const WalkQuestion& question, ActivationDistances& reaches) noexcept {
  Farthest farthest;
  HWY_DYNAMIC_DISPATCH(walkInLanes)(question, reaches, farthest);
  return farthest;
}

}  // namespace collision_monitor
#endif
