// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Places bodies of one state in lanes: the rows of placeBodies (place_bodies.cpp).
#if defined(COLLISION_MONITOR_PLACE_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef COLLISION_MONITOR_PLACE_LANES_INL_H
#undef COLLISION_MONITOR_PLACE_LANES_INL_H
#else
#define COLLISION_MONITOR_PLACE_LANES_INL_H
#endif

#include <limits>

#include "geometry/lanes/turn_rows-inl.h"
#include "model/kinematics/state_lanes-inl.h"
#include "narrow_phase/simd/shape_lanes-inl.h"
#include "pipeline/cycle/cycle_buffers.h"

HWY_BEFORE_NAMESPACE();
namespace collision_monitor {
namespace HWY_NAMESPACE {

/// isRigid in the same order of operations, so to the last bit.
HWY_INLINE Truth isRigidInLanes(const PoseLanes& pose) {
  const Axes& axes = pose.axes;
  const Vector3 across = cross(axes.x, axes.y) - axes.z;
  const Number defects[] = {hn::Sub(dot(axes.x, axes.x), number(1.0)),
                            hn::Sub(dot(axes.y, axes.y), number(1.0)),
                            dot(axes.x, axes.y),
                            across.x,
                            across.y,
                            across.z};
  Number sum = sumOf(pose.translation - pose.translation);
  for (const Number defect : defects) {
    sum = hn::Add(sum, hn::Mul(defect, defect));
  }
  return hn::Le(sum, number(kRigid * kRigid));
}

/// Lanes of a vector whose links are `known`, from slot `lane` of the group on.
HWY_INLINE Truth hasStatusKnown(const SlotGroup& group, std::size_t lane, const LinkPoses& poses) {
  std::uint8_t bits[8] = {};
  for (std::size_t i = 0; i < hn::Lanes(Lanes()); ++i) {
    const bool is_known = poses.status[group.link[lane + i]] == LinkStatus::known;
    bits[0] |= static_cast<std::uint8_t>(is_known ? 1U << i : 0U);
  }
  return hn::LoadMaskBits(Lanes(), bits);
}

HWY_INLINE FourNumbers readNumbers(const double* first, const std::int64_t* pose_at) {
  return turnRows([=](std::size_t lane) HWY_ATTR { return first + pose_at[lane]; });
}

HWY_INLINE PoseLanes readPoses(const double* first, const std::int64_t* pose_at) {
  const FourNumbers a = readNumbers(first, pose_at);
  const FourNumbers b = readNumbers(first + 4, pose_at);
  const FourNumbers c = readNumbers(first + 8, pose_at);
  return {{{a.at[0], a.at[1], a.at[2]}, {a.at[3], b.at[0], b.at[1]}, {b.at[2], b.at[3], c.at[0]}},
          {c.at[1], c.at[2], c.at[3]}};
}

HWY_INLINE void storeColumns(const Vector3& v, std::size_t c, std::size_t slot, BodyRows& rows) {
  hn::StoreU(v.x, Lanes(), rows.at(c) + slot);
  hn::StoreU(v.y, Lanes(), rows.at(c + 1) + slot);
  hn::StoreU(v.z, Lanes(), rows.at(c + 2) + slot);
}

/// Places the bodies of a group; bodies of unknown links get NaN.
HWY_INLINE void placeGroup(const std::vector<SlotGroup>& groups, std::size_t place,
                           const LinkPoses& poses, BodyRows& rows) {
  const SlotGroup& group = groups[place];
  const double* first = poses.world_from_link.front().rotation.data();
  for (std::size_t lane = 0; lane < kBlockLanes; lane += hn::Lanes(Lanes())) {
    const auto ofBody = [&](std::size_t c) HWY_ATTR {
      return Vector3{hn::Load(Lanes(), group.link_from_body[c] + lane),
                     hn::Load(Lanes(), group.link_from_body[c + 1] + lane),
                     hn::Load(Lanes(), group.link_from_body[c + 2] + lane)};
    };
    const PoseLanes world_from_link = readPoses(first, group.pose_at + lane);
    const Truth is_known =
        hn::And(hasStatusKnown(group, lane, poses), isRigidInLanes(world_from_link));
    const std::size_t slot = place * kBlockLanes + lane;
    Vector3 center = world_from_link * ofBody(9);
    center.x = sureWhere(is_known, center.x);
    storeColumns(center, column::center, slot, rows);
    if (group.kind != CoreKind::point) {
      storeColumns(out(world_from_link.axes, ofBody(6)), column::axis_z, slot, rows);
    }
    if (group.kind == CoreKind::box) {
      storeColumns(out(world_from_link.axes, ofBody(0)), column::axis_x, slot, rows);
      storeColumns(out(world_from_link.axes, ofBody(3)), column::axis_y, slot, rows);
    }
  }
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace collision_monitor
HWY_AFTER_NAMESPACE();

#endif
