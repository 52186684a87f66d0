// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/lanes/lane_targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "geometry/meshes/surface_rim.cpp"
#include "hwy/foreach_target.h"
// The order matters: Highway first includes this file once for each target.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "collision_monitor/geometry/surface_rim.h"
#include "collision_monitor/geometry/winding.h"
#include "geometry/constants.h"
#include "geometry/lanes/lanes-inl.h"
#include "geometry/meshes/products-inl.h"

HWY_BEFORE_NAMESPACE();
namespace collision_monitor {
namespace HWY_NAMESPACE {

HWY_INLINE Vector3 broadcast(const Eigen::Vector3d& v) {
  return {number(v.x()), number(v.y()), number(v.z())};
}

HWY_INLINE Vector3 endAt(const SurfaceRim::Block& block, std::size_t column, std::size_t lane) {
  return {hn::Load(Lanes(), &block.columns[column][lane]),
          hn::Load(Lanes(), &block.columns[column + 1][lane]),
          hn::Load(Lanes(), &block.columns[column + 2][lane])};
}

HWY_INLINE Truth areEqual(const Vector3& a, const Vector3& b) {
  return hn::And(hn::And(hn::Eq(a.x, b.x), hn::Eq(a.y, b.y)), hn::Eq(a.z, b.z));
}

/// Multiplies by the walls' numbers. False if the point is in a wall, within rounding.
bool multiplyWalls(const SurfaceRim& rim, const Eigen::Vector3d& point,
                   const Eigen::Vector3d& direction, SolidAngles::Products& products) {
  constexpr double kDoubt = 1e-6;  // leaves nine digits of an angle
  const Vector3 from_point = broadcast(point);
  const Vector3 away = broadcast(direction);
  bool is_certain = true;
  for (std::size_t lane = 0; lane < SolidAngles::kLanes; lane += hn::Lanes(Lanes())) {
    ProductLanes product = productAt(lane, products);
    for (const SurfaceRim::Block& block : rim.blocks()) {
      const Vector3 start = endAt(block, 0, lane);
      const Vector3 end = endAt(block, 3, lane);
      const Truth is_missing = areEqual(start, end);
      const Vector3 a = start - from_point;
      const Vector3 b = end - from_point;
      const Number la = norm(a);
      const Number lb = norm(b);
      const Number both = hn::Mul(la, lb);
      const Number y = dot(away, cross(a, b));
      const Number x = hn::Add(hn::Add(both, dot(a, b)),
                               hn::Add(hn::Mul(dot(b, away), la), hn::Mul(dot(a, away), lb)));
      // In the wall y is 0 and x is not above 0.
      const Number doubt = hn::Mul(number(kDoubt), both);
      const Truth is_clear = hn::Or(hn::Gt(hn::Abs(y), doubt), hn::Gt(x, doubt));
      is_certain = is_certain && hn::AllTrue(Lanes(), hn::Or(is_clear, is_missing));
      multiply(hn::IfThenElse(is_missing, number(1.0), x), y, product);
    }
    store(product, lane, products);
  }
  return is_certain;
}

/// Sums length / r^2.
void sumRim(const SurfaceRim& rim, const Eigen::Vector3d& point, SurfaceRim::Sums& sums) {
  const Vector3 from_point = broadcast(point);
  for (std::size_t lane = 0; lane < SurfaceRim::kLanes; lane += hn::Lanes(Lanes())) {
    Number gradient = zero();
    Number nearest = number(kInfinity);
    for (const SurfaceRim::Block& block : rim.blocks()) {
      const Vector3 a = endAt(block, 0, lane) - from_point;
      const Vector3 side = endAt(block, 3, lane) - endAt(block, 0, lane);
      const Number squared_length = dot(side, side);
      const Truth counts = hn::Gt(squared_length, zero());
      const Number share = hn::Div(hn::Neg(dot(a, side)), squared_length);
      const Number within = hn::Max(zero(), hn::Min(number(1.0), share));
      const Vector3 foot = along(a, within, side);
      const Number squared = dot(foot, foot);
      const Number part = hn::Div(hn::Sqrt(squared_length), squared);
      gradient = hn::Add(gradient, hn::IfThenElseZero(counts, part));
      nearest = hn::Min(nearest, hn::IfThenElse(counts, squared, number(kInfinity)));
    }
    hn::Store(gradient, Lanes(), &sums.gradients[lane]);
    hn::Store(nearest, Lanes(), &sums.squared_nearest[lane]);
  }
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace collision_monitor
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace collision_monitor {
namespace {
HWY_EXPORT(multiplyWalls);
HWY_EXPORT(sumRim);
}  // namespace

void SurfaceRim::add(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const std::size_t lane = size_++ % kLanes;
  if (lane == 0) {
    blocks_.emplace_back();
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto k = static_cast<Eigen::Index>(axis);
    auto& columns = blocks_.back().columns;
    std::fill(columns[axis].begin() + lane, columns[axis].end(), from[k]);
    std::fill(columns[axis + 3].begin() + lane, columns[axis + 3].end(), from[k]);
    columns[axis + 3][lane] = to[k];
  }
}

RimWalls wallsSeenFrom(const Eigen::Vector3d& point, const Eigen::Vector3d& direction,
                       const SurfaceRim& rim) noexcept {
  SolidAngles::Products products;
  const bool is_certain = HWY_DYNAMIC_DISPATCH(multiplyWalls)(rim, point, direction, products);
  return {products.angle(), is_certain};
}

void RimAtPoint::add(double length, double distance) noexcept {
  gradient += length / (4.0 * kPi * distance * distance);
  nearest = std::min(nearest, distance);
}

RimAtPoint rimAt(const Eigen::Vector3d& point, const SurfaceRim& rim) noexcept {
  SurfaceRim::Sums sums;
  HWY_DYNAMIC_DISPATCH(sumRim)(rim, point, sums);
  RimAtPoint at;
  at.gradient = std::accumulate(sums.gradients.begin(), sums.gradients.end(), 0.0) / (4.0 * kPi);
  at.nearest =
      std::sqrt(*std::min_element(sums.squared_nearest.begin(), sums.squared_nearest.end()));
  return at;
}

}  // namespace collision_monitor
#endif
