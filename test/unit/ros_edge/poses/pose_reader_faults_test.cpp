// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "pose_reader_scene.h"

// Transforms that are no data, and how the reader says so.
namespace collision_monitor::test {
namespace {

using PoseReaderFaults = PoseReaderTest;

TEST_F(PoseReaderFaults, nanTransform_isNotFiniteUntilAGoodOneComes) {
  sendArm(10.0, 0.5);
  send("base", "arm", 10.1, std::nan(""));
  read(10.1);
  EXPECT_EQ(status("arm"), LinkStatus::not_finite);
  EXPECT_EQ(status("hand"), LinkStatus::not_finite);
  send("base", "arm", 10.2, 0.5);
  read(10.2);
  EXPECT_EQ(status("arm"), LinkStatus::known);
}

TEST_F(PoseReaderFaults, quaternionThatIsNoRotation_isNotFinite) {
  sendArm(10.0, 0.5);
  auto transform = transformAlongX("base", "arm", 10.1, 0.5);
  transform.transform.rotation.w = 0.0;
  now_ = ros::Time(10.1);
  store_.accept({transform}, false);
  read(10.1);
  EXPECT_EQ(status("arm"), LinkStatus::not_finite);
}

/// A number that nobody wrote, say. Of 1e17 m the last digit is 16 m: links that touch could seem
/// to be apart, and whatever hangs on the frame with them.
TEST_F(PoseReaderFaults, transformFartherThanNumbersAreFine_isNotFinite) {
  sendArm(10.0, 0.5);
  send("arm", "wrist", 10.1, -1e17);
  read(10.1);
  EXPECT_EQ(status("arm"), LinkStatus::known);
  EXPECT_EQ(status("hand"), LinkStatus::not_finite);
  EXPECT_EQ(explain("hand"),
            "the transform to 'wrist' is not finite, no rotation or farther than 1e9 m");
  send("arm", "wrist", 10.2, 6.4e6);  // from the middle of the earth
  read(10.2);
  EXPECT_EQ(status("hand"), LinkStatus::known);
}

TEST_F(PoseReaderFaults, transformWithoutStamp_isRefused) {
  read(10.0);
  send("base", "arm", 0.0, 0.5);
  read(10.0);
  EXPECT_EQ(status("arm"), LinkStatus::missing) << "it would never grow old";
  EXPECT_EQ(explain("arm"),
            "no transform from 'base' to 'arm' yet; refused for want of a stamp: 1 transform");
}

TEST_F(PoseReaderFaults, transformFarAheadOfNow_isToldUntilAGoodOneComes) {
  const auto sendAhead = [&](const char* parent, const char* child) {
    store_.accept({transformAlongX(parent, child, 3610.0, 0.5)}, false);
  };
  read(10.0);
  sendAhead("base", "arm");
  read(10.0);
  EXPECT_EQ(status("arm"), LinkStatus::missing);
  const std::string clocks =
      " is 3600.00 s in the future; the clocks of two machines differ, or use_sim_time is set for "
      "one node only";
  EXPECT_EQ(explain("arm"), "the newest transform" + clocks);
  sendArm(10.0, 0.5);
  sendAhead("arm", "wrist");
  read(10.0);
  EXPECT_EQ(status("hand"), LinkStatus::known) << "one that is wrong hides nothing";
  send("base", "arm", 10.6, 0.5);
  read(10.6);
  EXPECT_EQ(status("arm"), LinkStatus::known);
  EXPECT_EQ(explain("hand"), "the newest transform to 'wrist'" + clocks);
  sendArm(10.6, 0.5);
  read(10.6);
  EXPECT_EQ(status("hand"), LinkStatus::known);
}

TEST_F(PoseReaderFaults, transformRefusedSomeTimeAgo_isNoLongerTheNewest) {
  sendArm(10.0, 0.5);
  store_.accept({transformAlongX("base", "arm", 3610.0, 0.5)}, false);
  read(15.0);
  EXPECT_EQ(explain("arm"),
            "no transform for 5.00 s; what came last, 5.00 s ago, was refused: it was 3600.00 s in "
            "the future");
  EXPECT_EQ(explain("hand"), "no transform to 'arm'" + explain("arm").substr(12));
}

TEST_F(PoseReaderFaults, transformsRefusedSomeTimeAgo_areToldWithTheirTime) {
  read(10.0);
  store_.accept({transformAlongX("base", "arm", 0.0, 0.5)}, false);
  store_.accept({transformAlongX("base", "arm", 3610.0, 0.5)}, false);
  read(12.5);
  const std::string none = "no transform from 'base' to 'arm' yet";
  EXPECT_EQ(explain("arm"), none +
                                "; refused for want of a stamp: 1 transform, the last 2.50 s ago"
                                "; refused as too far in the future: 1 transform, the last 2.50 s "
                                "ago");
  read(1.0);
  EXPECT_EQ(explain("arm"), none) << "time jumped back";
}

/// Simulated time starts over, and one message of before comes late.
TEST_F(PoseReaderFaults, transformOfBeforeAJumpThatComesAfterIt_hidesNothing) {
  sendArm(1004.0, 0.5);
  read(1004.0);
  read(1.0);
  store_.accept({transformAlongX("base", "arm", 1004.0, 0.5)}, false);
  sendArm(1.1, 0.25);
  read(1.1);
  EXPECT_EQ(status("hand"), LinkStatus::known);
  EXPECT_DOUBLE_EQ(x("arm"), 0.25);
}

/// Somebody sends the root as a child of the hand: above no frame is a last one.
TEST_F(PoseReaderFaults, loopThroughTheRoot_isNamedOnceForAllLinks) {
  sendArm(10.0, 0.5);
  send("hand", "base", 10.0, 0.5);
  send("base", "arm", 0.0, 0.5);
  read(10.0);
  EXPECT_EQ(status("base"), LinkStatus::known) << "it is the world itself";
  EXPECT_EQ(status("arm"), LinkStatus::missing);
  EXPECT_EQ(
      explain("arm"),
      "transforms lead in a loop: arm -> base -> hand -> wrist -> arm, each to its parent; send "
      "one of these frames with another parent, or stop sending it");
  EXPECT_EQ(explain("hand"), explain("arm"));
}

/// base -> mount -> arm, and base below mount: the two ways from the arm to the base differ, and
/// their lengths by one loop, so both chains end in the same frame.
TEST_F(PoseReaderFaults, loopAboveALinkThatIsNotPartOfIt_isUnknown) {
  send("base", "mount", 10.0, 0.25);
  send("mount", "arm", 10.0, 0.25);
  send("mount", "base", 10.0, 3.0);
  read(10.0);
  EXPECT_EQ(status("arm"), LinkStatus::missing) << x("arm");
  EXPECT_EQ(explain("arm").find("transforms lead in a loop: base -> mount -> base, "), 0u)
      << explain("arm");
}

TEST_F(PoseReaderFaults, loopThatEnds_isForgotten) {
  sendArm(10.0, 0.5);
  send("hand", "base", 10.0, 0.5);
  read(10.0);
  ASSERT_EQ(status("hand"), LinkStatus::missing);
  send("map", "base", 10.1, 0.5);
  sendArm(10.1, 0.5);
  read(10.1);
  EXPECT_EQ(status("hand"), LinkStatus::known);
}

/// One wrong message kept the robot unknown until the monitor was started anew.
TEST_F(PoseReaderFaults, loopOfAMessageThatIsNotSentAgain_endsWhenItIsTooOld) {
  sendArm(10.0, 0.5);
  send("hand", "base", 10.0, 0.5);
  for (const double now : {10.0, 10.2, 10.4}) {
    sendArm(now, 0.5);
    read(now);
    EXPECT_EQ(status("hand"), LinkStatus::missing) << now;
  }
  sendArm(10.6, 0.75);
  read(10.6);
  EXPECT_EQ(status("hand"), LinkStatus::known);
  EXPECT_DOUBLE_EQ(x("arm"), 0.75);
  send("hand", "base", 10.6, 0.5);
  sendArm(10.7, 0.75);
  read(10.7);
  EXPECT_EQ(status("hand"), LinkStatus::missing) << "it is sent again";
}

/// Data of no part of the loop are believed for longer than all others.
TEST_F(PoseReaderFaults, loopOfWhichAllIsOld_isNoPose) {
  sendArm(10.0, 0.5);
  send("hand", "base", 10.1, 0.5);
  read(10.1);
  ASSERT_EQ(status("hand"), LinkStatus::missing);
  read(11.0);
  EXPECT_NE(status("arm"), LinkStatus::known);
  EXPECT_NE(status("hand"), LinkStatus::known);
}

TEST_F(PoseReaderFaults, twoTransformsWithOneStamp_linksAreUnknownAsLongAsAPoseIsBelieved) {
  sendArm(10.0, 0.5);
  store_.accept({transformAlongX("base", "arm", 10.0, 0.5)}, false, "/one");
  store_.accept({transformAlongX("base", "arm", 10.1, 0.5)}, false, "/one");
  store_.accept({transformAlongX("base", "arm", 10.1, 0.6)}, false, "/other");
  read(10.1);
  EXPECT_EQ(status("base"), LinkStatus::known);
  EXPECT_EQ(status("arm"), LinkStatus::contradicted);
  EXPECT_EQ(status("hand"), LinkStatus::contradicted);
  EXPECT_EQ(explain("hand"),
            "'/one' and '/other' send different transforms to 'arm' with one stamp");
  sendArm(10.5, 0.5);
  read(10.5);
  EXPECT_EQ(status("arm"), LinkStatus::contradicted) << "one of the two may only be late";
  sendArm(10.7, 0.5);
  read(10.7);
  EXPECT_EQ(status("arm"), LinkStatus::known);
}

}  // namespace
}  // namespace collision_monitor::test
