// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/lanes/lane_targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "narrow_phase/triangle/edge_lanes.cpp"
#include "hwy/foreach_target.h"
// The order matters: Highway first includes this file once for each target.
#include <algorithm>
#include <limits>

#include "geometry/lanes/lanes-inl.h"
#include "narrow_phase/triangle/triangle_edges.h"

HWY_BEFORE_NAMESPACE();
namespace collision_monitor {
namespace HWY_NAMESPACE {

/// Edges in lanes.
struct LaneEdges {
  Vector3 start, along;
  Number squared_length;
};

/// The edges of a triangle in columns. The third one fills the remaining lanes.
struct EdgeColumns {
  static constexpr std::size_t kLanes = 8;

  HWY_ALIGN double numbers[7][kLanes];

  explicit EdgeColumns(const PreparedTriangle& triangle) noexcept {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const Edge& edge = triangle.edges[std::min<std::size_t>(lane, 2)];
      for (Eigen::Index k = 0; k < 3; ++k) {
        numbers[k][lane] = edge.start[k];
        numbers[3 + k][lane] = edge.along[k];
      }
      numbers[6][lane] = edge.squared_length;
    }
  }

  HWY_INLINE LaneEdges from(std::size_t first) const {
    const auto load = [&](std::size_t row) { return hn::Load(Lanes(), numbers[row] + first); };
    return {{load(0), load(1), load(2)}, {load(3), load(4), load(5)}, load(6)};
  }
};

HWY_INLINE Vector3 inAllLanes(const Eigen::Vector3d& v) {
  return {number(v.x()), number(v.y()), number(v.z())};
}

HWY_INLINE LaneEdges everywhere(const Edge& edge) {
  return {inAllLanes(edge.start), inAllLanes(edge.along), number(edge.squared_length)};
}

HWY_INLINE Number unitClamped(Number parameter) {
  return hn::Max(zero(), hn::Min(number(1.0), parameter));
}

// Both cases of improveByEdges. Values that a division by 0 spoils are not chosen.
HWY_INLINE Number squaredDistances(const LaneEdges& a, const LaneEdges& b) {
  const Vector3 from_a_to_b = b.start - a.start;
  const Vector3 normal = cross(a.along, b.along);
  const Number squared_normal = dot(normal, normal);
  const Number product = dot(a.along, b.along);
  const Number along_a = dot(from_a_to_b, a.along);
  const Truth a_is_long = hn::Gt(a.squared_length, zero());
  const Number first = hn::Div(along_a, a.squared_length);
  const Number last = hn::Add(first, hn::Div(product, a.squared_length));
  const Number level = hn::Mul(number(0.5), hn::Add(unitClamped(first), unitClamped(last)));
  const Number skew =
      unitClamped(hn::Div(dot(cross(from_a_to_b, b.along), normal), squared_normal));
  const Truth is_skew =
      hn::Gt(squared_normal,
             hn::Mul(hn::Mul(number(kParallelSquared), a.squared_length), b.squared_length));
  Number on_a = hn::IfThenElse(is_skew, skew, hn::IfThenElseZero(a_is_long, level));
  const Number along_b = hn::Sub(hn::Mul(on_a, product), dot(from_a_to_b, b.along));
  const Number on_b = hn::IfThenElseZero(hn::Gt(b.squared_length, zero()),
                                         unitClamped(hn::Div(along_b, b.squared_length)));
  on_a = hn::IfThenElseZero(
      a_is_long, unitClamped(hn::Div(hn::Add(hn::Mul(on_b, product), along_a), a.squared_length)));
  const Vector3 between = along(b.start, on_b, b.along) - along(a.start, on_a, a.along);
  return dot(between, between);
}

EdgePair nearestOfEdges(const PreparedTriangle& a, const PreparedTriangle& b) {
  const EdgeColumns of_b(b);
  EdgePair nearest{0, 0, std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < 3; ++i) {
    HWY_ALIGN double squared[EdgeColumns::kLanes];
    const LaneEdges of_a = everywhere(a.edges[i]);
    for (std::size_t first = 0; first < 3; first += hn::Lanes(Lanes())) {
      hn::Store(squaredDistances(of_a, of_b.from(first)), Lanes(), squared + first);
    }
    for (std::size_t j = 0; j < 3; ++j) {
      if (squared[j] < nearest.squared_distance) {
        nearest = {i, j, squared[j]};
      }
    }
  }
  return nearest;
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace collision_monitor
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace collision_monitor {
namespace {

HWY_EXPORT(nearestOfEdges);

}  // namespace

EdgePair nearestEdges(const PreparedTriangle& a, const PreparedTriangle& b) noexcept {
  return HWY_DYNAMIC_DISPATCH(nearestOfEdges)(a, b);
}

}  // namespace collision_monitor
#endif
