// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/poses/joint_reader.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "ros_edge/parameters/monitor_setup.h"
#include "support/robots/urdf_text.h"

namespace collision_monitor::test {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

sensor_msgs::JointState jointState(double stamp, const std::vector<std::string>& names,
                                   const std::vector<double>& positions,
                                   const std::vector<double>& velocities = {}) {
  sensor_msgs::JointState message;
  message.header.stamp = stamp > 0.0 ? ros::Time(stamp) : ros::Time();
  message.name = names;
  message.position = positions;
  message.velocity = velocities;
  return message;
}

/// Long after all stamps of these tests.
ros::Time late() { return ros::Time(1e6); }

TEST(JointStore, newestSampleStays) {
  JointStore store(&late);
  store.accept("t", jointState(2.0, {"a", "b"}, {0.1, 0.2}, {1.0}));
  store.accept("t", jointState(1.0, {"a"}, {0.7}, {7.0}));
  std::vector<NewestSample> samples;
  store.readNewest({{*store.find("t", "a"), false}, {*store.find("t", "b"), false}}, samples);
  EXPECT_EQ(samples[0].velocity, 1.0) << "an older message does not count";
  EXPECT_EQ(samples[1].position, 0.2);
  EXPECT_TRUE(std::isnan(samples[1].velocity)) << "velocity is shorter than name";
  EXPECT_FALSE(store.find("other", "a"));
  EXPECT_FALSE(store.find("t", "c"));
}

TEST(JointStore, messagesThatNameOtherJoints_keepToTheRecords) {
  JointStore store(&late);
  store.accept("t", jointState(1.0, {"a", "b"}, {0.1, 0.2}));
  store.accept("t", jointState(2.0, {"b", "c"}, {0.3, 0.4}));
  store.accept("other", jointState(3.0, {"b", "c"}, {0.8, 0.9}));
  store.accept("t", jointState(4.0, {"c", "a"}, {0.5, 0.6}));
  std::vector<NewestSample> samples;
  store.readNewest({{*store.find("t", "a")}, {*store.find("t", "b")}, {*store.find("t", "c")}},
                   samples);
  EXPECT_EQ(samples[0].position, 0.6);
  EXPECT_EQ(samples[1].position, 0.3);
  EXPECT_EQ(samples[2].position, 0.5);
  EXPECT_EQ(store.recordCount(), 5U);
}

TEST(JointStore, withoutStamp_isRefused) {
  JointStore store(&late);
  store.accept("t", jointState(0.0, {"a"}, {0.1}));
  EXPECT_EQ(store.recordCount(), 0U);
}

/// All that follow seemed older than one message of a wrong clock.
TEST(JointStore, sampleFarAheadOfNow_isRefusedAndHidesNothing) {
  ros::Time now(1000.0);
  JointStore store([&] { return now; });
  store.keepFor(2.0);
  store.accept("t", jointState(4600.0, {"a", "b"}, {7.0, 7.0}));
  const JointStore::Record a = *store.find("t", "a");
  EXPECT_EQ(store.refusedAhead(a).ahead_ns, 3600'000'000'000);
  EXPECT_EQ(store.refusedAhead(a).at_ns, 1000'000'000'000);
  store.accept("t", jointState(1000.0, {"a"}, {0.1}));
  EXPECT_EQ(store.refusedAhead(a).ahead_ns, 0);
  EXPECT_EQ(store.refusedAhead(*store.find("t", "b")).ahead_ns, 3600'000'000'000);
  std::vector<NewestSample> samples;
  store.readNewest({{a}, {*store.find("t", "b")}}, samples);
  EXPECT_EQ(samples[0].position, 0.1);
  EXPECT_EQ(samples[1].stamp_ns, 0) << "nothing else came of it";
  store.accept("t", jointState(1002.0, {"a"}, {0.2}));
  store.readNewest({{a}}, samples);
  EXPECT_EQ(samples[0].position, 0.2) << "no farther ahead than the history is long";
}

TEST(JointStore, messageOfBeforeAJumpThatComesAfterIt_hidesNothing) {
  ros::Time now(1004.0);
  JointStore store([&] { return now; });
  store.accept("t", jointState(1003.9, {"a"}, {0.1}));
  now = ros::Time(1.0);
  store.forget();
  store.accept("t", jointState(1004.0, {"a"}, {0.2}));
  store.accept("t", jointState(1.1, {"a"}, {0.3}));
  std::vector<NewestSample> samples;
  store.readNewest({{*store.find("t", "a")}}, samples);
  EXPECT_EQ(samples[0].position, 0.3);
}

TEST(JointStore, betweenTwoSamples_isTheStraightLine) {
  JointStore store(&late);
  store.accept("t", jointState(1.0, {"a"}, {0.0}, {1.0}));
  store.accept("t", jointState(1.4, {"a"}, {0.4}, {3.0}));
  store.accept("t", jointState(3.0, {"a"}, {9.0}));
  std::vector<JointSample> samples;
  const std::vector<JointStore::Wanted> a{{*store.find("t", "a"), false}};
  store.readAt(a, 1'100'000'000, 0.5, samples);
  EXPECT_NEAR(samples[0].position, 0.1, 1e-9);
  EXPECT_NEAR(samples[0].velocity, 1.5, 1e-9);
  store.readAt(a, 1'400'000'000, 0.5, samples);
  EXPECT_EQ(samples[0].position, 0.4) << "a stamp that was received is taken as it is";
  for (const std::int64_t stamp_ns : {900'000'000LL, 2'000'000'000LL, 3'100'000'000LL}) {
    store.readAt(a, stamp_ns, 0.5, samples);
    EXPECT_EQ(samples[0].stamp_ns, 0) << "before all, in a gap, after all: " << stamp_ns;
  }
}

TEST(JointStore, angleThatWraps_goesTheShorterWayRound) {
  JointStore store(&late);
  store.accept("t", jointState(1.0, {"a"}, {3.1}));
  store.accept("t", jointState(1.2, {"a"}, {-3.1}));
  std::vector<JointSample> samples;
  const JointStore::Record a = *store.find("t", "a");
  store.readAt({{a, true}, {a, false}}, 1'100'000'000, 0.5, samples);
  EXPECT_NEAR(samples[0].position, std::acos(-1.0), 1e-9);
  EXPECT_NEAR(samples[1].position, 0.0, 1e-9);
}

TEST(JointStore, longHistory_forgetsItsBeginning) {
  JointStore store(&late);
  store.keepFor(99.6);
  for (int i = 1; i <= 1000; ++i) {
    store.accept("t", jointState(i, {"a"}, {0.1 * i}));
  }
  std::vector<JointSample> samples;
  const std::vector<JointStore::Wanted> a{{*store.find("t", "a"), false}};
  store.readAt(a, 900'500'000'000, 2.0, samples);
  EXPECT_NEAR(samples[0].position, 90.05, 1e-9)
      << "between the last one before the history and the next";
  store.readAt(a, 899'000'000'000, 2.0, samples);
  EXPECT_EQ(samples[0].stamp_ns, 0);
  store.forget();
  std::vector<NewestSample> newest;
  store.readNewest(a, newest);
  EXPECT_EQ(newest[0].stamp_ns, 0);
}

TEST(JointStore, denseSamples_reachAsFarBackAsThoseOfTf) {
  JointStore store(&late);
  for (int i = 1; i <= 10000; ++i) {
    store.accept("t", jointState(100.0 + 1e-3 * i, {"a"}, {0.1 * i}));
  }
  std::vector<JointSample> samples;
  const std::vector<JointStore::Wanted> a{{*store.find("t", "a"), false}};
  store.readAt(a, 102'000'000'000, 0.5, samples);
  EXPECT_NEAR(samples[0].position, 200.0, 1e-9) << "eight seconds before the newest";
}

/// Two joints with a variable each and one that follows.
RobotDescription armDescription(const std::string& prefix) {
  const std::string limit = "<limit lower='-9' upper='9'/>";
  RobotDescription description = describeText(
      robotXml("<link name='base'/><link name='a'/><link name='b'/><link name='c'/>" +
               jointXml("turn", "continuous", "base", "a") +
               jointXml("slide", "prismatic", "a", "b", limit) +
               jointXml("follow", "prismatic", "b", "c", limit + "<mimic joint='slide'/>")));
  description.tf_prefix = prefix;
  return description;
}

class JointReaderTest : public testing::Test {
 protected:
  void build(const std::vector<std::string>& prefixes, const std::vector<std::string>& topics) {
    std::vector<RobotDescription> robots;
    for (const std::string& prefix : prefixes) {
      robots.push_back(armDescription(prefix));
    }
    SetupReport report;
    model_ = readRobots(robots, textLoader({}), report);
    ASSERT_TRUE(report.errors.empty());
    reader_ = std::make_unique<JointReader>(model_, store_, topics);
  }
  double velocityOf(const std::string& joint, double now = 10.0) {
    JointVelocities velocities(model_.variable_count);
    reader_->refresh();
    reader_->readVelocities(ros::Time(now), 0.5, velocities);
    return velocities[model_.joint(*model_.findJoint(joint)).first_variable];
  }

  JointStore store_{&late};
  RobotModel model_;
  std::unique_ptr<JointReader> reader_;
};

TEST_F(JointReaderTest, freshVelocitiesCount) {
  build({""}, {"t"});
  EXPECT_TRUE(std::isnan(velocityOf("turn"))) << "nothing came yet";
  store_.accept("t", jointState(9.8, {"turn", "slide"}, {0, 0}, {0.3, kNaN}));
  EXPECT_EQ(velocityOf("turn"), 0.3);
  EXPECT_TRUE(std::isnan(velocityOf("slide")));
  EXPECT_TRUE(std::isnan(velocityOf("turn", 10.4))) << "0.6 s old";
  store_.accept("t", jointState(9.9, {"turn", "slide"}, {0, 0}, {1e9, -1.1e9}));
  EXPECT_TRUE(std::isnan(velocityOf("slide"))) << "beyond all reason";
}

TEST_F(JointReaderTest, freshPositionsCount) {
  build({""}, {"t"});
  store_.accept("t", jointState(9.8, {"turn", "slide"}, {0.3, kNaN}));
  reader_->refresh();
  JointPositions positions(model_.variable_count);
  reader_->readNewestPositions(ros::Time(10.0), 0.5, positions);
  EXPECT_EQ(positions[0], 0.3);
  EXPECT_TRUE(std::isnan(positions[1]));
  reader_->readNewestPositions(ros::Time(10.4), 0.5, positions);
  EXPECT_TRUE(std::isnan(positions[0])) << "0.6 s old";
}

TEST_F(JointReaderTest, mimicJoint_followsItsSourceWhateverIsPublished) {
  build({""}, {"t"});
  store_.accept("t", jointState(9.9, {"slide", "follow"}, {0, 0}, {0.2, 7.0}));
  EXPECT_EQ(velocityOf("follow"), 0.2);
}

TEST_F(JointReaderTest, namesWithoutPrefix_onATopicOfItsOwn) {
  build({"left", "right"}, {"l", "r"});
  store_.accept("l", jointState(9.9, {"turn"}, {0}, {1.0}));
  store_.accept("r", jointState(9.9, {"turn"}, {0}, {2.0}));
  EXPECT_EQ(velocityOf("left/turn"), 1.0);
  EXPECT_EQ(velocityOf("right/turn"), 2.0);
}

TEST_F(JointReaderTest, namesOnASharedTopic_needTheirPrefix) {
  build({"left", "right"}, {"t", "t"});
  store_.accept("t", jointState(9.9, {"turn", "left/slide"}, {0, 0}, {1.0, 2.0}));
  EXPECT_TRUE(std::isnan(velocityOf("left/turn"))) << "whose it is nobody knows";
  EXPECT_EQ(velocityOf("left/slide"), 2.0);
  EXPECT_TRUE(std::isnan(velocityOf("right/slide")));
}

TEST(JointTopics, topicOfARobotGoesBeforeThatOfAll) {
  MonitorSetup setup;
  setup.setup.model.robots.resize(2);
  setup.parameters.robots.resize(2);
  setup.parameters.robots[1].joint_states = "/right/joint_states";
  EXPECT_EQ(jointTopics(setup), (std::vector<std::string>{"joint_states", "/right/joint_states"}));
  setup.listed = {{"left", RobotId{0}, "", false}, {"right", RobotId{1}, "", false}};
  setup.parameters.robots.insert(setup.parameters.robots.begin(), RobotSource());
  setup.parameters.robots[0].joint_states = "/late/joint_states";
  setup.listed.insert(setup.listed.begin(), {"late", std::nullopt, "no URDF", false});
  EXPECT_EQ(jointTopics(setup), (std::vector<std::string>{"joint_states", "/right/joint_states"}))
      << "one that is missing has none";
  setup.listed.clear();
  setup.parameters.robots.clear();
  EXPECT_EQ(jointTopics(setup), (std::vector<std::string>{"joint_states", "joint_states"}));
}

TEST_F(JointReaderTest, noTopic_noVelocities) {
  build({""}, {""});
  store_.accept("t", jointState(9.9, {"turn"}, {0}, {1.0}));
  EXPECT_TRUE(std::isnan(velocityOf("turn")));
}

TEST(JointStore, keepsOnlyWhatIsWanted) {
  JointStore store(&late);
  store.keepOnly("t", {"a"});
  store.accept("t", jointState(1.0, {"x", "a", "y"}, {0.7, 0.1, 0.8}));
  store.accept("other", jointState(1.0, {"a"}, {0.1}));
  EXPECT_EQ(store.recordCount(), 1U);
  ASSERT_TRUE(store.find("t", "a"));
  store.keepOnly("t", {"y"});
  store.accept("t", jointState(2.0, {"x", "a", "y"}, {0.7, 0.2, 0.8}));
  std::vector<NewestSample> samples;
  store.readNewest({{*store.find("t", "a"), false}, {*store.find("t", "y"), false}}, samples);
  EXPECT_EQ(samples[0].position, 0.2) << "what was told before is still wanted";
  EXPECT_EQ(samples[1].position, 0.8);
}

TEST(JointStore, messageOfMoreJointsThanAnyRobotHas_isRefusedAndCounted) {
  JointStore store(&late);
  store.keepOnly("t", {"a"});
  std::vector<std::string> names(10001, "x");
  names.back() = "a";
  store.accept("t", jointState(1.0, names, std::vector<double>(names.size(), 0.5)));
  EXPECT_EQ(store.recordCount(), 0U);
  EXPECT_EQ(store.refusedTooLong(), 1U);
}

TEST(JointStore, differentVelocitiesOfOneTime_noneIsBelieved) {
  JointStore store(&late);
  store.accept("t", jointState(1.0, {"a", "a"}, {0.1, 0.1}, {1.0, 2.0}));
  std::vector<NewestSample> samples;
  store.readNewest({{*store.find("t", "a"), false}}, samples);
  EXPECT_EQ(samples[0].position, 0.1);
  EXPECT_TRUE(std::isnan(samples[0].velocity));
  EXPECT_EQ(samples[0].contradiction.stamp_ns, 0);
}

}  // namespace
}  // namespace collision_monitor::test
