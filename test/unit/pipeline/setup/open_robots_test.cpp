// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <string>

#include "collision_monitor/pipeline/search_pairs.h"
#include "open_torso.h"
#include "pipeline/states/states_block.h"
#include "pipeline/trajectory/check_trajectory.h"
#include "support/robots/urdf_text.h"
#include "support/sample_meshes.h"
#include "unit/pipeline/refine/refine_scene.h"

// What is inside a mesh that is not closed, in all that is asked of robots.
namespace collision_monitor::test::open_meshes {
namespace {

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

/// An arm that goes up and down, from a height on.
std::string lift(const std::string& arm, const std::string& lower, const std::string& upper,
                 const std::string& height = "0") {
  return linkXml("arm", arm, "<origin xyz='0 0 " + height + "'/>") +
         slider("arm", "0 0 1", lower, upper);
}

/// On a rail far below, a torso or a bin that stands still, and an arm.
CycleSetup robot(const TriangleMesh& around, const std::string& arm) {
  SetupOptions options = optionsFor(RefineGeometry::mesh);
  options.ignore_default_overlap = false;
  return buildSetup(
      {describeText(robotXml(linkXml("rail", "<sphere radius='0.1'/>", "<origin xyz='0 0 -50'/>") +
                             linkXml("around", "<mesh filename='package://p/around.obj'/>") +
                             slider("around", "1 0 0", "-0.001", "0.001") + arm))},
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
  const CycleSetup setup = robot(torso(), lift(GetParam(), "-2", "2"));
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

/// How the arm comes near on its way between two positions; other joints stand at 0.
PairApproach along(const CycleSetup& setup, const std::vector<double>& positions) {
  JointPath path;
  path.joints = {*setup.model.findJoint("arm_joint")};
  path.times = {0.0, 1.0};
  path.positions = positions;
  LinkPoses start = makeLinkPoses(setup.model);
  placeLinks(setup.model, JointPositions(setup.model.variable_count, 0.0), {Pose()},
             start.world_from_link);
  std::fill(start.status.begin(), start.status.end(), LinkStatus::known);
  return checkTrajectory(setup, path, start, TrajectoryOptions()).pairs[armAndAround(setup)];
}

TEST_P(OpenMeshesOfRobots, trajectoryThroughAHole_isInContact) {
  const CycleSetup setup = robot(bin(), lift(GetParam(), "-2", "2"));
  const PairApproach down = along(setup, {0.5, 0.0});
  ASSERT_EQ(down.state, ApproachState::contact);
  EXPECT_NEAR(0.5 - 0.5 * down.time, 0.2, 0.06) << "the height of the hole";
  EXPECT_EQ(along(setup, {0.5, 0.3}).state, ApproachState::clear);
  EXPECT_EQ(along(setup, {0.01, -0.01}).state, ApproachState::contact) << "wholly inside";
}

TEST_P(OpenMeshesOfRobots, trajectoryThatDipsIntoAHole_isInContact) {
  // The bin is 6 m wide, and the arm swings 2 m below an axis: from 4 cm above the hole to 5 cm
  // below it and back, and nowhere near a side.
  const auto swing = [&](const std::string& height) {
    return linkXml("arm", GetParam(), "<origin xyz='0 0 -2'/>") +
           jointXml("arm_joint", "revolute", "rail", "arm",
                    "<origin xyz='0 0 " + height +
                        "'/><axis xyz='1 0 0'/>"
                        "<limit lower='-1' upper='1' velocity='1' effort='1'/>");
  };
  const TriangleMesh wide = scaled(bin(), 15.0);
  EXPECT_EQ(along(robot(wide, swing("4.95")), {-0.31, 0.29}).state, ApproachState::contact);
  EXPECT_EQ(along(robot(wide, swing("5.1")), {-0.31, 0.29}).state, ApproachState::clear);
}

/// A channel along x, 2 m long and 0.2 m wide, open above and at both ends.
TriangleMesh channel() {
  TriangleMesh mesh;
  for (const double x : {-1.0, 1.0}) {
    for (const auto& [y, z] : {std::pair(-0.1, 0.1), {-0.1, -0.1}, {0.1, -0.1}, {0.1, 0.1}}) {
      mesh.vertices.emplace_back(x, y, z);
    }
  }
  for (std::uint32_t i = 0; i < 3; ++i) {
    mesh.triangles.push_back({i, i + 1, i + 5});
    mesh.triangles.push_back({i, i + 5, i + 4});
  }
  return mesh;
}

/// Its corners are outside all the way, and it stays 0.08 m from the sides.
TEST(OpenMeshes, barLongerThanAChannel_isInContactInside) {
  for (const char* bar : {"<box size='3 0.04 0.04'/>", "<capsule radius='0.02' length='3'/>",
                          "<cylinder radius='0.02' length='3'/>"}) {
    const bool is_along_x = bar[1] == 'b';
    const std::string arm =
        linkXml("arm", bar,
                is_along_x ? "<origin xyz='0 0 0'/>" : "<origin rpy='0 1.5707963267948966 0'/>") +
        slider("arm", "0 0 1", "-2", "2");
    const CycleSetup setup = robot(channel(), arm);
    EXPECT_EQ(along(setup, {0.4, 0.0}).state, ApproachState::contact) << bar;
    EXPECT_EQ(along(setup, {0.4, 0.2}).state, ApproachState::clear) << bar;
  }
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
  EXPECT_EQ(finding(robot(torso(), lift(GetParam(), "-0.1", "0.1"))).finding, PairFinding::always);
  EXPECT_EQ(finding(robot(bin(), lift(GetParam(), "0", "0.5"))).finding, PairFinding::sometimes);
  const PairFound never = finding(robot(bin(), lift(GetParam(), "0.3", "0.5")));
  EXPECT_EQ(never.finding, PairFinding::never);
  EXPECT_TRUE(never.is_proven);
  // The only state that is drawn is far above the hole: the search for a proof comes upon it.
  options.states = 1;
  EXPECT_EQ(finding(robot(bin(), lift(GetParam(), "-0.4", "0", "0.5"))).finding,
            PairFinding::sometimes);
  // Nowhere on its way is the arm near a side of this bin.
  EXPECT_EQ(finding(robot(scaled(bin(), 15.0), lift(GetParam(), "-0.6", "0", "3.5"))).finding,
            PairFinding::sometimes);
}

INSTANTIATE_TEST_SUITE_P(Arms, OpenMeshesOfRobots, testing::Values(kMeshArm, kCapsuleArm));

}  // namespace
}  // namespace collision_monitor::test::open_meshes
