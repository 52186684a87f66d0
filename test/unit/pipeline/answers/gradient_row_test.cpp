// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/answers/gradient_row.h"

#include <gtest/gtest.h>

#include "collision_monitor/model/kinematics.h"
#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/cycle/measure_pairs.h"
#include "pipeline/cycle/place_bodies.h"
#include "support/robots/urdf_text.h"

namespace collision_monitor {
namespace {

using test::jointXml;
using test::robotXml;

const std::string kLimit = "<limit lower='-9' upper='9'/>";

/// Balls of radius 0.1 m: base at the origin; cart, which slides along x, 1 m aside in y, its ball
/// far below; on it the follower, back on the x axis, which mimics the slide twice; and on the cart
/// an arm that turns about z and carries a ball 1 m along its x.
const std::string kCart = robotXml(
    test::linkXml("base", "<sphere radius='0.1'/>") +
    test::linkXml("cart", "<sphere radius='0.1'/>", "<origin xyz='0 0 -9'/>") +
    test::linkXml("follower", "<sphere radius='0.1'/>") +
    test::linkXml("arm", "<sphere radius='0.1'/>", "<origin xyz='1 0 0'/>") +
    jointXml("slide", "prismatic", "base", "cart",
             "<origin xyz='0 1 0'/><axis xyz='1 0 0'/>" + kLimit) +
    jointXml(
        "follow", "prismatic", "cart", "follower",
        "<origin xyz='0 -1 0'/><axis xyz='1 0 0'/><mimic joint='slide' multiplier='2'/>" + kLimit) +
    jointXml("turn", "continuous", "cart", "arm", "<axis xyz='0 0 1'/>"));

class GradientRowTest : public testing::Test {
 protected:
  static CycleSetup build(const std::vector<RobotDescription>& robots) {
    SetupOptions options;
    options.ignore_default_overlap = false;
    return buildSetup(robots, test::textLoader({}), options);
  }
  GradientRow rowOf(const char* a, const char* b, double slide, double turn) {
    const RobotModel& model = setup_.model;
    JointPositions positions(model.variable_count, 0.0);
    for (const Joint& joint : model.joints) {
      const bool turns = joint.type == JointType::continuous;
      positions[joint.first_variable] = turns ? turn : slide;
    }
    LinkPoses poses = makeLinkPoses(model);
    placeLinks(model, positions, std::vector<Pose>(model.robots.size()), poses.world_from_link);
    std::fill(poses.status.begin(), poses.status.end(), LinkStatus::known);
    CycleBuffers buffers = makeBuffers(setup_, BroadPhaseKind::brute_force);
    placeBodies(setup_, poses, buffers.body_poses);
    GradientRow row;
    for (std::size_t i = 0; i < setup_.table.size(); ++i) {
      const CheckedLinkPair& pair = setup_.checked[setup_.link_pair_of[i]];
      if (pair.a == *model.findLink(a) && pair.b == *model.findLink(b)) {
        measurePairs(setup_, buffers.body_poses, {idAt<PairId>(i)}, buffers.distances);
        row = GradientRows(setup_, poses).of(buffers.distances.pairs[0]);
      }
    }
    return row;
  }
  void expectEntry(const GradientEntry& entry, const char* name, double value) const {
    EXPECT_EQ(setup_.velocity_names[entry.variable], name);
    EXPECT_NEAR(entry.value, value, 1e-12);
  }

  CycleSetup setup_ = build({test::describeText(kCart)});
};

TEST_F(GradientRowTest, mimicJoint_countsForItsSource) {
  // The follower is at x = 3 slide.
  const GradientRow apart = rowOf("base", "follower", 0.5, 0.0);
  ASSERT_EQ(apart.size(), 1U);
  expectEntry(apart[0], "slide", 3.0);
}

TEST_F(GradientRowTest, overlapping_hasTheSameSign) {
  const GradientRow row = rowOf("base", "follower", 0.05, 0.0);  // 0.05 m deep
  ASSERT_EQ(row.size(), 1U);
  expectEntry(row[0], "slide", 3.0);
  const GradientRow behind = rowOf("base", "follower", -0.05, 0.0);
  expectEntry(behind[0], "slide", -3.0);
}

TEST_F(GradientRowTest, turningJoint_hasItsLever) {
  // The arm points to -y, its ball at (0, 0, 0) + slide = (0.3, 0, 0); to turn on moves it along x.
  const GradientRow row = rowOf("base", "arm", 0.3, -std::acos(0.0));
  ASSERT_EQ(row.size(), 2U);
  expectEntry(row[0], "slide", 1.0);
  expectEntry(row[1], "turn", 1.0);
}

TEST_F(GradientRowTest, jointsThatMoveBothLinks_areNotInTheRow) {
  // Follower and arm hang on the cart: what the slide does to the cart moves both.
  const GradientRow row = rowOf("follower", "arm", 0.0, 0.0);
  ASSERT_EQ(row.size(), 2U);
  // Follower at (0, 0), ball at (1, 1): the normal is (1, 1) / sqrt(2).
  const double half = std::sqrt(0.5);
  expectEntry(row[0], "slide", -2.0 * half);
  expectEntry(row[1], "turn", half);
}

TEST_F(GradientRowTest, twoRobots_haveTheJointsOfBoth) {
  RobotDescription left = test::describeText(kCart);
  RobotDescription right = left;
  left.tf_prefix = "left";
  right.tf_prefix = "right";
  setup_ = build({left, right});
  const GradientRow row = rowOf("left/follower", "right/follower", 0.5, 0.0);
  ASSERT_EQ(row.size(), 2U);
  EXPECT_EQ(setup_.velocity_names[row[0].variable], "left/slide");
  EXPECT_EQ(setup_.velocity_names[row[1].variable], "right/slide");
  EXPECT_NEAR(row[0].value, -row[1].value, 1e-12);
}

}  // namespace
}  // namespace collision_monitor
