// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The children of a MeshTree node in lanes.
#if defined(COLLISION_MONITOR_MESH_BOUNDS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef COLLISION_MONITOR_MESH_BOUNDS_INL_H
#undef COLLISION_MONITOR_MESH_BOUNDS_INL_H
#else
#define COLLISION_MONITOR_MESH_BOUNDS_INL_H
#endif

#include "hwy/highway.h"
#include "narrow_phase/mesh/mesh_bounds.h"

HWY_BEFORE_NAMESPACE();
namespace collision_monitor {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Some children of a node, one per lane. No fused multiply-add, so that every instruction set
// rounds alike.
using Some = hn::CappedTag<float, MeshTreeNode::kWidth>;
using Number = hn::Vec<Some>;

HWY_INLINE Number number(float value) { return hn::Set(Some(), value); }
HWY_INLINE Number load(const float* from) { return hn::Load(Some(), from); }

struct Vector {
  Number at[3];
};

HWY_INLINE Vector vector(const float* xyz) {
  return {{number(xyz[0]), number(xyz[1]), number(xyz[2])}};
}
HWY_INLINE Vector load(const float (&from)[3][MeshTreeNode::kWidth], std::size_t first) {
  return {{load(from[0] + first), load(from[1] + first), load(from[2] + first)}};
}
HWY_INLINE Vector operator-(const Vector& a, const Vector& b) {
  return {{hn::Sub(a.at[0], b.at[0]), hn::Sub(a.at[1], b.at[1]), hn::Sub(a.at[2], b.at[2])}};
}
HWY_INLINE Vector operator*(Number s, const Vector& v) {
  return {{hn::Mul(s, v.at[0]), hn::Mul(s, v.at[1]), hn::Mul(s, v.at[2])}};
}
HWY_INLINE Vector absolute(const Vector& v) {
  return {{hn::Abs(v.at[0]), hn::Abs(v.at[1]), hn::Abs(v.at[2])}};
}
HWY_INLINE Number dot(const Vector& a, const Vector& b) {
  return hn::Add(hn::Add(hn::Mul(a.at[0], b.at[0]), hn::Mul(a.at[1], b.at[1])),
                 hn::Mul(a.at[2], b.at[2]));
}

struct Children {
  Vector center, half, normal;
  Number slab_center, slab_half;
};

HWY_INLINE Children childrenOf(const MeshTreeNode& node, std::size_t first) {
  return {load(node.center, first), load(node.half, first), load(node.normal, first),
          load(node.slab_center + first), load(node.slab_half + first)};
}

// The same child in all lanes.
HWY_INLINE Children everywhere(const Bound& child) {
  return {vector(child.center.data()), vector(child.half.data()), vector(child.normal.data()),
          number(child.slab_center), number(child.slab_half)};
}

// The interval that a bound covers along a direction.
struct Shadow {
  Number middle, half;
};

// A direction u is split as u = c n + w, where n is the normal of the slab. The slab bounds c n.x
// and the box bounds w.x. Near the normal w is small, and the shadow is as thin as the slab.
HWY_INLINE Shadow shadowOf(const Children& children, const Vector& u, Number shared) {
  const Vector rest = u - shared * children.normal;
  return {
      hn::Add(hn::Mul(shared, children.slab_center), dot(rest, children.center)),
      hn::Add(hn::Mul(hn::Abs(shared), children.slab_half), dot(absolute(rest), children.half))};
}

// The end of the interval that children cover along a direction, by the box alone or with the slab.
HWY_INLINE Number endOf(const Children& children, const Vector& u) {
  const Shadow with_slab = shadowOf(children, u, dot(u, children.normal));
  const Number of_box = hn::Add(dot(u, children.center), dot(absolute(u), children.half));
  return hn::Min(hn::Add(with_slab.middle, with_slab.half), of_box);
}

HWY_INLINE Number gapBetween(const Shadow& a, const Shadow& b) {
  return hn::Sub(hn::Abs(hn::Sub(a.middle, b.middle)), hn::Add(a.half, b.half));
}

// Keeps the bounds of some children. @return a bit for each that is below the limit.
HWY_INLINE std::uint32_t keepBounds(Number squared, Number order, float limit, std::size_t first,
                                    NodeBounds& bounds) {
  hn::Store(squared, Some(), bounds.squared + first);
  hn::Store(order, Some(), bounds.order + first);
  std::uint8_t bits[8] = {};  // Highway may write eight bytes
  hn::StoreMaskBits(Some(), hn::Lt(squared, number(limit)), bits);
  return static_cast<std::uint32_t>(bits[0]) << first;
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace collision_monitor
HWY_AFTER_NAMESPACE();

#endif
