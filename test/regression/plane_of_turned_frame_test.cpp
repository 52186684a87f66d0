// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause

// A box of 4e9 m stands for a plane among enclosing shapes. The rotation of a link at the end of a
// chain is off by some units in the last place, which moved the face of the box by 4e-5 m away from
// the plane: distances to it were too large.
#include <gtest/gtest.h>

#include <memory>

#include "narrow_phase/distance.h"
#include "pipeline/world/prepare_object.h"

namespace collision_monitor::test {
namespace {

TEST(PlaneOfTurnedFrame, boxThatStandsForIt_isNotFarther) {
  WorldObject floor;
  floor.name = "floor";
  floor.shapes = std::make_shared<const ObjectShapes>(ObjectShapes{{Pose(), Plane()}});
  const Body body = prepareObject(floor, RefineGeometry::mesh)->bodies.front();
  for (const double error : {0.0, 2e-14, -2e-14}) {
    Pose world_from_floor;
    world_from_floor.rotation *= 1.0 + error;
    const SignedDistance found =
        distanceBetween(body.shape, world_from_floor * body.link_from_body, Shape(Sphere{0.1}),
                        {Eigen::Matrix3d::Identity(), Eigen::Vector3d(3.0, -2.0, 0.5)});
    EXPECT_LE(found.distance, 0.4) << error;
    EXPECT_GE(found.distance, 0.4 - 4e-4) << error;
  }
}

}  // namespace
}  // namespace collision_monitor::test
