// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/lanes/lane_targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "geometry/meshes/solid_angles.cpp"
#include "hwy/foreach_target.h"
// The order matters: Highway first includes this file once for each target.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "collision_monitor/geometry/winding.h"
#include "geometry/constants.h"
#include "geometry/lanes/lanes-inl.h"
#include "geometry/meshes/products-inl.h"

HWY_BEFORE_NAMESPACE();
namespace collision_monitor {
namespace HWY_NAMESPACE {

void multiplyTriangles(const SolidAngles::Batch& batch, SolidAngles::Products& products) {
  for (std::size_t lane = 0; lane < SolidAngles::kLanes; lane += hn::Lanes(Lanes())) {
    ProductLanes product = productAt(lane, products);
    for (std::size_t row = lane; row < batch.count; row += SolidAngles::kLanes) {
      const auto cornerAt = [&](std::size_t column) HWY_ATTR {
        return Vector3{hn::Load(Lanes(), &batch.columns[column][row]),
                       hn::Load(Lanes(), &batch.columns[column + 1][row]),
                       hn::Load(Lanes(), &batch.columns[column + 2][row])};
      };
      const Vector3 a = cornerAt(0);
      const Vector3 b = cornerAt(3);
      const Vector3 c = cornerAt(6);
      const Number la = norm(a);
      const Number lb = norm(b);
      const Number lc = norm(c);
      const Number y = dot(a, cross(b, c));
      const Number x =
          hn::Add(hn::Add(hn::Add(hn::Mul(hn::Mul(la, lb), lc), hn::Mul(dot(a, b), lc)),
                          hn::Mul(dot(b, c), la)),
                  hn::Mul(dot(c, a), lb));
      multiply(x, y, product);
    }
    store(product, lane, products);
  }
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace collision_monitor
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace collision_monitor {
namespace {
HWY_EXPORT(multiplyTriangles);
HWY_EXPORT(joinProducts);
}  // namespace

double SolidAngles::Products::angle() const noexcept {
  Products joined = *this;
  HWY_DYNAMIC_DISPATCH(joinProducts)(joined);
  const double whole = std::accumulate(joined.turns.begin(), joined.turns.end(), 0.0);
  return 2.0 * std::atan2(joined.imaginary[0], joined.real[0]) + 4.0 * kPi * whole;
}

SolidAngles::SolidAngles(const Eigen::Vector3d& point) noexcept : point_(point) {}

void SolidAngles::add(const Triangle& triangle) noexcept {
  std::size_t column = 0;
  for (const Eigen::Vector3d& corner : triangle) {
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      batch_.columns[column++][batch_.count] = corner[axis] - point_[axis];
    }
  }
  if (++batch_.count == Batch::kMost) {
    multiplyBatch();
  }
}

/// Triangles of size 0 fill the last lanes. They count for nothing.
void SolidAngles::multiplyBatch() noexcept {
  while (batch_.count % kLanes != 0) {
    for (auto& column : batch_.columns) {
      column[batch_.count] = 0.0;
    }
    ++batch_.count;
  }
  HWY_DYNAMIC_DISPATCH(multiplyTriangles)(batch_, products_);
  batch_.count = 0;
}

double SolidAngles::sum() noexcept {
  multiplyBatch();
  return products_.angle();
}

}  // namespace collision_monitor
#endif
