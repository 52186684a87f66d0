// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "ros_edge/poses/pose_reader.h"
#include "support/robots/urdf_text.h"
#include "transform_along_x.h"

namespace collision_monitor::test {
namespace {

const char* const kBox = "<box size='0.1 0.1 0.1'/>";

/// Along x: base -slide- cart -mount, 1 m- arm -reach- hand, and cart -follow- finger, which mimics
/// the slide: 2 slide + 0.5. The cart has no geometry.
class JointPosesTest : public testing::Test {
 protected:
  JointPosesTest()
      : model_(
            readText(robotXml(linkXml("base", kBox) + "<link name='cart'/>" + linkXml("arm", kBox) +
                              linkXml("hand", kBox) + linkXml("finger", kBox) +
                              slide("slide", "base", "cart") +
                              jointXml("mount", "fixed", "cart", "arm", "<origin xyz='1 0 0'/>") +
                              slide("reach", "arm", "hand") +
                              slide("follow", "cart", "finger",
                                    "<mimic joint='slide' multiplier='2' offset='0.5'/>")))
                .model),
        poses_(makeLinkPoses(model_)) {}

  static std::string slide(const char* name, const char* parent, const char* child,
                           const std::string& rest = "") {
    return jointXml(name, "prismatic", parent, child,
                    "<axis xyz='1 0 0'/><limit lower='-9' upper='9'/>" + rest);
  }
  void send(double stamp, const std::string& joint, double position) {
    sensor_msgs::JointState message;
    message.header.stamp = ros::Time(stamp);
    message.name = {joint};
    message.position = {position};
    joints_.accept("joint_states", message);
  }
  bool read(double now) {
    now_ = ros::Time(now);
    return reader_.read(now_, poses_);
  }
  std::size_t at(const std::string& link) const { return index(*model_.findLink(link)); }
  LinkStatus status(const std::string& link) const {
    return statusInWorld(poses_, *model_.findLink(link));
  }
  double x(const std::string& link) const {
    return poses_.world_from_link[at(link)].translation.x();
  }
  std::string explain(const std::string& link) const {
    return reader_.explain(*model_.findLink(link));
  }

  RobotModel model_;
  LinkPoses poses_;
  ros::Time now_{10.0};
  TransformStore store_{[this] { return now_; }};
  JointStore joints_{[this] { return now_; }};
  JointReader joint_reader_{model_, joints_, {"joint_states"}};
  PoseReader reader_{model_, store_, {}, &joint_reader_};
};

TEST_F(JointPosesTest, linksArePlacedByTheModel_mimicJointsToo) {
  send(10.0, "slide", 0.2);
  send(10.0, "reach", 0.3);
  EXPECT_TRUE(read(10.1));
  EXPECT_EQ(status("hand"), LinkStatus::known);
  EXPECT_NEAR(x("arm"), 1.2, 1e-12);
  EXPECT_NEAR(x("hand"), 1.5, 1e-12);
  EXPECT_NEAR(x("finger"), 1.1, 1e-12);
  EXPECT_EQ(poses_.stamp_ns, 10'000'000'000);
  EXPECT_NEAR(poses_.age[at("hand")], 0.1, 1e-9);
  EXPECT_FALSE(read(10.2)) << "no news";
}

TEST_F(JointPosesTest, severalPublishers_newestStampThatAllHave) {
  send(10.00, "slide", 0.0);
  send(10.02, "slide", 0.4);
  send(10.01, "reach", 0.3);
  read(10.03);
  EXPECT_EQ(poses_.stamp_ns, 10'010'000'000);
  EXPECT_NEAR(x("arm"), 1.2, 1e-6) << "half way";
  EXPECT_NEAR(x("hand"), 1.5, 1e-6);
}

TEST_F(JointPosesTest, jointThatNobodyPublishes_hidesWhatHangsOnIt) {
  send(10.0, "slide", 0.2);
  read(10.0);
  EXPECT_EQ(status("arm"), LinkStatus::known);
  EXPECT_EQ(status("finger"), LinkStatus::known);
  EXPECT_EQ(status("hand"), LinkStatus::missing);
  EXPECT_EQ(explain("hand"), "no state of joint 'reach' yet");
}

TEST_F(JointPosesTest, statesWithoutStamp_areRefusedAndTold) {
  send(10.0, "slide", 0.2);
  send(0.0, "slide", 0.3);
  send(0.0, "reach", 0.3);
  read(10.0);
  EXPECT_EQ(status("hand"), LinkStatus::missing);
  const std::string refused = "; refused for want of a stamp: 2 JointStates";
  EXPECT_EQ(explain("hand").find("no state of joint 'reach' yet" + refused), 0U);
  read(10.6);
  EXPECT_EQ(explain("finger").find("no state of joint 'slide' for 0.60 s" + refused), 0U);
}

TEST_F(JointPosesTest, oldJoint_isStaleAndHoldsNobodyBack) {
  send(10.0, "slide", 0.2);
  send(10.0, "reach", 0.3);
  send(10.6, "reach", 0.4);
  read(10.6);
  EXPECT_EQ(status("arm"), LinkStatus::stale);
  EXPECT_EQ(status("hand"), LinkStatus::stale);
  EXPECT_EQ(explain("hand"), "no state of joint 'slide' for 0.60 s");
  EXPECT_EQ(explain("finger"), "no state of joint 'slide' for 0.60 s");
  EXPECT_EQ(poses_.stamp_ns, 10'600'000'000);
}

TEST_F(JointPosesTest, stateFarAheadOfNow_isToldUntilAGoodOneComes) {
  read(10.0);
  send(10.0, "slide", 0.2);
  send(3610.0, "slide", 0.7);
  send(3610.0, "reach", 0.7);
  read(10.0);
  EXPECT_EQ(status("arm"), LinkStatus::known);
  EXPECT_EQ(status("hand"), LinkStatus::missing);
  const std::string clocks =
      " is 3600.00 s in the future; the clocks of two machines differ, or use_sim_time is set for "
      "one node only";
  EXPECT_EQ(explain("hand"), "the newest state of joint 'reach'" + clocks);
  read(10.6);
  EXPECT_EQ(status("arm"), LinkStatus::stale);
  EXPECT_EQ(explain("arm"), "the newest state of joint 'slide'" + clocks);
  send(10.6, "slide", 0.3);
  read(10.6);
  EXPECT_EQ(status("arm"), LinkStatus::known);
}

TEST_F(JointPosesTest, stateRefusedSomeTimeAgo_isNoLongerTheNewest) {
  read(10.0);
  send(10.0, "slide", 0.2);
  send(3610.0, "slide", 0.7);
  send(3610.0, "reach", 0.7);
  read(15.0);
  const std::string before =
      "; what came last, 5.00 s ago, was refused: it was 3600.00 s in the future";
  EXPECT_EQ(explain("arm"), "no state of joint 'slide' for 5.00 s" + before);
  send(15.0, "slide", 0.2);
  read(15.0);
  EXPECT_EQ(explain("hand"), "no state of joint 'reach' yet" + before);
}

TEST_F(JointPosesTest, nanPosition_isNotFiniteUntilAGoodOneComes) {
  send(10.0, "slide", 0.2);
  send(10.0, "reach", std::nan(""));
  read(10.0);
  EXPECT_EQ(status("hand"), LinkStatus::not_finite);
  EXPECT_EQ(explain("hand"),
            "the position of joint 'reach' is missing in its message, not finite or beyond 1e9");
  EXPECT_EQ(status("arm"), LinkStatus::known);
  send(10.1, "slide", 0.2);
  send(10.1, "reach", 0.3);
  read(10.1);
  EXPECT_EQ(status("hand"), LinkStatus::known);
}

TEST_F(JointPosesTest, positionFartherThanNumbersAreFine_isNotFinite) {
  for (const double position : {1.2e231, -1e17}) {
    send(10.0, "slide", 0.2);
    send(10.0, "reach", position);
    read(10.0);
    EXPECT_EQ(status("hand"), LinkStatus::not_finite) << position;
  }
  EXPECT_EQ(explain("hand"),
            "the position of joint 'reach' is missing in its message, not finite or beyond 1e9");
}

TEST_F(JointPosesTest, rootOfAMobileRobot_isPlacedByTf) {
  PoseReader reader(model_, store_, {"odom", 0.5}, &joint_reader_);
  send(10.0, "slide", 0.2);
  send(10.0, "reach", 0.3);
  reader.read(ros::Time(10.0), poses_);
  EXPECT_EQ(status("arm"), LinkStatus::missing) << "nothing joins odom and base";
  now_ = ros::Time(10.0);
  store_.accept({transformAlongX("odom", "base", 9.9, 5.0)}, false);
  store_.accept({transformAlongX("odom", "base", 10.0, 6.0)}, false);
  reader.read(ros::Time(10.0), poses_);
  EXPECT_NEAR(x("hand"), 7.5, 1e-9);
  EXPECT_EQ(poses_.stamp_ns, 10'000'000'000);
}

TEST_F(JointPosesTest, jointNamedTwiceWithDifferentPositions_linksAreUnknown) {
  sensor_msgs::JointState message;
  message.header.stamp = ros::Time(10.0);
  message.name = {"slide", "reach", "slide"};
  message.position = {0.2, 0.3, 0.2};
  joints_.accept("joint_states", message, "/driver");
  read(10.0);
  EXPECT_EQ(status("arm"), LinkStatus::known) << "the same position twice";
  message.header.stamp = ros::Time(10.1);
  message.position = {0.2, 0.3, 0.4};
  joints_.accept("joint_states", message, "/driver");
  read(10.1);
  EXPECT_EQ(status("base"), LinkStatus::known);
  for (const char* link : {"arm", "hand", "finger"}) {
    EXPECT_EQ(status(link), LinkStatus::contradicted) << link;
  }
  EXPECT_EQ(explain("finger"),
            "'/driver' sends different positions of joint 'slide' with one stamp");
  send(10.7, "slide", 0.2);
  send(10.7, "reach", 0.3);
  read(10.7);
  EXPECT_EQ(status("arm"), LinkStatus::known);
}

TEST_F(JointPosesTest, twoPublishersAndOneStamp_bothAreNamed) {
  sensor_msgs::JointState message;
  message.header.stamp = ros::Time(10.0);
  message.name = {"reach"};
  message.position = {0.3};
  send(10.0, "slide", 0.2);
  joints_.accept("joint_states", message, "/driver");
  message.position = {std::nan("")};
  joints_.accept("joint_states", message, "/simulator");
  read(10.0);
  EXPECT_EQ(status("arm"), LinkStatus::known);
  EXPECT_EQ(status("hand"), LinkStatus::contradicted);
  EXPECT_EQ(explain("hand"),
            "'/driver' and '/simulator' send different positions of joint 'reach' with one stamp");
}

}  // namespace
}  // namespace collision_monitor::test
