// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <random>

#include "collision_monitor/geometry/pose.h"

namespace collision_monitor::test {

using Random = std::mt19937_64;

inline double uniform(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

/// Uniform in the cube of half edge `reach` [m].
inline Eigen::Vector3d randomPoint(Random& random, double reach) {
  const double x = uniform(random, -reach, reach);
  const double y = uniform(random, -reach, reach);
  return {x, y, uniform(random, -reach, reach)};
}

/// Uniform over all rotations; Shoemake, "Uniform random rotations", Graphics Gems III (1992).
inline Eigen::Matrix3d randomRotation(Random& random) {
  constexpr double kTwoPi = 6.283185307179586;
  const double u = uniform(random, 0.0, 1.0);
  const double alpha = uniform(random, 0.0, kTwoPi);
  const double beta = uniform(random, 0.0, kTwoPi);
  const double s = std::sqrt(1.0 - u);
  const double c = std::sqrt(u);
  return Eigen::Quaterniond(c * std::cos(beta), s * std::sin(alpha), s * std::cos(alpha),
                            c * std::sin(beta))
      .normalized()
      .toRotationMatrix();
}

inline Pose randomPose(Random& random, double reach) {
  const Eigen::Matrix3d rotation = randomRotation(random);
  return {rotation, randomPoint(random, reach)};
}

}  // namespace collision_monitor::test
