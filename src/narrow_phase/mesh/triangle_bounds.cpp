// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "narrow_phase/mesh/triangle_bounds.cpp"
#include "hwy/foreach_target.h"
// The order matters: Highway first includes this file once for each target.
#include "narrow_phase/mesh/mesh_bounds-inl.h"

HWY_BEFORE_NAMESPACE();
namespace collision_monitor {
namespace HWY_NAMESPACE {

using Truth = hn::Mask<Some>;

constexpr float kTiny = 1e-30F;
// Slightly less than unit, so that no gap comes out too large.
constexpr float kAlmostUnit = 1.0F - 1e-6F;

// A segment of a triangle: an edge, or what leads from a corner to it.
struct Side {
  Vector along;
  Number per_square;  // 1 / |along|^2

  HWY_INLINE explicit Side(const Vector& vector)
      : along(vector),
        per_square(hn::Div(number(1.0F), hn::Add(dot(vector, vector), number(kTiny)))) {}
};

struct Corners {
  Vector at[3];
  Side ab, ac, bc;

  HWY_INLINE explicit Corners(const PlacedTriangle& triangle)
      : at{vector(triangle.corners[0].data()), vector(triangle.corners[1].data()),
           vector(triangle.corners[2].data())},
        ab(at[1] - at[0]),
        ac(at[2] - at[0]),
        bc(at[2] - at[1]) {}
};

// From the nearest point of an edge to a point; `from_start` leads from the edge's start to it.
HWY_INLINE Vector beyondEdge(const Side& edge, const Vector& from_start) {
  const Number share = hn::Mul(dot(from_start, edge.along), edge.per_square);
  const Number within = hn::Max(hn::Min(share, number(1.0F)), hn::Zero(Some()));
  return from_start - within * edge.along;
}

HWY_INLINE Vector select(Truth which, const Vector& yes, const Vector& no) {
  return {{hn::IfThenElse(which, yes.at[0], no.at[0]), hn::IfThenElse(which, yes.at[1], no.at[1]),
           hn::IfThenElse(which, yes.at[2], no.at[2])}};
}

HWY_INLINE Vector shorter(const Vector& a, const Vector& b) {
  return select(hn::Lt(dot(a, a), dot(b, b)), a, b);
}

// From about the nearest point of the triangle to a point. Any direction proves a gap; this one
// proves most.
HWY_INLINE Vector beyondTriangle(const Corners& corners, const Vector& point) {
  const Vector from_a = point - corners.at[0];
  const Vector edges =
      shorter(shorter(beyondEdge(corners.ab, from_a), beyondEdge(corners.ac, from_a)),
              beyondEdge(corners.bc, point - corners.at[1]));
  // Of the part of AC across AB.
  const Number bend = hn::Mul(dot(corners.ac.along, corners.ab.along), corners.ab.per_square);
  const Side across(corners.ac.along - bend * corners.ab.along);
  const Number to_c = hn::Mul(dot(from_a, across.along), across.per_square);
  const Number to_b =
      hn::Sub(hn::Mul(dot(from_a, corners.ab.along), corners.ab.per_square), hn::Mul(to_c, bend));
  const Number rest = hn::Sub(hn::Sub(number(1.0F), to_b), to_c);
  const Truth is_over_face = hn::Ge(hn::Min(hn::Min(to_b, to_c), rest), hn::Zero(Some()));
  return select(is_over_face, from_a - to_b * corners.ab.along - to_c * corners.ac.along, edges);
}

HWY_INLINE Shadow shadowOf(const Corners& corners, const Vector& u) {
  const Number a = dot(u, corners.at[0]);
  const Number b = dot(u, corners.at[1]);
  const Number c = dot(u, corners.at[2]);
  const Number low = hn::Min(hn::Min(a, b), c);
  const Number high = hn::Max(hn::Max(a, b), c);
  const Number half = number(0.5F);
  return {hn::Mul(half, hn::Add(low, high)), hn::Mul(half, hn::Sub(high, low))};
}

HWY_INLINE Number squaredGapOfBoxes(const Children& children, const Corners& corners,
                                    Number slack) {
  Number squared = hn::Zero(Some());
  for (std::size_t k = 0; k < 3; ++k) {
    const Number a = corners.at[0].at[k];
    const Number b = corners.at[1].at[k];
    const Number c = corners.at[2].at[k];
    const Number below = hn::Sub(hn::Min(hn::Min(a, b), c), children.center.at[k]);
    const Number above = hn::Sub(children.center.at[k], hn::Max(hn::Max(a, b), c));
    const Number apart = hn::Sub(hn::Sub(hn::Max(below, above), children.half.at[k]), slack);
    const Number gap = hn::Max(apart, hn::Zero(Some()));
    squared = hn::Add(squared, hn::Mul(gap, gap));
  }
  return squared;
}

std::uint32_t boundNodeAtTriangle(const MeshTreeNode& node, const PlacedTriangle& triangle,
                                  float limit, NodeBounds& bounds) {
  const Corners corners(triangle);
  std::uint32_t nearer = 0;
  for (std::size_t first = 0; first < MeshTreeNode::kWidth; first += hn::Lanes(Some())) {
    const Children children = childrenOf(node, first);
    const Vector beyond = beyondTriangle(corners, children.center);
    const Number length = hn::Sqrt(hn::Add(dot(beyond, beyond), number(kTiny)));
    const Vector u = hn::Div(number(kAlmostUnit), length) * beyond;
    const Number along_nearest =
        gapBetween(shadowOf(children, u, dot(u, children.normal)), shadowOf(corners, u));
    const Number along_children =
        gapBetween(shadowOf(corners, children.normal), {children.slab_center, children.slab_half});
    const Number slack = number(2.0F * triangle.slack);
    const Number widest = hn::Max(along_nearest, along_children);
    const Number gap = hn::Max(hn::Sub(widest, slack), hn::Zero(Some()));
    const Number squared = hn::Max(squaredGapOfBoxes(children, corners, slack), hn::Mul(gap, gap));
    nearer |= keepBounds(squared, along_nearest, limit, first, bounds);
  }
  return nearer;
}

// How far the triangle lies beyond the children along a unit vector.
HWY_INLINE Number gapAlong(const Children& children, const PlacedTriangle& triangle,
                           const Vector& u) {
  const auto height = [&](std::size_t i) { return dot(u, vector(triangle.corners[i].data())); };
  const Number start = hn::Min(hn::Min(height(0), height(1)), height(2));
  return hn::Sub(hn::Sub(start, endOf(children, u)), number(2.0F * triangle.slack));
}

void gapsOfChildrenAtTriangle(const MeshTreeNode& node, const PlacedTriangle& triangle,
                              const float* direction, float* gaps) {
  for (std::size_t first = 0; first < MeshTreeNode::kWidth; first += hn::Lanes(Some())) {
    hn::StoreU(gapAlong(childrenOf(node, first), triangle, vector(direction)), Some(),
               gaps + first);
  }
}

void gapsAlongManyAtTriangle(const Bound& child, const PlacedTriangle& triangle,
                             const Directions& directions, float* gaps) {
  for (std::size_t first = 0; first < kDirections; first += hn::Lanes(Some())) {
    hn::StoreU(gapAlong(everywhere(child), triangle, load(directions.at, first)), Some(),
               gaps + first);
  }
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace collision_monitor
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace collision_monitor {
namespace {

HWY_EXPORT(boundNodeAtTriangle);
HWY_EXPORT(gapsOfChildrenAtTriangle);
HWY_EXPORT(gapsAlongManyAtTriangle);

}  // namespace

PlacedTriangle place(const BoundPlacement& placement, const Eigen::Vector3d& center,
                     const Triangle& triangle) noexcept {
  PlacedTriangle placed;
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector3f corner = (triangle[i] - center).cast<float>();
    placed.corners[i] = placement.rotation * corner + placement.translation;
  }
  placed.slack = placement.slack;
  return placed;
}

std::uint32_t boundNearer(const MeshTreeNode& node, const PlacedTriangle& other, float limit,
                          NodeBounds& bounds) noexcept {
  return HWY_DYNAMIC_DISPATCH(boundNodeAtTriangle)(node, other, limit, bounds);
}

std::array<float, MeshTreeNode::kWidth> gapsAlong(const MeshTreeNode& node,
                                                  const PlacedTriangle& other,
                                                  const Eigen::Vector3f& direction) noexcept {
  std::array<float, MeshTreeNode::kWidth> gaps;
  HWY_DYNAMIC_DISPATCH(gapsOfChildrenAtTriangle)(node, other, direction.data(), gaps.data());
  return gaps;
}

std::array<float, kDirections> gapsAlong(const Bound& child, const PlacedTriangle& other,
                                         const Directions& directions) noexcept {
  std::array<float, kDirections> gaps;
  HWY_DYNAMIC_DISPATCH(gapsAlongManyAtTriangle)(child, other, directions, gaps.data());
  return gaps;
}

}  // namespace collision_monitor
#endif
