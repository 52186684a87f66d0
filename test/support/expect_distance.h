// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "collision_monitor/geometry/pose.h"
#include "collision_monitor/geometry/shapes.h"
#include "collision_monitor/narrow_phase/signed_distance.h"
#include "support/pose_at.h"

namespace collision_monitor::test {

/// The accuracy that narrow_phase/distance.h promises for lengths up to 10 m.
constexpr double kExact = 1e-12;

/// The rotation with the given columns x and y; exact for entries 0, 1 and -1.
inline Eigen::Matrix3d axes(const Eigen::Vector3d& x, const Eigen::Vector3d& y) {
  Eigen::Matrix3d rotation;
  rotation << x, y, x.cross(y);
  return rotation;
}

/// Takes z to x: lays a capsule along x.
inline Eigen::Matrix3d zToX() { return axes(Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ()); }

/// Takes z to y.
inline Eigen::Matrix3d zToY() { return axes(Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitX()); }

/// An eighth turn about z.
inline Eigen::Matrix3d eighthTurn() {
  const double s = std::sqrt(0.5);
  return axes({s, s, 0.0}, {-s, s, 0.0});
}

inline void expectNear(const Eigen::Vector3d& found, const Eigen::Vector3d& expected,
                       const char* what) {
  EXPECT_LE((found - expected).norm(), kExact)
      << what << ": found " << found.transpose() << ", expected " << expected.transpose();
}

/// Checks what holds for all shapes: the normal is unit and joins the two points.
inline void expectConsistent(const SignedDistance& found) {
  EXPECT_NEAR(found.normal_a_to_b.norm(), 1.0, kExact);
  expectNear(found.point_on_b - found.point_on_a, found.distance * found.normal_a_to_b,
             "point_on_b - point_on_a against distance * normal");
}

inline void expectDistance(const SignedDistance& found, double distance,
                           const Eigen::Vector3d& normal, const Eigen::Vector3d& point_on_a) {
  EXPECT_NEAR(found.distance, distance, kExact);
  expectNear(found.normal_a_to_b, normal, "normal");
  expectNear(found.point_on_a, point_on_a, "point on a");
  expectConsistent(found);
}

}  // namespace collision_monitor::test
