// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/reference/extended_distance.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace collision_monitor::test {

long double extendedDistance(const Shape& shape, const Pose& world_from_body,
                             const Eigen::Vector3d& point) {
  using Extended = Eigen::Matrix<long double, 3, 1>;
  using Matrix = Eigen::Matrix<long double, 3, 3>;
  const Matrix rotation = world_from_body.rotation.cast<long double>();
  const Extended offset =
      point.cast<long double>() - world_from_body.translation.cast<long double>();
  const Extended in_body = rotation.inverse() * offset;
  const Eigen::Vector3d half_extents = coreHalfExtents(shape);
  long double squared = 0.0L;
  long double deepest = -1e30L;
  for (Eigen::Index k = 0; k < 3; ++k) {
    const long double beyond = std::fabs(in_body[k]) - static_cast<long double>(half_extents[k]);
    squared += beyond > 0.0L ? beyond * beyond : 0.0L;
    deepest = std::max(deepest, beyond);
  }
  return (squared > 0.0L ? std::sqrt(squared) : deepest) -
         static_cast<long double>(radiusOf(shape));
}

}  // namespace collision_monitor::test
