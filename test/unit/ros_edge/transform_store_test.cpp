// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/ros_edge/transform_store.h"

#include <gtest/gtest.h>
#include <tf2/exceptions.h>

#include "transform_along_x.h"

namespace collision_monitor::test {
namespace {

class TransformStoreTest : public testing::Test {
 protected:
  void send(const std::string& parent, const std::string& child, double stamp, double x) {
    store_.accept({transformAlongX(parent, child, stamp, x)}, false);
  }
  /// By tf2, with all that came of the frames whose records have these indices.
  double lookUp(const std::string& parent, const std::string& child, double stamp,
                const std::vector<std::size_t>& frames) const {
    return store_.bufferOf(frames)
        .lookupTransform(parent, child, ros::Time(stamp))
        .transform.translation.x;
  }

  ros::Time now_{100.0};
  TransformStore store_{[this] { return now_; }};
};

TEST_F(TransformStoreTest, buffer_interpolatesAllThatCame) {
  send("base", "arm", 1.0, 0.0);
  send("base", "arm", 2.0, 0.4);
  send("base", "arm", 3.0, 1.4);
  EXPECT_DOUBLE_EQ(lookUp("base", "arm", 1.5, {0}), 0.2);
  EXPECT_DOUBLE_EQ(lookUp("base", "arm", 2.5, {0}), 0.9);
  send("base", "arm", 4.0, 2.4);
  EXPECT_DOUBLE_EQ(lookUp("base", "arm", 3.5, {0}), 1.9) << "what came since it was last asked";
}

TEST_F(TransformStoreTest, buffer_isCompleteForTheFramesAskedFor) {
  for (const double stamp : {1.0, 2.0}) {
    send("base", "arm", stamp, stamp);
    send("arm", "hand", stamp, 10.0 * stamp);
  }
  EXPECT_DOUBLE_EQ(lookUp("base", "arm", 1.5, {0}), 1.5);
  EXPECT_DOUBLE_EQ(lookUp("base", "hand", 1.5, {0, 1}), 16.5);
}

TEST_F(TransformStoreTest, dataOlderThanTheHistory_areRefused) {
  send("base", "arm", 20.0, 2.0);
  send("base", "arm", 9.0, 0.9);
  EXPECT_THROW(lookUp("base", "arm", 15.0, {0}), tf2::ExtrapolationException);
  send("base", "arm", 11.0, 1.1);
  EXPECT_DOUBLE_EQ(lookUp("base", "arm", 15.5, {0}), 1.55);
}

TEST_F(TransformStoreTest, transformFarAheadOfNow_isRefusedAndHidesNothing) {
  send("base", "arm", 3700.0, 7.0);
  std::vector<FrameRecord> records;
  store_.copyRecords(records);
  EXPECT_EQ(records[0].parent, "");
  EXPECT_EQ(records[0].refused_ahead_ns, 3600'000'000'000);
  EXPECT_EQ(store_.refusedAhead(), 1U);
  send("base", "arm", 99.0, 0.9);
  send("base", "arm", 100.0, 1.0);
  store_.refreshRecords(records);
  EXPECT_EQ(records[0].refused_ahead_ns, 0);
  EXPECT_EQ(records[0].newest_ns, 100'000'000'000);
  EXPECT_DOUBLE_EQ(lookUp("base", "arm", 99.5, {0}), 0.95);
  send("base", "arm", 110.0, 2.0);
  store_.refreshRecords(records);
  EXPECT_EQ(records[0].newest_ns, 110'000'000'000) << "no farther ahead than the history is long";
}

TEST_F(TransformStoreTest, staticTransformFarAheadOfNow_isOfEveryTime) {
  store_.accept({transformAlongX("base", "arm", 3700.0, 7.0)}, true);
  EXPECT_DOUBLE_EQ(lookUp("base", "arm", 50.0, {0}), 7.0);
  EXPECT_EQ(store_.refusedAhead(), 0U);
}

TEST_F(TransformStoreTest, shortHistory_reachesToTheLastOneBeforeIt) {
  store_.keepFor(1.0);
  for (const double stamp : {1.0, 1.5, 4.1, 5.0}) {
    send("base", "arm", stamp, stamp);
  }
  EXPECT_NEAR(store_.gapAt(0, 2'000'000'000), 2.6, 1e-9);
  EXPECT_EQ(store_.gapAt(0, 1'200'000'000), 0.0);
  EXPECT_DOUBLE_EQ(lookUp("base", "arm", 2.0, {0}), 2.0);
  EXPECT_THROW(lookUp("base", "arm", 1.2, {0}), tf2::ExtrapolationException);
}

TEST_F(TransformStoreTest, sentAgain_theFirstCounts) {
  send("base", "arm", 1.0, 0.5);
  send("base", "arm", 1.0, 0.7);
  send("cart", "arm", 1.0, 0.9);
  std::vector<FrameRecord> records;
  store_.copyRecords(records);
  EXPECT_EQ(records[0].parent, "base");
  EXPECT_EQ(records[0].parent_from_frame.translation.x(), 0.5);
  EXPECT_DOUBLE_EQ(lookUp("base", "arm", 1.0, {0}), 0.5);
}

TEST_F(TransformStoreTest, frameThatChangesItsParent_wasAtTheFormerOne) {
  send("base", "gripper", 1.0, 0.1);
  send("base", "gripper", 2.0, 0.2);
  send("cart", "gripper", 3.0, 0.3);
  EXPECT_DOUBLE_EQ(lookUp("base", "gripper", 1.5, {0}), 0.15);
  EXPECT_DOUBLE_EQ(lookUp("cart", "gripper", 3.0, {0}), 0.3);
}

TEST_F(TransformStoreTest, gaps_areThoseBetweenAnyTwoStampsAndLateDataFillThem) {
  for (const double stamp : {1.0, 4.0, 4.1, 4.2}) {
    send("base", "arm", stamp, 0.0);
  }
  const auto gapAt = [&](double stamp) {
    return store_.gapAt(0, static_cast<std::int64_t>(ros::Time(stamp).toNSec()));
  };
  EXPECT_NEAR(gapAt(3.9), 3.0, 1e-9);
  EXPECT_NEAR(gapAt(4.15), 0.1, 1e-9);
  EXPECT_EQ(gapAt(4.0), 0.0) << "was received";
  EXPECT_EQ(gapAt(0.9), 0.0) << "before all";
  EXPECT_EQ(gapAt(4.3), 0.0) << "after all";
  send("base", "arm", 3.7, 0.0);
  EXPECT_NEAR(gapAt(3.9), 0.3, 1e-9);
  EXPECT_NEAR(gapAt(3.6), 2.7, 1e-9);
  send("base", "arm", 14.05, 0.0);
  EXPECT_EQ(gapAt(3.9), 0.0) << "of what is forgotten nothing is told";
  now_ = ros::Time(10.0);
  store_.readTime();
  EXPECT_EQ(gapAt(4.15), 0.0) << "before time jumped back";
}

TEST_F(TransformStoreTest, timeThatJumpsBack_forgetsWhatTheBufferHasNotYetSeen) {
  send("base", "arm", 50.0, 0.5);
  now_ = ros::Time(10.0);
  store_.readTime();
  send("base", "arm", 9.0, 0.9);
  EXPECT_THROW(lookUp("base", "arm", 20.0, {0}), tf2::ExtrapolationException);
  EXPECT_DOUBLE_EQ(lookUp("base", "arm", 9.0, {0}), 0.9);
}

}  // namespace
}  // namespace collision_monitor::test
