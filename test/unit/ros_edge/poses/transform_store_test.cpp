// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/poses/transform_store.h"

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
  EXPECT_EQ(records[0].refusal.ahead_ns, 3600'000'000'000);
  EXPECT_EQ(store_.refusedAhead().count, 1U);
  send("base", "arm", 99.0, 0.9);
  send("base", "arm", 100.0, 1.0);
  store_.refreshRecords(records);
  EXPECT_EQ(records[0].refusal.ahead_ns, 0);
  EXPECT_EQ(records[0].newest_ns, 100'000'000'000);
  EXPECT_DOUBLE_EQ(lookUp("base", "arm", 99.5, {0}), 0.95);
  send("base", "arm", 110.0, 2.0);
  store_.refreshRecords(records);
  EXPECT_EQ(records[0].newest_ns, 110'000'000'000) << "no farther ahead than the history is long";
}

TEST_F(TransformStoreTest, staticTransformFarAheadOfNow_isOfEveryTime) {
  store_.accept({transformAlongX("base", "arm", 3700.0, 7.0)}, true);
  EXPECT_DOUBLE_EQ(lookUp("base", "arm", 50.0, {0}), 7.0);
  EXPECT_EQ(store_.refusedAhead().count, 0U);
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

class KeepOnlyTest : public TransformStoreTest {
 protected:
  void sendStatic(const std::string& parent, const std::string& child, double x) {
    store_.accept({transformAlongX(parent, child, 0.0, x)}, true);
  }
  std::vector<std::string> kept() const {
    std::vector<FrameRecord> records;
    store_.copyRecords(records);
    std::vector<std::string> names;
    for (const FrameRecord& record : records) {
      names.push_back(record.name);
    }
    return names;
  }
  static geometry_msgs::TransformStamped other(std::size_t number) {
    return transformAlongX("elsewhere", "other_" + std::to_string(number), 50.0, 1.0);
  }

  using Names = std::vector<std::string>;
};

TEST_F(KeepOnlyTest, whatIsAboveIsKept_whatIsBesideIsNot) {
  store_.keepOnly({"/hand"});
  send("arm", "hand", 50.0, 1.0);
  send("base", "arm", 50.0, 1.0);
  send("base", "camera", 50.0, 1.0);
  EXPECT_EQ(kept(), (Names{"hand", "arm"}));
  send("map", "base", 51.0, 1.0);
  EXPECT_EQ(kept(), (Names{"hand", "arm", "base"}));
}

TEST_F(KeepOnlyTest, staticTransformsThatCameTooEarly_areKeptOnceTheyAreWanted) {
  store_.keepOnly({"hand"});
  sendStatic("map", "base", 4.0);
  sendStatic("base", "arm", 2.0);
  EXPECT_EQ(kept(), Names{});
  send("arm", "hand", 50.0, 1.0);
  EXPECT_EQ(kept(), (Names{"hand", "arm", "base"}));
  EXPECT_DOUBLE_EQ(lookUp("map", "hand", 50.0, {0}), 7.0);
  sendStatic("shelf", "box", 8.0);
  store_.keepOnly({"box"});
  EXPECT_EQ(kept().back(), "box");
}

TEST_F(KeepOnlyTest, messageOfMoreTransformsThanAnyRobotHas_isRefusedAndCounted) {
  store_.keepOnly({"hand"});
  std::vector<geometry_msgs::TransformStamped> many{transformAlongX("arm", "hand", 50.0, 1.0)};
  for (std::size_t i = 0; i < 10000; ++i) {
    many.push_back(other(i));
  }
  store_.accept(many, false);
  EXPECT_EQ(kept(), Names{});
  EXPECT_EQ(store_.refusedTooMany(), 1U);
  many.pop_back();
  store_.accept(many, false);
  EXPECT_EQ(kept(), Names{"hand"});
}

TEST_F(KeepOnlyTest, floodOfFrames_isLimitedAndCounted) {
  store_.keepOnly({"hand"});
  for (std::size_t i = 0; i < 10100; ++i) {
    store_.accept({other(i)}, true);
  }
  EXPECT_EQ(kept(), Names{});
  EXPECT_EQ(store_.refusedTooMany(), 100U) << "static ones wait in case they are above the hand";
  for (std::size_t i = 0; i < 10100; ++i) {
    send("parent_" + std::to_string(i), "hand", 50.0 + 1e-3 * static_cast<double>(i), 1.0);
  }
  EXPECT_EQ(store_.refusedTooMany(), 200U);
}

class ContradictionTest : public TransformStoreTest {
 protected:
  void sendBy(const std::string& publisher, double stamp, double x) {
    store_.accept({transformAlongX("base", "arm", stamp, x)}, false, publisher);
  }
  Contradiction last() const {
    std::vector<FrameRecord> records;
    store_.copyRecords(records);
    return records.at(0).contradiction;
  }
  std::string nameOf(PublisherId id) const { return store_.publisher(id); }
};

TEST_F(ContradictionTest, twoTransformsWithOneStamp_bothPublishersAreNamed) {
  sendBy("/one", 50.0, 1.0);
  sendBy("/other", 50.0, 1.0);
  EXPECT_EQ(last().stamp_ns, 0) << "the same twice is no contradiction";
  sendBy("/other", 50.0, 1.1);
  EXPECT_EQ(last().stamp_ns, 50'000'000'000);
  EXPECT_EQ(nameOf(last().first), "/one");
  EXPECT_EQ(nameOf(last().second), "/other");
}

TEST_F(ContradictionTest, otherParentWithOneStamp_isOne) {
  sendBy("/one", 50.0, 1.0);
  store_.accept({transformAlongX("world", "arm", 50.0, 1.0)}, false, "/other");
  EXPECT_EQ(last().stamp_ns, 50'000'000'000);
}

TEST_F(ContradictionTest, ofAStampThatIsNotTheNewest_isOneToo) {
  sendBy("/one", 50.0, 1.0);
  sendBy("/one", 51.0, 2.0);
  sendBy("/other", 50.0, 1.0);
  EXPECT_EQ(last().stamp_ns, 0);
  sendBy("/other", 50.0, 1.5);
  EXPECT_EQ(last().stamp_ns, 50'000'000'000);
  lookUp("base", "arm", 50.5, {0});  // from here on tf2's buffer holds them
  sendBy("/other", 51.0, 2.5);
  EXPECT_EQ(last().stamp_ns, 51'000'000'000);
}

TEST_F(ContradictionTest, publishersUnderEverNewNames_areNotKeptForEver) {
  for (int i = 0; i < 2000; ++i) {
    sendBy("/anonymous_" + std::to_string(i), 50.0 + 0.01 * i, 1.0);
  }
  sendBy("/late", 50.0 + 0.01 * 1999, 2.0);
  EXPECT_EQ(nameOf(last().second), "") << "no name, and no fault";
}

TEST_F(TransformStoreTest, laterData_areCountedAlsoWhereTheyAreRefused) {
  send("base", "arm", 50.0, 1.0);
  const std::uint64_t before = store_.version().later;
  send("base", "arm", 50.0, 1.0);
  send("base", "arm", 49.0, 1.0);
  EXPECT_EQ(store_.version().later, before);
  send("base", "arm", 3700.0, 1.0);
  EXPECT_EQ(store_.version().later, before + 1);
}

}  // namespace
}  // namespace collision_monitor::test
