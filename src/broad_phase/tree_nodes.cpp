// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "broad_phase/tree_nodes.h"

#include <cmath>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "broad_phase/tree_nodes.cpp"
#include <hwy/foreach_target.h>  // compiles what follows up to HWY_ONCE for every instruction set
#include <hwy/highway.h>

#include "broad_phase/pack_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace collision_monitor {
namespace HWY_NAMESPACE {

// No templates of the standard library here, as in box_rows.cpp.
using Lanes = hn::CappedTag<float, kTreeChildren>;
using Number = hn::Vec<Lanes>;

HWY_INLINE Number inAllLanes(float value) { return hn::Set(Lanes(), value); }

/// The boxes of some children, beside the center of the oriented box.
struct ChildLanes {
  Number center[3];
  Number half[3];
  Number size;  ///< of numbers that were added
};

HWY_INLINE ChildLanes childrenAt(const TreeNode& node, const NearBox& box, std::size_t first) {
  const Number one_half = inAllLanes(0.5F);
  ChildLanes children;
  children.size = inAllLanes(0.0F);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Number min = hn::LoadU(Lanes(), node.min[axis] + first);
    const Number max = hn::LoadU(Lanes(), node.max[axis] + first);
    children.center[axis] =
        hn::Sub(hn::Mul(one_half, hn::Add(min, max)), inAllLanes(box.center[axis]));
    children.half[axis] = hn::Mul(one_half, hn::Sub(max, min));
    children.size = hn::Add(children.size, hn::Max(hn::Abs(min), hn::Abs(max)));
  }
  return children;
}

/// The children from `first` on whose boxes meet that of everything near.
HWY_INLINE hn::Mask<Lanes> meetingChildren(const TreeNode& node, const NearBox& box,
                                           std::size_t first) {
  const auto on = [&](std::size_t axis) HWY_ATTR {
    return hn::And(hn::Le(hn::LoadU(Lanes(), node.min[axis] + first), inAllLanes(box.max[axis])),
                   hn::Le(inAllLanes(box.min[axis]), hn::LoadU(Lanes(), node.max[axis] + first)));
  };
  return hn::And(hn::And(on(0), on(1)), on(2));
}

/// The children from `first` on that may be near. Along each axis of the oriented box the points of
/// both are at least `gap` apart, and these axes are perpendicular.
HWY_INLINE hn::Mask<Lanes> nearChildren(const TreeNode& node, const NearBox& box, Number size,
                                        std::size_t first) {
  const Number rounding = inAllLanes(2e-6F);  // of sums of such numbers
  const ChildLanes children = childrenAt(node, box, first);
  const Number error = hn::Mul(rounding, hn::Add(children.size, size));
  Number squared = inAllLanes(0.0F);
  for (std::size_t i = 0; i < 3; ++i) {
    Number along = inAllLanes(0.0F);
    Number reach = hn::Add(inAllLanes(box.half[i]), error);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Number unit = inAllLanes(box.axes[i][axis]);
      along = hn::Add(along, hn::Mul(unit, children.center[axis]));
      reach = hn::Add(reach, hn::Mul(hn::Abs(unit), children.half[axis]));
    }
    const Number gap = hn::Max(hn::Sub(hn::Abs(along), reach), inAllLanes(0.0F));
    squared = hn::Add(squared, hn::Mul(gap, gap));
  }
  return hn::Le(squared, inAllLanes(box.within * box.within));
}

std::size_t findChildren(const TreeNode* nodes, const SomeNodes& which, const NearBox& box,
                         NearTest test, std::uint32_t* found) {
  const hn::Rebind<std::uint32_t, Lanes> integers;
  Number size = inAllLanes(0.0F);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    size =
        hn::Add(size, hn::Add(hn::Abs(inAllLanes(box.center[axis])), inAllLanes(box.half[axis])));
  }
  std::size_t written = 0;
  for (std::size_t i = 0; i < which.count; ++i) {
    const TreeNode& node = nodes[which.first[i]];
    const auto children = static_cast<std::uint32_t>(kTreeChildren) * which.first[i];
    for (std::size_t first = 0; first < kTreeChildren; first += hn::Lanes(Lanes())) {
      auto near = meetingChildren(node, box, first);
      if (test == NearTest::fine) {
        near = hn::And(near, nearChildren(node, box, size, first));
      }
      const auto are_near = hn::RebindMask(integers, near);
      const auto ids = hn::Iota(integers, children + static_cast<std::uint32_t>(first));
      hn::StoreU(packed(ids, are_near), integers, found + written);
      written += hn::CountTrue(integers, are_near);
    }
  }
  return written;
}

}  // namespace HWY_NAMESPACE
}  // namespace collision_monitor
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace collision_monitor {
namespace {
HWY_EXPORT(findChildren);
}  // namespace

NearBox nearBoxOf(const Pose& tree_from_box, const Eigen::Vector3d& half, double within) noexcept {
  constexpr double kMore = 1.0 + 10.0 * kRigid;  // axes are not quite perpendicular
  constexpr double kRounding = 1e-6;
  const Eigen::Vector3d center = tree_from_box.translation;
  const double near = within <= std::numeric_limits<float>::max() / kMore
                          ? kMore * within
                          : std::numeric_limits<double>::infinity();
  const Eigen::Vector3d reach = tree_from_box.rotation.cwiseAbs() * half;
  const double rounding = kRounding * (center.norm() + reach.norm() + std::abs(near));
  NearBox box;
  for (Eigen::Index i = 0; i < 3; ++i) {
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      box.axes[i][axis] = static_cast<float>(tree_from_box.rotation(axis, i));
    }
    box.center[i] = static_cast<float>(center[i]);
    box.half[i] = static_cast<float>(half[i]);
    box.min[i] = static_cast<float>(center[i] - reach[i] - near - rounding);
    box.max[i] = static_cast<float>(center[i] + reach[i] + near + rounding);
  }
  box.within = static_cast<float>(near);
  return box;
}

std::size_t findNearChildren(const TreeNode* nodes, const SomeNodes& which, const NearBox& box,
                             NearTest test, std::uint32_t* found) noexcept {
  return HWY_DYNAMIC_DISPATCH(findChildren)(nodes, which, box, test, found);
}

}  // namespace collision_monitor
#endif
