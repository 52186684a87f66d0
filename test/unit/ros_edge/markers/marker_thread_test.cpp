// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/markers/marker_thread.h"

#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <thread>

#include "unit/ros_edge/draw_markers.h"
#include "unit/ros_edge/edge_scene.h"

namespace collision_monitor::test {
namespace {

/// Waits for a drawing.
visualization_msgs::MarkerArray fetch(MarkerThread& markers) {
  visualization_msgs::MarkerArray array;
  for (int i = 0; i < 5000; ++i) {
    if (const PreparedMessage* drawn = markers.fetch()) {
      ros::serialization::deserializeMessage(drawn->bytes, array);
      return array;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  ADD_FAILURE() << "nothing is drawn";
  return array;
}

TEST(MarkerThread, drawsEachSnapshotOnce) {
  TransformStore store;
  const auto setup = slidingSetup();
  const auto near = judged(setup, store, slidingPoses(setup->setup.model, 0.0, -0.34));
  const auto far = judged(setup, store, slidingPoses(setup->setup.model, 0.0, 0.25));
  MarkerThread thread;
  EXPECT_EQ(thread.fetch(), nullptr);
  Markers markers(*setup);
  for (const Watch* watch : {near.get(), far.get()}) {
    EXPECT_TRUE(thread.draw(*watch));
    EXPECT_FALSE(thread.draw(*watch)) << "until the first is fetched";
    EXPECT_EQ(fetch(thread).markers, draw(markers, *watch).markers);
    EXPECT_EQ(thread.fetch(), nullptr);
  }
}

TEST(MarkerThread, anotherSetup_beginsAgainAndIsNotKept) {
  TransformStore store;
  MarkerThread thread;
  for (int i = 0; i < 2; ++i) {
    auto setup = slidingSetup();
    auto watch = judged(setup, store, slidingPoses(setup->setup.model, 0.0, 0.25));
    EXPECT_TRUE(thread.draw(*watch));
    EXPECT_EQ(fetch(thread).markers.front().action, visualization_msgs::Marker::DELETEALL);
    const std::weak_ptr<const MonitorSetup> ended = setup;
    watch.reset();
    setup.reset();
    EXPECT_TRUE(ended.expired());
  }
}

TEST(MarkerThread, endsWhileItDraws) {
  TransformStore store;
  const auto setup = slidingSetup();
  const auto watch = judged(setup, store, slidingPoses(setup->setup.model, 0.0, 0.25));
  for (int i = 0; i < 20; ++i) {
    MarkerThread thread;
    EXPECT_TRUE(thread.draw(*watch));
  }
}

}  // namespace
}  // namespace collision_monitor::test
