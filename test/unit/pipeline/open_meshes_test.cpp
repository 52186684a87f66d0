// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/open_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "collision_monitor/pipeline/check_trajectory.h"
#include "collision_monitor/pipeline/search_pairs.h"
#include "pipeline/states_block.h"
#include "refine_scene.h"
#include "support/sample_meshes.h"
#include "support/urdf_text.h"

// What is inside a mesh that is not closed, in all that is asked of robots.
namespace collision_monitor::test::open_meshes {
namespace {

/// A torso of 0.6 m with four holes of one triangle: twelve edges are open.
TriangleMesh torso() {
  TriangleMesh mesh = sphereMesh(0.3, 24);
  for (const std::size_t hole : {700, 500, 300, 100}) {
    mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(hole));
  }
  return mesh;
}

/// Open above, 0.4 m wide.
TriangleMesh bin() {
  TriangleMesh mesh = boxMesh({0.2, 0.2, 0.2});
  TriangleMesh open{mesh.vertices, {}};
  for (const auto& t : mesh.triangles) {
    const double height =
        mesh.vertices[t[0]].z() + mesh.vertices[t[1]].z() + mesh.vertices[t[2]].z();
    if (height < 0.55) {
      open.triangles.push_back(t);
    }
  }
  return open;
}

/// A forearm that no convex geometry stands for.
TriangleMesh forearm() { return moved(scaled(angleMesh(), 0.2), {}, {-0.02, -0.02, 0}); }

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

TEST(OpenMeshes, torsoOfManyShapes_leavesNoHollowBetweenThem) {
  TriangleMesh open = boxMesh({0.3, 0.3, 0.3});
  open.triangles.pop_back();
  SetupOptions options = optionsFor(RefineGeometry::mesh);
  options.default_limits.max_shapes = 16;
  RefineScene scene({open, Sphere{0.02}}, options);
  ASSERT_GT(scene.setup.bodies.size(), 10U);
  for (const double x : {-0.2, 0.0, 0.1}) {
    for (const double y : {-0.15, 0.05, 0.2}) {
      for (const double z : {-0.2, -0.1, 0.0, 0.1}) {
        scene.poses.world_from_link[1].translation = {x, y, z};
        scene.run();
        EXPECT_EQ(scene.buffers.events.overall, Verdict::contact) << x << ' ' << y << ' ' << z;
      }
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

TEST(OpenMeshes, inAndOutBetweenTwoCycles_isAPassedContact) {
  for (const Geometry& geometry : {Geometry(forearm()), Geometry(Capsule{0.01, 0.01})}) {
    // 6 m wide: the sides are farther off than the arm comes.
    RefineScene scene({scaled(bin(), 15.0), geometry});
    scene.setup.is_continuous = true;
    scene.buffers = makeBuffers(scene.setup, BroadPhaseKind::brute_force);
    scene.poses.stamp_ns = 1'000'000'000;
    // On an arc of 2 m that dips 5 cm below the hole, from 4 cm above it and back.
    const Eigen::Vector3d axis(0.0, 0.0, 4.95);
    for (const double angle : {-0.3, 0.3}) {
      const Eigen::Matrix3d turn =
          Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitX()).toRotationMatrix();
      scene.poses.world_from_link[1] = {turn, axis + turn * Eigen::Vector3d(0, 0, -2.0)};
      scene.run();
      EXPECT_EQ(scene.buffers.distances.passed.empty(), angle < 0.0);
      scene.poses.stamp_ns += 20'000'000;
    }
    ASSERT_EQ(scene.buffers.distances.passed.size(), 1U) << geometry.index();
    EXPECT_GT(scene.buffers.distances.measured.at(0).measured.distance, 0.01) << "now apart again";
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

std::string objOf(const TriangleMesh& mesh) {
  std::ostringstream text;
  for (const Eigen::Vector3d& v : mesh.vertices) {
    text << "v " << v.x() << ' ' << v.y() << ' ' << v.z() << '\n';
  }
  for (const auto& t : mesh.triangles) {
    text << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
  }
  return text.str();
}

std::string slider(const std::string& link, const std::string& axis, const std::string& lower,
                   const std::string& upper) {
  return jointXml(link + "_joint", "prismatic", "rail", link,
                  "<axis xyz='" + axis + "'/><limit lower='" + lower + "' upper='" + upper +
                      "' velocity='1' effort='1'/>");
}

/// On a rail far below, a torso or a bin that stands still, and an arm that goes up and down.
CycleSetup robot(const TriangleMesh& around, const std::string& arm, const std::string& lower,
                 const std::string& upper, const std::string& height = "0") {
  SetupOptions options = optionsFor(RefineGeometry::mesh);
  options.ignore_default_overlap = false;
  return buildSetup(
      {describeText(robotXml(linkXml("rail", "<sphere radius='0.1'/>", "<origin xyz='0 0 -50'/>") +
                             linkXml("around", "<mesh filename='package://p/around.obj'/>") +
                             linkXml("arm", arm, "<origin xyz='0 0 " + height + "'/>") +
                             slider("around", "1 0 0", "-0.001", "0.001") +
                             slider("arm", "0 0 1", lower, upper)))},
      textLoader(
          {{"package://p/around.obj", objOf(around)}, {"package://p/arm.obj", objOf(forearm())}}),
      options);
}

const char* const kMeshArm = "<mesh filename='package://p/arm.obj'/>";
const char* const kCapsuleArm = "<capsule radius='0.03' length='0.04'/>";

LinkPairIndex armAndAround(const CycleSetup& setup) {
  for (LinkPairIndex i = 0; i < setup.checked.size(); ++i) {
    if (setup.model.link(setup.checked[i].a).name != "rail" &&
        setup.model.link(setup.checked[i].b).name != "rail") {
      return i;
    }
  }
  throw std::out_of_range("no such pair");
}

class OpenMeshesOfRobots : public testing::TestWithParam<const char*> {};

TEST_P(OpenMeshesOfRobots, states_areInContactWhereTheArmIsInside) {
  const CycleSetup setup = robot(torso(), GetParam(), "-2", "2");
  StatesWork work = makeStatesWork(setup, standingAt(setup.model, {Pose()}));
  std::vector<StateCheck> checks;
  const JointPositions positions = {0, 0, 0, 0.1, 0, -0.2, 0, 0.5, 0, 1.0};
  for (const StateQuestion question : {StateQuestion::nearest, StateQuestion::contact}) {
    checkStatesExactly(setup, positions, question, work, checks);
    ASSERT_EQ(checks.size(), 5U);
    for (std::size_t i = 0; i < 5; ++i) {
      EXPECT_EQ(checks[i].verdict, i < 3 ? Verdict::contact : Verdict::clear) << i;
    }
  }
  checkStatesExactly(setup, {0, 0}, StateQuestion::contact, work, checks);
  EXPECT_EQ(checks[0].verdict, Verdict::contact) << "a state by itself";
}

TEST_P(OpenMeshesOfRobots, trajectoryThroughAHole_isInContact) {
  const CycleSetup setup = robot(bin(), GetParam(), "-2", "2");
  const LinkPairIndex pair = armAndAround(setup);
  JointPath path;
  path.joints = {*setup.model.findJoint("arm_joint")};
  LinkPoses start = makeLinkPoses(setup.model);
  placeLinks(setup.model, JointPositions(setup.model.variable_count, 0.0), {Pose()},
             start.world_from_link);
  std::fill(start.status.begin(), start.status.end(), LinkStatus::known);
  path.times = {0.0, 1.0};
  path.positions = {0.5, 0.0};
  const TrajectoryReport down = checkTrajectory(setup, path, start, TrajectoryOptions());
  ASSERT_EQ(down.pairs[pair].state, ApproachState::contact);
  EXPECT_NEAR(0.5 - 0.5 * down.pairs[pair].time, 0.2, 0.06) << "the height of the hole";
  path.positions = {0.5, 0.3};
  EXPECT_EQ(checkTrajectory(setup, path, start, TrajectoryOptions()).pairs[pair].state,
            ApproachState::clear);
  path.positions = {0.01, -0.01};
  EXPECT_EQ(checkTrajectory(setup, path, start, TrajectoryOptions()).pairs[pair].state,
            ApproachState::contact)
      << "wholly inside";
}

TEST_P(OpenMeshesOfRobots, pairs_touchAlwaysSometimesAndNever) {
  PairSearchOptions options;
  options.states = 100;
  const auto finding = [&](const CycleSetup& setup) {
    for (const PairFound& pair : searchPairs(setup, options)) {
      if (setup.model.link(pair.a).name == "around" || setup.model.link(pair.a).name == "arm") {
        return pair;
      }
    }
    throw std::out_of_range("no such pair");
  };
  EXPECT_EQ(finding(robot(torso(), GetParam(), "-0.1", "0.1")).finding, PairFinding::always);
  EXPECT_EQ(finding(robot(bin(), GetParam(), "0", "0.5")).finding, PairFinding::sometimes);
  const PairFound never = finding(robot(bin(), GetParam(), "0.3", "0.5"));
  EXPECT_EQ(never.finding, PairFinding::never);
  EXPECT_TRUE(never.is_proven);
  // The only state that is drawn is far above the hole: the search for a proof comes upon it.
  options.states = 1;
  EXPECT_EQ(finding(robot(bin(), GetParam(), "-0.4", "0", "0.5")).finding, PairFinding::sometimes);
}

INSTANTIATE_TEST_SUITE_P(Arms, OpenMeshesOfRobots, testing::Values(kMeshArm, kCapsuleArm));

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
}

TEST(OpenMeshes, closedMeshWithTurnedTriangles_isClosedAgain) {
  TriangleMesh mesh = angleMesh();
  std::swap(mesh.triangles[4][0], mesh.triangles[4][1]);
  EXPECT_TRUE(treeOfOpen(mesh).isClosed());
  EXPECT_FALSE(treeOfOpen(torso()).isClosed());
}

}  // namespace
}  // namespace collision_monitor::test::open_meshes
