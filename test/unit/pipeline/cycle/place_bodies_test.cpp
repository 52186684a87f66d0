// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/cycle/place_bodies.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/expect_distance.h"
#include "support/robots/hand_made_setup.h"

namespace collision_monitor::test {
namespace {

using Eigen::Vector3d;

/// A capsule 0.3 m along x of link 0, two balls on link 1, one on link 2.
class PlaceBodies : public testing::Test {
 protected:
  void place() { placeBodies(setup_, poses_, body_poses_); }
  void floatAs(std::size_t link, PartId part) { poses_.part[link] = part; }

  CycleSetup setup_ = handMadeSetup({{0, Capsule{0.2, 0.1}, at(0.3, 0, 0)},
                                     {1, Sphere{0.1}},
                                     {1, Sphere{0.1}, at(0, 0, 0.5)},
                                     {2, Sphere{0.1}}});
  BodyPoses body_poses_ = makeBodyPoses(setup_);
  LinkPoses poses_ = knownPoses(setup_);
};

TEST_F(PlaceBodies, bodyStandsWhereItsLinkHasIt) {
  // x of the link is the world's z, z its y.
  poses_.world_from_link[0] = {axes(Vector3d::UnitZ(), Vector3d::UnitX()), {1, 2, 3}};
  place();
  expectNear(body_poses_.world_from_body[0].translation, {1, 2, 3.3}, "place");
  expectNear(body_poses_.world_from_body[0].rotation.col(2), Vector3d::UnitY(), "axis");
  expectNear(body_poses_.balls[0].center, {1, 2, 3.3}, "center of its ball");
  EXPECT_NEAR(body_poses_.balls[0].radius, 0.3, kExact);
  expectNear(body_poses_.world_from_body[2].translation, {0, 0, 0.5}, "second body of a link");
}

TEST_F(PlaceBodies, elementsStandWithTheirLinks) {
  poses_.world_from_link[1].translation = {1, 0, 0};
  place();
  placeElements(setup_, poses_, body_poses_);
  expectNear(body_poses_.world_from_element[0].translation, {0.3, 0, 0}, "of link 0");
  expectNear(body_poses_.world_from_element[2].translation, {1, 0, 0.5}, "of link 1");
}

TEST_F(PlaceBodies, linkThatIsNotKnown_noneOfItsBodiesIs) {
  poses_.status[1] = LinkStatus::stale;
  place();
  EXPECT_EQ(body_poses_.known, (std::vector<unsigned char>{1, 0, 0, 1}));
  EXPECT_EQ(body_poses_.link_known, (std::vector<unsigned char>{1, 0, 1}));
  poses_.status[1] = LinkStatus::known;
  place();
  EXPECT_EQ(body_poses_.known, (std::vector<unsigned char>{1, 1, 1, 1}));
}

TEST_F(PlaceBodies, poseCalledKnownThatIsNone_isNotKnown) {
  poses_.world_from_link[0].rotation(0, 1) = 0.5;  // a shear
  poses_.world_from_link[2].translation.x() = std::numeric_limits<double>::quiet_NaN();
  place();
  EXPECT_EQ(body_poses_.link_known, (std::vector<unsigned char>{0, 1, 0}));
}

TEST_F(PlaceBodies, linkThatFloatsAlone_isNotKnownAndTwoThatFloatTogetherAre) {
  floatAs(2, 2);
  place();
  EXPECT_EQ(body_poses_.link_known, (std::vector<unsigned char>{1, 1, 0}));
  EXPECT_FALSE(body_poses_.is_split);
  floatAs(1, 1);
  floatAs(2, 1);
  place();
  EXPECT_EQ(body_poses_.link_known, (std::vector<unsigned char>{1, 1, 1}));
  EXPECT_TRUE(body_poses_.is_split);
  EXPECT_FALSE(isJoined(body_poses_, LinkId{0}, LinkId{1}));
  EXPECT_TRUE(isJoined(body_poses_, LinkId{1}, LinkId{2}));
}

TEST_F(PlaceBodies, everythingInOneFloatingPart_isNotSplit) {
  for (std::size_t link = 0; link < 3; ++link) {
    floatAs(link, 0);
  }
  place();
  EXPECT_EQ(body_poses_.link_known, (std::vector<unsigned char>{1, 1, 1}));
  EXPECT_FALSE(body_poses_.is_split);
}

}  // namespace
}  // namespace collision_monitor::test
