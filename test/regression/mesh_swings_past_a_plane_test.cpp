// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause

// A plane has no mesh. The sweep of a mesh that is not convex asked it for one, and the monitor of
// a robot that moves near its floor ended with a segmentation fault.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "model/object_links.h"
#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/cycle/run_cycle.h"
#include "pipeline/objects/carry_objects.h"
#include "pipeline/world/add_world.h"
#include "support/robots/geometry_setup.h"
#include "support/robots/hand_made_setup.h"
#include "support/robots/world_objects.h"

namespace collision_monitor::test {
namespace {

/// A floor below an angle of two bars, 0.3 m long.
CycleSetup angleOverFloor() {
  CycleSetup robots = geometrySetup({angleMesh()}, {});
  Link& link = robots.model.links.front();
  link.name = link.frame = "angle";
  link.has_given_shapes = true;
  robots.is_continuous = true;
  KnownPlaces places;
  places.world_frame = "map";
  const World world = worldOf({objectOf("floor", Plane(), Pose())}, places);
  return addWorld(robots, world, prepareObjects(world, RefineGeometry::mesh, {}), "map");
}

/// The verdict after the bar along x has swung past the vertical, from 45 degrees before it to 45
/// degrees behind it.
Verdict swingAt(double height) {
  const CycleSetup setup = angleOverFloor();
  const std::vector<ObjectRun> objects = objectRuns(setup.model);
  CycleBuffers buffers = makeBuffers(setup, BroadPhaseKind::automatic);
  LinkPoses poses = knownPoses(setup);
  for (const double degrees : {45.0, 135.0}) {
    poses.stamp_ns += 20'000'000;
    const Eigen::AngleAxisd turn(degrees * std::acos(-1.0) / 180.0, Eigen::Vector3d::UnitY());
    poses.world_from_link[0] = {turn.toRotationMatrix(), Eigen::Vector3d(0.0, 0.0, height)};
    carryPoses(setup.model, objects, poses);
    runCycle(setup, poses, buffers);
    if (degrees < 90.0) {
      EXPECT_NE(buffers.events.overall, Verdict::contact);
    }
  }
  return buffers.events.overall;
}

TEST(MeshSwingsPastAPlane, reachesItBetweenTwoCycles_contact) {
  EXPECT_EQ(swingAt(0.26), Verdict::contact);
}

TEST(MeshSwingsPastAPlane, staysAboveIt_noContact) { EXPECT_NE(swingAt(0.31), Verdict::contact); }

}  // namespace
}  // namespace collision_monitor::test
