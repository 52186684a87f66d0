// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/poses/pose_reader.h"

#include "pose_reader_scene.h"

namespace collision_monitor::test {
namespace {

TEST_F(PoseReaderTest, nothingReceived_onlyTheWorldItselfIsKnown) {
  read(1.0);
  EXPECT_EQ(status("base"), LinkStatus::known);
  EXPECT_EQ(age("base"), 0.0);
  EXPECT_EQ(status("arm"), LinkStatus::missing);
  EXPECT_EQ(status("hand"), LinkStatus::missing);
  EXPECT_EQ(explain("hand"), "no transform from 'base' to 'arm' yet");
  EXPECT_EQ(poses_.stamp_ns, 0) << "there are no data";
}

TEST_F(PoseReaderTest, chainIsComposedFromTheRoot) {
  sendArm(10.0, 0.25);
  EXPECT_TRUE(read(10.1));
  EXPECT_EQ(status("hand"), LinkStatus::known);
  EXPECT_DOUBLE_EQ(x("arm"), 0.25);
  EXPECT_DOUBLE_EQ(x("wrist"), 0.5);
  EXPECT_DOUBLE_EQ(x("hand"), 0.75);
  EXPECT_NEAR(age("hand"), 0.1, 1e-9);
  EXPECT_EQ(poses_.stamp_ns, 10'000'000'000);
}

TEST_F(PoseReaderTest, parentBelowItsChildInTf_isWalkedDownwards) {
  send("arm", "base", 10.0, -0.5);
  send("arm", "wrist", 10.0, 0.25);
  send("wrist", "hand", 10.0, 0.25);
  read(10.0);
  EXPECT_DOUBLE_EQ(x("arm"), 0.5);
  EXPECT_DOUBLE_EQ(x("hand"), 1.0);
}

TEST_F(PoseReaderTest, olderDataBringAnotherParent_posesOfTheTwoAreNotMixed) {
  sendArm(10.0, 0.25);
  sendStatic("base", "torso", 1.0);
  send("torso", "arm", 9.9, 0.5);
  read(10.0);
  EXPECT_DOUBLE_EQ(x("arm"), 0.25) << "at 10.0 the arm hung on the base";
}

TEST_F(PoseReaderTest, noNews_nothingIsNew) {
  sendArm(10.0, 0.25);
  read(10.1);
  EXPECT_FALSE(read(10.2));
  EXPECT_NEAR(age("hand"), 0.2, 1e-9) << "ages grow all the same";
}

TEST_F(PoseReaderTest, publishersAtDifferentStamps_newestStampThatAllHave) {
  sendArm(10.0, 0.0);
  send("base", "arm", 10.1, 1.0);
  send("arm", "wrist", 10.1, 0.0);
  send("wrist", "hand", 10.05, 0.0);
  read(10.11);
  EXPECT_EQ(poses_.stamp_ns, 10'050'000'000);
  EXPECT_NEAR(x("arm"), 0.5, 1e-6) << "half way from 10.0 to 10.1";
}

TEST_F(PoseReaderTest, oldLink_isStaleAndHoldsNobodyBack) {
  sendArm(10.0, 0.0);
  send("base", "arm", 10.6, 1.0);
  send("arm", "wrist", 10.6, 0.0);
  read(10.6);
  EXPECT_EQ(status("arm"), LinkStatus::known);
  EXPECT_EQ(status("hand"), LinkStatus::stale);
  EXPECT_EQ(poses_.stamp_ns, 10'600'000'000);
  EXPECT_DOUBLE_EQ(x("arm"), 1.0);
  EXPECT_EQ(explain("hand"), "no transform for 0.60 s");
}

TEST_F(PoseReaderTest, linkWithoutGeometryAtTheEndOfAChain_holdsNobodyBack) {
  sendArm(10.0, 0.0);
  send("base", "camera", 9.9, 0.0);
  read(10.0);
  EXPECT_EQ(poses_.stamp_ns, 10'000'000'000);
}

TEST_F(PoseReaderTest, linkWithoutGeometryInAChain_makesTheLinksBehindItUnknown) {
  send("base", "arm", 10.0, 0.0);
  send("wrist", "hand", 10.0, 0.0);
  read(10.0);
  EXPECT_EQ(status("arm"), LinkStatus::known);
  EXPECT_EQ(status("hand"), LinkStatus::missing);
  EXPECT_EQ(explain("hand"), "no transform from 'arm' to 'wrist' yet");
}

TEST_F(PoseReaderTest, staticChain_hasNoAge) {
  sendStatic("base", "arm", 1.0);
  sendStatic("arm", "wrist", 1.0);
  sendStatic("wrist", "hand", 1.0);
  read(1000.0);
  EXPECT_EQ(status("hand"), LinkStatus::known);
  EXPECT_EQ(age("hand"), 0.0);
  EXPECT_DOUBLE_EQ(x("hand"), 3.0);
  EXPECT_EQ(poses_.stamp_ns, 1'000'000'000'000) << "static transforms are of every time";
}

TEST_F(PoseReaderTest, staticTransformSentAgain_isReadAgain) {
  sendStatic("base", "arm", 1.0);
  read(1.0);
  sendStatic("base", "arm", 2.0);
  read(1.1);
  EXPECT_DOUBLE_EQ(x("arm"), 2.0);
}

TEST_F(PoseReaderTest, frameBetweenParentAndChild_isFollowed) {
  sendStatic("base", "flange", 1.0);
  send("flange", "arm", 10.0, 0.5);
  read(10.0);
  EXPECT_DOUBLE_EQ(x("arm"), 1.5);
  EXPECT_NEAR(age("arm"), 0.0, 1e-9);
}

TEST_F(PoseReaderTest, worldBelowTheRoot_isFollowedUpwards) {
  options_.world_frame = "marker";
  sendStatic("base", "marker", 2.0);
  read(1.0);
  EXPECT_EQ(status("base"), LinkStatus::known);
  EXPECT_DOUBLE_EQ(x("base"), -2.0);
}

TEST_F(PoseReaderTest, worldThatNothingJoins_isMissing) {
  options_.world_frame = "map";
  sendArm(10.0, 0.0);
  read(10.0);
  EXPECT_EQ(status("base"), LinkStatus::missing);
  EXPECT_EQ(status("hand"), LinkStatus::missing);
  EXPECT_EQ(explain("base"), "no transform from 'map' to 'base' yet");
}

TEST_F(PoseReaderTest, leadingSlashes_areStripped) {
  options_.world_frame = "/base";
  send("/base", "/arm", 10.0, 0.5);
  read(10.0);
  EXPECT_EQ(status("arm"), LinkStatus::known);
}

TEST_F(PoseReaderTest, timeJumpsBack_movingLinksAreMissingUntilNewDataCome) {
  sendStatic("base", "arm", 1.0);
  send("arm", "wrist", 10.0, 0.5);
  send("wrist", "hand", 10.0, 0.5);
  read(10.0);
  ASSERT_EQ(status("hand"), LinkStatus::known);
  read(5.0);
  EXPECT_EQ(status("arm"), LinkStatus::known) << "static transforms survive";
  EXPECT_EQ(status("hand"), LinkStatus::missing);
  EXPECT_EQ(explain("hand"), "no usable transform from 'arm' to 'wrist' yet");
  send("arm", "wrist", 5.1, 0.25);
  send("wrist", "hand", 5.1, 0.25);
  read(5.1);
  EXPECT_EQ(status("hand"), LinkStatus::known);
  EXPECT_DOUBLE_EQ(x("hand"), 1.5);
}

TEST_F(PoseReaderTest, dataFromTheFuture_areStale) {
  read(10.0);
  store_.accept({transformAlongX("base", "arm", 20.0, 0.5)}, false);
  read(10.0);
  EXPECT_EQ(status("arm"), LinkStatus::stale);
  EXPECT_NE(explain("arm").find("10.00 s in the future"), std::string::npos) << explain("arm");
}

TEST_F(PoseReaderTest, gapInTheData_isNotBridged) {
  sendArm(10.0, 0.0);
  read(10.0);
  // Arm and wrist come back after three seconds, the hand a little later than they.
  send("wrist", "hand", 12.9, 0.0);
  send("wrist", "hand", 12.95, 0.0);
  send("base", "arm", 13.0, 1.0);
  send("base", "arm", 13.01, 1.0);
  send("arm", "wrist", 13.0, 0.0);
  read(13.01);
  EXPECT_EQ(poses_.stamp_ns, 12'950'000'000);
  EXPECT_EQ(status("arm"), LinkStatus::stale) << "between 10.0 and 13.0 nothing is known";
  send("wrist", "hand", 13.0, 0.0);
  read(13.01);
  EXPECT_EQ(status("arm"), LinkStatus::known);
  EXPECT_DOUBLE_EQ(x("arm"), 1.0);
}

TEST_F(PoseReaderTest, dataThatBeginAfterTheCommonStamp_areNotExtrapolated) {
  send("base", "arm", 10.0, 0.0);
  send("arm", "wrist", 10.2, 0.0);
  send("wrist", "hand", 10.2, 0.0);
  read(10.2);
  EXPECT_EQ(status("arm"), LinkStatus::known);
  EXPECT_EQ(status("hand"), LinkStatus::missing);
}

TEST_F(PoseReaderTest, rotationSlightlyOffUnitLength_isMadeRigid) {
  auto transform = transformAlongX("base", "arm", 10.0, 0.0);
  transform.transform.rotation.w = 1.002;
  store_.accept({transform}, false);
  read(10.0);
  ASSERT_EQ(status("arm"), LinkStatus::known);
  EXPECT_TRUE(isRigid(poses_.world_from_link[at("arm")], 1e-12));
}

}  // namespace
}  // namespace collision_monitor::test
