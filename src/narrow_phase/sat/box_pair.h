// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "collision_monitor/geometry/pose.h"

namespace collision_monitor {

/// Two boxes, or a box and a segment (a box of one extent). Frames: that of box A, whose center is
/// the origin. Column j of `a_from_b` is axis j of B. Units: metres.
struct BoxPair {
  Eigen::Matrix3d a_from_b;
  Eigen::Vector3d center_of_b;
  Eigen::Vector3d half_a;
  Eigen::Vector3d half_b;
};

inline BoxPair makeBoxPair(const Eigen::Vector3d& half_a, const Pose& world_from_a,
                           const Eigen::Vector3d& half_b, const Pose& world_from_b) noexcept {
  const Eigen::Matrix3d a_from_world = world_from_a.rotation.transpose();
  return {a_from_world * world_from_b.rotation,
          a_from_world * (world_from_b.translation - world_from_a.translation), half_a, half_b};
}

/// The same pair seen from B.
inline BoxPair swapped(const BoxPair& pair) noexcept {
  const Eigen::Matrix3d b_from_a = pair.a_from_b.transpose();
  return {b_from_a, -(b_from_a * pair.center_of_b), pair.half_b, pair.half_a};
}

inline Pose aFromB(const BoxPair& pair) noexcept { return {pair.a_from_b, pair.center_of_b}; }

/// [m] The sum of all lengths of the pair.
inline double lengthsOf(const BoxPair& pair) noexcept {
  return pair.half_a.sum() + pair.half_b.sum() + pair.center_of_b.cwiseAbs().sum();
}

/// [m] An upper bound of the rounding of any coordinate of the pair.
inline double toleranceOf(const BoxPair& pair) noexcept { return 4e-15 * lengthsOf(pair); }

}  // namespace collision_monitor
