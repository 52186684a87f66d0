// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/kinematics/state_kinematics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/expect_distance.h"
#include "support/instruction_sets.h"
#include "support/robots/urdf_text.h"

namespace collision_monitor::test {
namespace {

constexpr double kQuarter = 1.5707963267948966;

RobotModel modelOf(const std::string& links_and_joints) {
  return readText(robotXml(links_and_joints)).model;
}

/// A model in up to kStateCount states, asked of every instruction set.
class StateKinematicsTest : public testing::TestWithParam<std::int64_t> {
 protected:
  void place(const RobotModel& model, const StandingPoses& standing,
             const std::vector<JointPositions>& states) {
    plan_ = planKinematics(model, standing);
    std::vector<StateNumber> variables(plan_.variable_count);
    for (std::size_t i = 0; i < plan_.variable_count; ++i) {
      for (std::size_t state = 0; state < kStateCount; ++state) {
        variables[i].of[state] = states[std::min(state, states.size() - 1)][i];
      }
    }
    frames_.resize(plan_.frames.size());
    placeFrames(plan_, variables, frames_);
  }

  Pose linkIn(std::size_t state, std::size_t link) const {
    const LinkPlace& place = plan_.links[link];
    if (place.frame == MovingFrame::kWorld) {
      return place.frame_from_link;
    }
    return poseOf(frames_[place.frame], state) * place.frame_from_link;
  }

  KinematicsPlan plan_;
  std::vector<StatePose> frames_;

 private:
  OnlyInstructionSet only_{GetParam()};
};

TEST_P(StateKinematicsTest, turningJoint_movesWhatHangsBehindFixedOnes) {
  const RobotModel model =
      modelOf("<link name='a'/><link name='b'/><link name='c'/><link name='d'/>" +
              jointXml("fixed_1", "fixed", "a", "b", "<origin xyz='1 0 0'/>") +
              jointXml("turn", "continuous", "b", "c", "<origin xyz='0 2 0'/><axis xyz='1 0 0'/>") +
              jointXml("fixed_2", "fixed", "c", "d", "<origin xyz='0 3 0'/>"));
  place(model, standingAt(model, {at(0, 0, 10)}), {{0.0}, {kQuarter}, {2.0 * kQuarter}});
  EXPECT_EQ(plan_.frames.size(), 1U) << "fixed joints cost nothing";
  expectNear(linkIn(0, 1).translation, {1, 0, 10}, "b");
  expectNear(linkIn(0, 3).translation, {1, 5, 10}, "d at 0");
  expectNear(linkIn(1, 3).translation, {1, 2, 13}, "d at a quarter turn");
  expectNear(linkIn(2, 3).translation, {1, -1, 10}, "d at half a turn");
  expectNear(linkIn(1, 3).rotation.col(1), {0, 0, 1}, "its y axis");
}

TEST_P(StateKinematicsTest, slidingAndMimickingJoints) {
  const RobotModel model = modelOf(
      "<link name='a'/><link name='b'/><link name='c'/>" +
      jointXml("slide", "prismatic", "a", "b",
               "<axis xyz='0 0 -1'/><limit lower='-9' upper='9' velocity='1' effort='1'/>") +
      jointXml("follow", "prismatic", "a", "c",
               "<axis xyz='0 1 0'/><limit lower='-9' upper='9' velocity='1' effort='1'/>"
               "<mimic joint='slide' multiplier='-2' offset='0.5'/>"));
  place(model, standingAt(model, {Pose{}}), {{0.0}, {1.5}});
  expectNear(linkIn(1, 1).translation, {0, 0, -1.5}, "b");
  expectNear(linkIn(0, 2).translation, {0, 0.5, 0}, "c at 0");
  expectNear(linkIn(1, 2).translation, {0, -2.5, 0}, "c at 1.5");
}

TEST_P(StateKinematicsTest, planarAndFloatingJoints) {
  const RobotModel model = modelOf("<link name='a'/><link name='b'/><link name='c'/>" +
                                   jointXml("plane", "planar", "a", "b", "<axis xyz='0 0 1'/>") +
                                   jointXml("fly", "floating", "b", "c", "<origin xyz='0 0 1'/>"));
  // Quaternions need not be unit: (0, 0, 2, 2) turns about z by a quarter.
  place(model, standingAt(model, {Pose{}}), {{3, 4, kQuarter, 1, 0, 0, 0, 0, 2, 2}});
  expectNear(linkIn(0, 1).translation, {3, 4, 0}, "b");
  expectNear(linkIn(0, 2).translation, {3, 5, 1}, "c");
  expectNear(linkIn(0, 2).rotation.col(0), {-1, 0, 0}, "x of c");
}

TEST_P(StateKinematicsTest, heldJointIsAConstant) {
  const RobotModel model = modelOf("<link name='a'/><link name='b'/>" +
                                   jointXml("turn", "continuous", "a", "b", "<axis xyz='0 0 1'/>"));
  StandingPoses standing = standingAt(model, {Pose{}});
  standing.held[0] = at(0, 7, 0);
  place(model, standing, {{1.0}});
  EXPECT_TRUE(plan_.frames.empty());
  expectNear(linkIn(0, 1).translation, {0, 7, 0}, "b");
}

TEST_P(StateKinematicsTest, hugeAngle_isThatOfTheStandardLibrary) {
  const RobotModel model = modelOf("<link name='a'/><link name='b'/>" +
                                   jointXml("turn", "continuous", "a", "b", "<axis xyz='0 0 1'/>"));
  place(model, standingAt(model, {Pose{}}), {{1e15}, {-1e7}, {0.5}});
  for (const auto& [state, angle] :
       {std::pair<std::size_t, double>{0, 1e15}, {1, -1e7}, {2, 0.5}}) {
    expectNear(linkIn(state, 1).rotation.col(0), {std::cos(angle), std::sin(angle), 0}, "x of b");
  }
}

TEST_P(StateKinematicsTest, axisThatPointsNearlyBack_isAsExactAsOthers) {
  for (const char* tilt : {"1e-2", "1.55e-3", "1e-5", "1e-7", "1e-12", "1e-160"}) {
    const RobotModel model =
        modelOf("<link name='a'/><link name='b'/>" +
                jointXml("turn", "continuous", "a", "b",
                         "<axis xyz='" + std::string(tilt) + " -" + tilt + " -1'/>"));
    place(model, standingAt(model, {Pose{}}), {{0.7}});
    std::vector<Pose> links;
    placeLinks(model, {0.7}, {Pose{}}, links);
    EXPECT_TRUE(isRigid(linkIn(0, 1), 1e-14)) << tilt;
    EXPECT_LE((linkIn(0, 1).rotation - links[1].rotation).cwiseAbs().maxCoeff(), 1e-14) << tilt;
  }
}

TEST_P(StateKinematicsTest, variableThatIsNotFinite_spoilsItsStateAlone) {
  const RobotModel model = modelOf("<link name='a'/><link name='b'/><link name='c'/>" +
                                   jointXml("turn", "continuous", "a", "b", "<axis xyz='0 1 1'/>") +
                                   jointXml("fly", "floating", "a", "c"));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  place(model, standingAt(model, {Pose{}}),
        {{nan, 0, 0, 0, 0, 0, 0, 0}, {0.5, 0, 0, 0, 0, 0, 0, 1}, {INFINITY, 0, 0, 0, 0, 0, 0, 1}});
  EXPECT_FALSE(isFinite(linkIn(0, 1)));
  EXPECT_FALSE(isFinite(linkIn(0, 2))) << "a quaternion of zeros is no rotation";
  EXPECT_TRUE(isRigid(linkIn(1, 1), 1e-14));
  EXPECT_TRUE(isRigid(linkIn(1, 2), 1e-14));
  EXPECT_FALSE(isFinite(linkIn(2, 1)));
}

INSTANTIATE_TEST_SUITE_P(EveryInstructionSet, StateKinematicsTest,
                         testing::ValuesIn(instructionSets()),
                         [](const auto& target) { return hwy::TargetName(target.param); });

}  // namespace
}  // namespace collision_monitor::test
