// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/fits/open_meshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "support/sample_meshes.h"
#include "unit/pipeline/refine/refine_scene.h"
#include "unit/pipeline/setup/open_torso.h"

// What is inside a mesh that is not closed, from cycle to cycle.
namespace collision_monitor::test::open_meshes {
namespace {

std::vector<Geometry> forearms() {
  return {forearm(),           boxMesh({0.05, 0.03, 0.03}), Sphere{0.05},
          Capsule{0.05, 0.03}, Box{{0.05, 0.03, 0.03}},     Cylinder{0.05, 0.03}};
}

TEST(OpenMeshes, forearmInATorso_isInContact) {
  for (const Geometry& geometry : forearms()) {
    for (const double x : {0.0, 0.1, -0.15}) {
      RefineScene scene({torso(), geometry});
      scene.moveTo(1, x);
      scene.run();
      EXPECT_EQ(scene.verdict(), Verdict::contact) << geometry.index() << " at " << x;
      EXPECT_EQ(scene.closest().quality, Quality::estimate);
      EXPECT_LE(scene.closest().measured.distance, 0.0);
      EXPECT_GT(scene.closest().measured.distance, -0.5) << "out at the nearest side";
    }
  }
}

TEST(OpenMeshes, forearmBesideATorso_isMeasuredAsBefore) {
  for (const Geometry& geometry : forearms()) {
    RefineScene scene({torso(), geometry});
    scene.moveTo(1, 0.36);
    scene.run();
    EXPECT_GE(scene.closest().measured.distance, -1e-3);
    if (scene.closest().measured.distance > 0.0) {
      EXPECT_NE(scene.verdict(), Verdict::contact);
    }
    scene.moveTo(1, 0.5);
    scene.run();
    EXPECT_EQ(scene.verdict(), Verdict::clear);
  }
}

/// Down into a bin and out again, a millimetre at a time, within reach of no side.
TEST(OpenMeshes, goingThroughAHole_isContactFromThereOn) {
  for (const Geometry& geometry : {Geometry(forearm()), Geometry(Capsule{0.02, 0.03})}) {
    RefineScene scene({bin(), geometry});
    for (int step = -400; step <= 400; ++step) {
      const double height = 1e-3 * std::abs(step);
      scene.poses.world_from_link[1].translation.z() = height;
      scene.run();
      if (height < 0.15) {
        ASSERT_EQ(scene.verdict(), Verdict::contact) << geometry.index() << " at " << height;
      } else if (height > 0.27) {
        ASSERT_NE(scene.verdict(), Verdict::contact) << geometry.index() << " at " << height;
      }
    }
  }
}

TEST(OpenMeshes, oneLongStepIntoABin_isSeenInThatCycle) {
  for (const Geometry& geometry : {Geometry(forearm()), Geometry(Capsule{0.02, 0.03})}) {
    RefineScene scene({bin(), geometry});
    scene.poses.world_from_link[1].translation.z() = 0.3;
    scene.run();
    EXPECT_NE(scene.verdict(), Verdict::contact);
    scene.poses.world_from_link[1].translation.z() = 0.1;
    scene.run();
    EXPECT_EQ(scene.verdict(), Verdict::contact);
  }
}

TEST(OpenMeshes, besideAroundAndAboveSheetsAndBins_isNoContact) {
  TriangleMesh sheet = boxMesh({0.2, 0.2, 0.2});
  sheet.triangles.resize(2);
  const double side = sheet.vertices[sheet.triangles[0][0]].x();
  RefineScene scene({sheet, forearm(), Capsule{0.02, 0.03}});
  for (const double away : {0.12, 0.2}) {
    scene.moveTo(1, side - away);
    scene.moveTo(2, side + away);
    scene.run();
    EXPECT_NE(scene.buffers.events.overall, Verdict::contact) << away;
  }
}

TEST(OpenMeshes, meshTooOpen_isNamedInOneWarning) {
  const RefineScene closed({boxMesh({1, 1, 1}), torso()});
  EXPECT_TRUE(closed.setup.report.warnings.empty());
  const RefineScene open({bin(), torso(), bin()});
  ASSERT_EQ(open.setup.report.warnings.size(), 1U);
  const std::string& found = open.setup.report.warnings[0].found;
  EXPECT_NE(found.find("link_0 (collision_0: 0."), std::string::npos) << found;
  EXPECT_EQ(found.find("link_1"), std::string::npos) << found;
  EXPECT_NE(found.find("link_2"), std::string::npos) << found;
  const auto warning = warnOfOpenMeshes(open.setup.model);
  ASSERT_TRUE(warning);
  EXPECT_EQ(warning->found, found);
  const std::string text = toString(*warning);
  EXPECT_EQ(text.find("meshes: too open to tell well what is inside ("), 0U) << text;
  EXPECT_EQ(text.find("accepted"), std::string::npos) << text;
}

TEST(OpenMeshes, closedMeshWithTurnedTriangles_isClosedAgain) {
  TriangleMesh mesh = angleMesh();
  std::swap(mesh.triangles[4][0], mesh.triangles[4][1]);
  EXPECT_TRUE(treeOfOpen(mesh).isClosed());
  EXPECT_FALSE(treeOfOpen(torso()).isClosed());
}

}  // namespace
}  // namespace collision_monitor::test::open_meshes
