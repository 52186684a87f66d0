// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "narrow_phase/mesh/mesh_bounds.cpp"
#include "hwy/foreach_target.h"
// The order matters: Highway first includes this file once for each target.
#include <algorithm>

#include "narrow_phase/mesh/mesh_bounds-inl.h"

HWY_BEFORE_NAMESPACE();
namespace collision_monitor {
namespace HWY_NAMESPACE {

struct Other {
  Vector center, sides[3], reach, normal;
  Number slab_center, slab_half, slack;
};

HWY_INLINE Other everywhere(const PlacedBound& bound) {
  const float* sides = bound.sides.data();  // column after column
  return {vector(bound.center.data()), {vector(sides), vector(sides + 3), vector(sides + 6)},
          vector(bound.reach.data()),  vector(bound.normal.data()),
          number(bound.slab_center),   number(bound.slab_half),
          number(bound.slack)};
}

HWY_INLINE Shadow shadowOf(const Other& other, const Vector& u, Number shared) {
  const Vector rest = u - shared * other.normal;
  const Number of_sides =
      hn::Add(hn::Add(hn::Abs(dot(rest, other.sides[0])), hn::Abs(dot(rest, other.sides[1]))),
              hn::Abs(dot(rest, other.sides[2])));
  return {hn::Add(hn::Mul(shared, other.slab_center), dot(rest, other.center)),
          hn::Add(hn::Mul(hn::Abs(shared), other.slab_half), of_sides)};
}

// The gap along the line of centers, which separates far bounds.
HWY_INLINE Number gapAlongCenters(const Children& children, const Other& other) {
  const Vector between = other.center - children.center;
  const Number squared = hn::Add(dot(between, between), number(1e-30F));
  // Slightly less than unit, so that no gap comes out too large.
  const Vector u = hn::Div(number(1.0F - 1e-6F), hn::Sqrt(squared)) * between;
  return gapBetween(shadowOf(other, u, dot(u, other.normal)),
                    shadowOf(children, u, dot(u, children.normal)));
}

HWY_INLINE Number squaredGapOfBoxes(const Children& children, const Other& other) {
  const Vector between = absolute(children.center - other.center) - children.half - other.reach;
  const Number zero = hn::Zero(Some());
  const Vector gap{
      {hn::Max(between.at[0], zero), hn::Max(between.at[1], zero), hn::Max(between.at[2], zero)}};
  return dot(gap, gap);
}

std::uint32_t boundNode(const MeshTreeNode& node, const PlacedBound& bound, float limit,
                        NodeBounds& bounds) {
  std::uint32_t nearer = 0;
  for (std::size_t first = 0; first < MeshTreeNode::kWidth; first += hn::Lanes(Some())) {
    const Children children = childrenOf(node, first);
    const Other other = everywhere(bound);
    // Along its own normal each has the extent of its slab.
    const Number shared = dot(children.normal, other.normal);
    const Number along_children = gapBetween(shadowOf(other, children.normal, shared),
                                             {children.slab_center, children.slab_half});
    const Number along_other =
        gapBetween(shadowOf(children, other.normal, shared), {other.slab_center, other.slab_half});
    const Number along_centers = gapAlongCenters(children, other);
    // The slack of the slabs does not suffice: it covers only the part along their normals.
    const Number widest = hn::Max(hn::Max(along_children, along_other), along_centers);
    const Number gap = hn::Max(hn::Sub(widest, other.slack), hn::Zero(Some()));
    const Number squared = hn::Max(squaredGapOfBoxes(children, other), hn::Mul(gap, gap));
    nearer |= keepBounds(squared, along_centers, limit, first, bounds);
  }
  return nearer;
}

// How far `other` lies beyond the children along a unit vector.
HWY_INLINE Number gapAlong(const Children& children, const Other& other, const Vector& u) {
  const Shadow with_slab = shadowOf(other, u, dot(u, other.normal));
  const Shadow of_box = shadowOf(other, u, hn::Zero(Some()));
  const Number start =
      hn::Max(hn::Sub(with_slab.middle, with_slab.half), hn::Sub(of_box.middle, of_box.half));
  return hn::Sub(hn::Sub(start, endOf(children, u)), other.slack);
}

void gapsOfChildren(const MeshTreeNode& node, const PlacedBound& bound, const float* direction,
                    float* gaps) {
  for (std::size_t first = 0; first < MeshTreeNode::kWidth; first += hn::Lanes(Some())) {
    hn::StoreU(gapAlong(childrenOf(node, first), everywhere(bound), vector(direction)), Some(),
               gaps + first);
  }
}

void gapsAlongMany(const Bound& child, const PlacedBound& bound, const Directions& directions,
                   float* gaps) {
  for (std::size_t first = 0; first < kDirections; first += hn::Lanes(Some())) {
    const Vector u = load(directions.at, first);
    hn::StoreU(gapAlong(everywhere(child), everywhere(bound), u), Some(), gaps + first);
  }
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace collision_monitor
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace collision_monitor {
namespace {

HWY_EXPORT(boundNode);
HWY_EXPORT(gapsOfChildren);
HWY_EXPORT(gapsAlongMany);

}  // namespace

BoundPlacement makePlacement(const Pose& a_from_b, double size) noexcept {
  constexpr double kSlack = 1.0 / (1 << 17);  // 128 u
  // Farther than searches look, nearer than empty slots. A translation that overflows is this far.
  static constexpr double kFar = 1e17;
  const auto withinFar = [](double x) { return std::max(-kFar, std::min(kFar, x)); };
  const Eigen::Vector3d translation = a_from_b.translation.unaryExpr(withinFar);
  return {a_from_b.rotation.cast<float>(), translation.cast<float>(),
          static_cast<float>(kSlack * std::min(kFar, size))};
}

Bound boundOf(const MeshTreeNode& node, std::uint32_t slot) noexcept {
  return {{node.center[0][slot], node.center[1][slot], node.center[2][slot]},
          {node.half[0][slot], node.half[1][slot], node.half[2][slot]},
          {node.normal[0][slot], node.normal[1][slot], node.normal[2][slot]},
          node.slab_center[slot],
          node.slab_half[slot]};
}

PlacedBound place(const BoundPlacement& placement, const Bound& bound) noexcept {
  PlacedBound placed;
  placed.center = placement.rotation * bound.center + placement.translation;
  placed.sides = placement.rotation * bound.half.asDiagonal();
  placed.reach = placed.sides.cwiseAbs().rowwise().sum().array() + placement.slack;
  placed.normal = placement.rotation * bound.normal;
  placed.slab_center = bound.slab_center + placed.normal.dot(placement.translation);
  placed.slab_half = bound.slab_half + placement.slack;
  placed.slack = 2.0F * placement.slack;
  return placed;
}

std::uint32_t boundNearer(const MeshTreeNode& node, const PlacedBound& other, float limit,
                          NodeBounds& bounds) noexcept {
  return HWY_DYNAMIC_DISPATCH(boundNode)(node, other, limit, bounds);
}

std::array<float, MeshTreeNode::kWidth> gapsAlong(const MeshTreeNode& node,
                                                  const PlacedBound& other,
                                                  const Eigen::Vector3f& direction) noexcept {
  std::array<float, MeshTreeNode::kWidth> gaps;
  HWY_DYNAMIC_DISPATCH(gapsOfChildren)(node, other, direction.data(), gaps.data());
  return gaps;
}

std::array<float, kDirections> gapsAlong(const Bound& child, const PlacedBound& other,
                                         const Directions& directions) noexcept {
  std::array<float, kDirections> gaps;
  HWY_DYNAMIC_DISPATCH(gapsAlongMany)(child, other, directions, gaps.data());
  return gaps;
}

}  // namespace collision_monitor
#endif
