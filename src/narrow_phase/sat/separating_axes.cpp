// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/sat/separating_axes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "narrow_phase/closed_form/core_distance.h"

namespace collision_monitor {
namespace {

constexpr double kNoAxis = -std::numeric_limits<double>::infinity();
// Sines this small are rounding of parallel edges. So thin a facet changes the depth by less.
constexpr double kLeastSineSquared = 1e-30;

void measureFacesOfA(const BoxPair& pair, Separations& separations) noexcept {
  const Eigen::Vector3d reach = pair.half_a + pair.a_from_b.cwiseAbs() * pair.half_b;
  const Eigen::Vector3d gap = pair.center_of_b.cwiseAbs() - reach;
  std::copy_n(gap.data(), 3, separations.along.begin());
}

void measureFacesOfB(const BoxPair& pair, Separations& separations) noexcept {
  const Eigen::Vector3d reach = pair.half_b + pair.a_from_b.cwiseAbs().transpose() * pair.half_a;
  const Eigen::Vector3d gap = (pair.a_from_b.transpose() * pair.center_of_b).cwiseAbs() - reach;
  std::copy_n(gap.data(), 3, separations.along.begin() + kFirstFaceOfB);
}

// Gap along e_i x f_j, whose components in A's frame are (0, -f_q, f_p) for i, p, q cyclic.
// `reach_b` is B's extent along that axis before it gets unit length.
double gapAlongEdges(const BoxPair& pair, Eigen::Index i, Eigen::Index j, double reach_b) noexcept {
  const Eigen::Index p = (i + 1) % 3;
  const Eigen::Index q = (i + 2) % 3;
  const double f_p = pair.a_from_b(p, j);
  const double f_q = pair.a_from_b(q, j);
  const double sine_squared = f_p * f_p + f_q * f_q;
  const double reach = pair.half_a[p] * std::abs(f_q) + pair.half_a[q] * std::abs(f_p) + reach_b;
  const double offset = std::abs(pair.center_of_b[q] * f_p - pair.center_of_b[p] * f_q);
  return sine_squared > kLeastSineSquared ? (offset - reach) / std::sqrt(sine_squared) : kNoAxis;
}

void measureEdges(const BoxPair& pair, Separations& separations) noexcept {
  const Eigen::Matrix3d& r = pair.a_from_b;
  const Eigen::Vector3d& half_b = pair.half_b;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const Eigen::Index p = (i + 1) % 3;
    const Eigen::Index q = (i + 2) % 3;
    // |e_i x f_j . f_m|, one minor for each pair of B's axes.
    const double minor_01 = std::abs(r(p, 0) * r(q, 1) - r(q, 0) * r(p, 1));
    const double minor_12 = std::abs(r(p, 1) * r(q, 2) - r(q, 1) * r(p, 2));
    const double minor_20 = std::abs(r(p, 2) * r(q, 0) - r(q, 2) * r(p, 0));
    const double reach_b[3] = {half_b[1] * minor_01 + half_b[2] * minor_20,
                               half_b[0] * minor_01 + half_b[2] * minor_12,
                               half_b[0] * minor_20 + half_b[1] * minor_12};
    for (Eigen::Index j = 0; j < 3; ++j) {
      separations.along[kFirstEdgePair + static_cast<std::size_t>(3 * i + j)] =
          gapAlongEdges(pair, i, j, reach_b[j]);
    }
  }
}

void findLargest(Separations& separations) noexcept {
  separations.largest = *std::max_element(separations.along.begin(), separations.along.end());
}

}  // namespace

Separations separationsOfBoxes(const BoxPair& pair) noexcept {
  Separations separations;
  measureFacesOfA(pair, separations);
  measureFacesOfB(pair, separations);
  measureEdges(pair, separations);
  findLargest(separations);
  return separations;
}

Separations separationsOfBoxAndSegment(const BoxPair& pair) noexcept {
  Separations separations;
  separations.along.fill(kNoAxis);
  measureFacesOfA(pair, separations);
  for (Eigen::Index i = 0; i < 3; ++i) {
    separations.along[kFirstEdgePair + static_cast<std::size_t>(3 * i + 2)] =
        gapAlongEdges(pair, i, 2, 0.0);
  }
  findLargest(separations);
  return separations;
}

Eigen::Vector3d axisDirection(const BoxPair& pair, std::size_t axis) noexcept {
  Eigen::Vector3d direction;
  const auto axis_index = static_cast<Eigen::Index>(axis);
  if (axis < kFirstFaceOfB) {
    direction = Eigen::Vector3d::Unit(axis_index);
  } else if (axis < kFirstEdgePair) {
    direction = pair.a_from_b.col(axis_index - 3);
  } else {
    const Eigen::Vector3d edge_of_a = Eigen::Vector3d::Unit((axis_index - 6) / 3);
    direction = edge_of_a.cross(pair.a_from_b.col((axis_index - 6) % 3)).normalized();
  }
  return signOf(direction.dot(pair.center_of_b)) * direction;
}

}  // namespace collision_monitor
