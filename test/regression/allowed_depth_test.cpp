// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause

// Users that allow some depth saw deep geometries called clear, and concave ones pass unseen.
// Only shapes deeper than that were refined, but the depth of shapes does not bound that of these.
// Now geometries are asked wherever shapes overlap, and concave ones touch however deep they are.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "collision_monitor/geometry/ids.h"
#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/cycle/run_cycle.h"
#include "pipeline/states/check_states.h"
#include "pipeline/trajectory/check_trajectory.h"
#include "pipeline/trajectory/link_pair_distance.h"
#include "support/robots/urdf_text.h"

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

/// An arrow head 40 mm thick, its tip 0.3 m along x; as wide as a third of the way from the tip.
const char* const kArrow =
    "v 0.3 -0.02 0\nv 0 -0.02 0.1\nv 0.05 -0.02 0\nv 0 -0.02 -0.1\nv 0.3 0.02 0\nv 0 0.02 0.1\n"
    "v 0.05 0.02 0\nv 0 0.02 -0.1\nf 1 2 3\nf 1 3 4\nf 5 7 6\nf 5 8 7\nf 1 5 6 2\nf 2 6 7 3\n"
    "f 3 7 8 4\nf 4 8 5 1\n";

std::string slideAlong(const std::string& name, const std::string& parent, const std::string& child,
                       const std::string& axis) {
  return jointXml(
      name, "prismatic", parent, child,
      "<axis xyz='" + axis + "'/><limit lower='-9' upper='9' velocity='1' effort='1'/>");
}

std::string collision(const std::string& geometry, const std::string& origin = "") {
  return "<collision><origin " + origin + "/><geometry>" + geometry + "</geometry></collision>";
}

std::string ballAt(double radius, const std::string& xyz) {
  return collision("<sphere radius='" + std::to_string(radius) + "'/>", "xyz='" + xyz + "'");
}

const std::string kSmallBall = ballAt(0.01, "0 0 0");

std::string meshXml(const std::string& more = "") {
  return "<mesh filename='/m.obj'" + more + "/>";
}

/// A body at the origin, and a ball, or what takes its place, that slides along x and z; the rail
/// is far off.
class AllowedDepth : public testing::Test {
 protected:
  /// @param mesh what meshXml means
  void build(const std::string& mesh, const std::string& of_body, const std::string& of_ball) {
    options_.limits.contact_distance = -kAllowed;
    options_.default_limits.target_overshoot = 0.002;
    options_.ignore_default_overlap = false;
    const auto link = [](const std::string& name, const std::string& collisions) {
      return "<link name='" + name + "'>" + collisions + "</link>";
    };
    setup_ = buildSetup(
        {describeText(robotXml(link("rail", ballAt(0.1, "0 0 -50")) +
                               link("carriage", of_carriage_) + link("body", of_body) +
                               link("ball", of_ball) + slideAlong("off", "rail", "body", "0 1 0") +
                               slideAlong("along", "rail", "carriage", "1 0 0") +
                               slideAlong("down", "carriage", "ball", "0 0 1")))},
        textLoader({{"/m.obj", mesh}}), options_);
    for (std::size_t i = 0; i < setup_.checked.size(); ++i) {
      const auto& model = setup_.model;
      if (model.link(setup_.checked[i].a).name == "body" &&
          model.link(setup_.checked[i].b).name == "ball") {
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

  /// Of a cycle after one elsewhere.
  bool hasPassed(const LinkPoses& from, const LinkPoses& to,
                 BroadPhaseKind kind = BroadPhaseKind::brute_force) const {
    CycleBuffers buffers = makeBuffers(setup_, kind);
    LinkPoses poses = from;
    poses.stamp_ns = 1'000'000'000;
    std::fill(poses.velocities.known.begin(), poses.velocities.known.end(), 1);  // now at rest
    runCycle(setup_, poses, buffers);
    EXPECT_NE(buffers.events.verdicts[pair_], Verdict::contact);
    poses.world_from_link = to.world_from_link;
    poses.stamp_ns += 10'000'000;
    runCycle(setup_, poses, buffers);
    return buffers.events.passed[pair_] != kNone &&
           buffers.events.verdicts[pair_] == Verdict::contact;
  }

  SetupOptions options_;
  std::string of_carriage_;
  CycleSetup setup_;
  LinkPairIndex pair_{0};
};

/// Where two of the shapes about the spindle meet, a small ball is deep in the spindle and in
/// neither of them.
class DeepInNoShape : public AllowedDepth {
 protected:
  DeepInNoShape() { build(kSpindle, collision(meshXml()), kSmallBall); }

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
  EXPECT_TRUE(hasPassed(posesAt(kSeam, 0.5), posesAt(kSeam, -0.5)));
}

/// The hull about an angle is deep in the ball; the shape that the ball is in is not.
TEST_F(AllowedDepth, hullThatIsDeeperThanShapes_isAContactOnTheWayToo) {
  options_.refine.geometry = RefineGeometry::hull;
  build(kAngle, collision(meshXml()), ballAt(0.01, "0 0.15 0"));
  ASSERT_GT(bodiesAt(0.098, 0.0), -kAllowed);
  EXPECT_EQ(cycleAt(0.098, 0.0), Verdict::contact);
  EXPECT_EQ(go(0.098, 0.5, -0.5).state, ApproachState::contact);
}

/// The small ball is 23 mm deep in a cylinder of the body, which is allowed, and deeper than it is
/// in the shapes about the spindle.
TEST_F(AllowedDepth, besideADeeperPairThatIsAllowed_theDeepOneIsSeen) {
  const std::string cylinder = collision("<cylinder radius='0.1' length='0.3'/>",
                                         "xyz='0.16 0.087 0' rpy='0 1.5707963267949 0'");
  options_.default_limits.max_shapes = 8;
  build(kSpindle, collision(meshXml("scale='0.1 0.1 0.1'")) + cylinder, kSmallBall);
  ASSERT_EQ(cycleAt(0.16, 0.0), Verdict::warning);
  build(kSpindle, collision(meshXml()) + cylinder, kSmallBall);
  EXPECT_EQ(cycleAt(0.16, 0.0), Verdict::contact);
}

/// The carriage is 28 mm deep in a ball of the body, which is allowed.
TEST_F(AllowedDepth, besideADeeperPairThatIsAllowed_statesAreAsTheGeometries) {
  of_carriage_ = ballAt(0.1, "0 1.172 0");
  build(kSpindle, collision(meshXml()) + ballAt(0.1, "0.16 1 0"), kSmallBall);
  EXPECT_EQ(stateAt(0.16, 0.07, StateQuestion::contact, true).verdict, Verdict::clear);
  EXPECT_EQ(stateAt(0.16, 0.07, StateQuestion::nearest, true).verdict, Verdict::warning);
  EXPECT_EQ(stateAt(0.16, 0.0, StateQuestion::contact, true).verdict, Verdict::contact);
}

TEST_F(AllowedDepth, besideADeeperPairThatIsAllowed_stateNamesTheContact) {
  of_carriage_ = ballAt(0.1, "0 1.172 0");
  build(kAngle, collision(meshXml()) + ballAt(0.1, "0.28 1 0"), collision(meshXml()));
  const StateCheck found = stateAt(0.28, 0.0, StateQuestion::contact, true);
  ASSERT_EQ(found.verdict, Verdict::contact);
  ASSERT_TRUE(found.has_pair);
  EXPECT_EQ(setup_.link_pair_of[index(found.pair)], pair_);
  EXPECT_GT(found.distance, -0.027);
}

/// Two arrows point at each other, their tips 10 mm beyond, and pass.
class ArrowsThatPass : public AllowedDepth {
 protected:
  void buildArrows(const std::string& scale = "1 1 1", const std::string& more_of_body = "",
                   const std::string& more_of_ball = "") {
    const std::string arrow = meshXml(" scale='" + scale + "'");
    build(kArrow, more_of_body + collision(arrow),
          more_of_ball + collision(arrow, "rpy='0 0 3.14159265358979'"));
  }
};

TEST_F(ArrowsThatPass, betweenTwoCycles_isAContact) {
  buildArrows();
  EXPECT_TRUE(hasPassed(posesAt(0.59, 0.004), posesAt(0.59, -0.004)));
  EXPECT_FALSE(hasPassed(posesAt(0.61, 0.004), posesAt(0.61, -0.004)));
}

TEST_F(ArrowsThatPass, smallOnesThatGoFarAfterThat_isAContact) {
  // Near the body all the time: what is closest is looked at however far it is.
  of_carriage_ = collision("<box size='2 0.1 0.1'/>", "xyz='0 5 0'");
  buildArrows("0.1 0.1 0.1", ballAt(0.1, "0 5.16 0"));
  for (const BroadPhaseKind kind : {BroadPhaseKind::brute_force, BroadPhaseKind::combination}) {
    for (const double far : {0.1, 0.2, 0.25, 0.3, 0.4}) {
      EXPECT_TRUE(
          hasPassed(posesAt(0.059, 0.00034), posesAt(0.059 + far, 0.00034 - 0.35 * far), kind))
          << far;
    }
  }
}

TEST_F(ArrowsThatPass, trajectory_isAContact) {
  buildArrows();
  EXPECT_EQ(go(0.59, 0.004, -0.004).state, ApproachState::contact);
  EXPECT_EQ(go(0.5994, 0.0003, -0.0003).state, ApproachState::contact) << "less than resolution";
  EXPECT_EQ(go(0.61, 0.004, -0.004).state, ApproachState::clear);
}

/// The same links have balls that are 28 mm deep in each other, which is allowed.
TEST_F(ArrowsThatPass, besideElementsThatAreAllowedTo_isAContact) {
  buildArrows("1 1 1", ballAt(0.1, "0.59 1 0"), ballAt(0.1, "0 1.172 0"));
  EXPECT_TRUE(hasPassed(posesAt(0.59, 0.004), posesAt(0.59, -0.004)));
  EXPECT_EQ(go(0.59, 0.004, -0.0045).state, ApproachState::contact);
  EXPECT_EQ(go(0.61, 0.004, -0.0045).state, ApproachState::clear);
  LinkPairMeasures measures(setup_);
  elementDistance(measures, pair_, posesAt(0.601, 0.0).world_from_link);
  EXPECT_NEAR(measures.leeway, 0.001, 1e-6) << "of the tips; the balls have some 2 mm";
}

/// Concave meshes that overlap are in contact however deep, in every answer.
TEST_F(AllowedDepth, concaveMeshesThatOverlapLess_areInContact) {
  build(kAngle, collision(meshXml()), collision(meshXml()));
  const double along = 0.28;
  ASSERT_GT(bodiesAt(along, 0.0), -kAllowed);
  EXPECT_EQ(cycleAt(along, 0.0), Verdict::contact);
  EXPECT_EQ(go(along, 0.5, 0.0).state, ApproachState::contact);
  EXPECT_EQ(stateAt(along, 0.0, StateQuestion::contact, true).verdict, Verdict::contact);
  EXPECT_EQ(stateAt(along, 0.0, StateQuestion::nearest, true).verdict, Verdict::contact);
}

}  // namespace
}  // namespace collision_monitor::test
