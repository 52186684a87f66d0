// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <string>

#include "collision_monitor/pipeline/check_states.h"
#include "collision_monitor/pipeline/check_trajectory.h"
#include "pipeline/link_pair_distance.h"
#include "support/urdf_text.h"

// A contact_distance below 0 allows some depth: that of the geometries, which that of the shapes
// about them does not bound.
namespace collision_monitor::test {
namespace {

constexpr double kAllowed = 0.03;  // [m]

/// A double pyramid 0.8 m long in x and 0.3 m across, corners in y and z.
const char* const kSpindle =
    "v -0.4 0 0\nv 0.4 0 0\nv 0 0.15 0\nv 0 0 0.15\nv 0 -0.15 0\nv 0 0 -0.15\n"
    "f 1 4 3\nf 1 5 4\nf 1 6 5\nf 1 3 6\nf 2 3 4\nf 2 4 5\nf 2 5 6\nf 2 6 3\n";

/// Two bars 0.1 m thick, 0.3 m along x and along y from a corner at the origin.
const char* const kAngle =
    "v 0 0 -0.05\nv 0.3 0 -0.05\nv 0.3 0.1 -0.05\nv 0.1 0.1 -0.05\nv 0.1 0.3 -0.05\n"
    "v 0 0.3 -0.05\nv 0 0 0.05\nv 0.3 0 0.05\nv 0.3 0.1 0.05\nv 0.1 0.1 0.05\n"
    "v 0.1 0.3 0.05\nv 0 0.3 0.05\nf 6 5 4 3 2 1\nf 7 8 9 10 11 12\nf 1 2 8 7\nf 2 3 9 8\n"
    "f 3 4 10 9\nf 4 5 11 10\nf 5 6 12 11\nf 6 1 7 12\n";

std::string slider(const std::string& name, const std::string& link, const std::string& axis) {
  return jointXml(
      name, "prismatic", "rail", link,
      "<axis xyz='" + axis + "'/><limit lower='-9' upper='9' velocity='1' effort='1'/>");
}

/// A mesh at the origin, and a geometry that slides along x and z; the rail is far off.
class AllowedDepth : public testing::Test {
 protected:
  void build(const std::string& mesh, const std::string& geometry) {
    SetupOptions options;
    options.limits.contact_distance = -kAllowed;
    options.default_limits.target_overshoot = 0.002;
    options.ignore_default_overlap = false;
    const std::string far_off = "<origin xyz='0 0 -50'/>";
    setup_ = buildSetup(
        {describeText(robotXml(
            linkXml("rail", "<sphere radius='0.1'/>", far_off) + "<link name='carriage'/>" +
            linkXml("body", "<mesh filename='/body.obj'/>") + linkXml("ball", geometry) +
            slider("off", "body", "0 1 0") + slider("along", "carriage", "1 0 0") +
            jointXml("down", "prismatic", "carriage", "ball",
                     "<axis xyz='0 0 1'/><limit lower='-9' upper='9' velocity='1' effort='1'/>")))},
        textLoader({{"/body.obj", mesh}}), options);
    for (std::size_t i = 0; i < setup_.checked.size(); ++i) {
      if (setup_.model.link(setup_.checked[i].b).name == "ball") {
        pair_ = static_cast<LinkPairIndex>(i);
      }
    }
  }
  LinkPoses posesAt(double along, double down) const {
    LinkPoses poses = makeLinkPoses(setup_.model);
    placeLinks(setup_.model, {0.0, along, down}, {Pose()}, poses.world_from_link);
    std::fill(poses.status.begin(), poses.status.end(), LinkStatus::known);
    return poses;
  }
  double bodiesAt(double along, double down) const {
    LinkPairMeasures measures(setup_);
    return bodyDistance(measures, pair_, posesAt(along, down).world_from_link).measured.distance;
  }
  Verdict cycleAt(double along, double down) const {
    CycleBuffers buffers = makeBuffers(setup_, BroadPhaseKind::brute_force);
    runCycle(setup_, posesAt(along, down), buffers);
    return buffers.events.verdicts[pair_];
  }
  PairApproach go(double along, double from, double to) const {
    const JointPath path{{*setup_.model.findJoint("down")}, {0.0, 1.0}, {from, to}, {}};
    return checkTrajectory(setup_, path, posesAt(along, from), TrajectoryOptions()).pairs[pair_];
  }
  StateCheck stateAt(double along, double down, StateQuestion question, bool is_exact) const {
    StatesWork work = makeStatesWork(setup_, standingAt(setup_.model, {Pose()}));
    std::vector<StateCheck> checks;
    (is_exact ? checkStatesExactly : checkStates)(setup_, {0.0, along, down}, question, work,
                                                  checks);
    return checks.at(0);
  }

  CycleSetup setup_;
  LinkPairIndex pair_{0};
};

/// Where two of the shapes about the spindle meet, a small ball is deep in the spindle and in
/// neither of them.
class DeepInNoShape : public AllowedDepth {
 protected:
  DeepInNoShape() { build(kSpindle, "<sphere radius='0.01'/>"); }

  static constexpr double kSeam = 0.16;  // [m] along x
};

TEST_F(DeepInNoShape, scene_isOne) {
  EXPECT_GT(bodiesAt(kSeam, 0.0), -kAllowed);
  EXPECT_EQ(cycleAt(kSeam, 0.0), Verdict::contact);
}

TEST_F(DeepInNoShape, trajectory_isAContactWhereThatDeep) {
  const PairApproach found = go(kSeam, 0.5, -0.5);
  ASSERT_EQ(found.state, ApproachState::contact);
  EXPECT_NEAR(found.nearest.measured.distance, -kAllowed, 1.1e-6);
}

TEST_F(DeepInNoShape, trajectoryThatIsLessDeep_isClear) {
  const PairApproach found = go(kSeam, 0.5, 0.07);
  ASSERT_EQ(found.state, ApproachState::clear);
  EXPECT_LT(found.nearest.measured.distance, 0.0);
  EXPECT_GT(found.at_least, -kAllowed);
}

TEST_F(DeepInNoShape, states_areContacts) {
  for (const StateQuestion question : {StateQuestion::contact, StateQuestion::nearest}) {
    for (const bool is_exact : {false, true}) {
      EXPECT_EQ(stateAt(kSeam, 0.0, question, is_exact).verdict, Verdict::contact);
    }
  }
  EXPECT_EQ(stateAt(kSeam, 0.07, StateQuestion::contact, false).verdict, Verdict::contact);
  EXPECT_EQ(stateAt(kSeam, 0.07, StateQuestion::contact, true).verdict, Verdict::clear);
}

TEST_F(DeepInNoShape, betweenTwoCycles_isAContact) {
  CycleBuffers buffers = makeBuffers(setup_, BroadPhaseKind::brute_force);
  LinkPoses poses = posesAt(kSeam, 0.5);
  poses.stamp_ns = 1'000'000'000;
  runCycle(setup_, poses, buffers);
  poses.world_from_link = posesAt(kSeam, -0.5).world_from_link;
  poses.stamp_ns += 10'000'000;
  runCycle(setup_, poses, buffers);
  EXPECT_NE(buffers.events.passed[pair_], kNone);
  EXPECT_EQ(buffers.events.verdicts[pair_], Verdict::contact);
}

/// Concave meshes that overlap are in contact however deep, in every answer.
TEST_F(AllowedDepth, concaveMeshesThatOverlapLess_areInContact) {
  build(kAngle, "<mesh filename='/body.obj'/>");
  const double along = 0.28;
  ASSERT_GT(bodiesAt(along, 0.0), -kAllowed);
  EXPECT_EQ(cycleAt(along, 0.0), Verdict::contact);
  EXPECT_EQ(go(along, 0.5, 0.0).state, ApproachState::contact);
  EXPECT_EQ(stateAt(along, 0.0, StateQuestion::contact, true).verdict, Verdict::contact);
  EXPECT_EQ(stateAt(along, 0.0, StateQuestion::nearest, true).verdict, Verdict::contact);
}

}  // namespace
}  // namespace collision_monitor::test
