// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>

#include "exercise.h"
#include "support/fixed_seed.h"

namespace collision_monitor::two_capsules {
namespace {

using Eigen::Vector3d;

/// Half of the coordinates are whole, so that ends coincide and axes are straight up and down, some
/// but for a hair.
double anyCoordinate() {
  const double whole = *rc::gen::inRange(-1, 2);
  return whole + *rc::gen::element(0.0, 0.0, 1e-9, 1e-170, 1e-6 * *rc::gen::inRange(0, 1000000));
}

Vector3d anyPoint() { return {anyCoordinate(), anyCoordinate(), anyCoordinate()}; }

RC_GTEST_PROP(ExerciseLaws, clickedEnds_areTheEndsOfTheCapsule, ()) {
  const Points clicks{anyPoint(), anyPoint(), anyPoint()};
  const double radius = (clicks[1] - clicks[0]).norm();
  RC_PRE(radius >= 0.001);
  Exercise exercise;
  for (const Vector3d& click : clicks) {
    takeClick(click, exercise);
  }
  const std::vector<PosedShape> capsules = capsulesOf(exercise);
  RC_ASSERT(capsules.size() == 1);
  const Pose& pose = capsules[0].geometry_from_body;
  const auto& capsule = std::get<Capsule>(capsules[0].shape);
  RC_ASSERT(isRigid(pose, 1e-12));
  RC_ASSERT(capsule.radius == radius);
  RC_ASSERT((pose * Vector3d(0.0, 0.0, -capsule.half_length) - clicks[0]).norm() <= 1e-12);
  RC_ASSERT((pose * Vector3d(0.0, 0.0, capsule.half_length) - clicks[2]).norm() <= 1e-12);
}

}  // namespace
}  // namespace collision_monitor::two_capsules
