// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/watch.h"

#include <gtest/gtest.h>

#include "support/robots/balls_in_a_hollow.h"

namespace collision_monitor::test {
namespace {

/// More pairs than one cycle refines come near at once.
class WatchTest : public testing::Test {
 protected:
  WatchTest() {
    auto made = std::make_shared<MonitorSetup>();
    made->setup = ballsInAHollow(60);
    watch_ = std::make_unique<Watch>(made, transforms_, joint_states_);
    watch_->poses = posesInAHollow(made->setup);
  }

  void expectGeometriesJudge() {
    watch_->cycle();
    EXPECT_EQ(watch_->buffers.counters.left, 0U);
    EXPECT_NE(watch_->buffers.events.overall, Verdict::contact) << "of enclosing shapes";
  }

  TransformStore transforms_;
  JointStore joint_states_;
  std::unique_ptr<Watch> watch_;
};

TEST_F(WatchTest, linksComeToBeKnown_theFirstVerdictIsOfTheGeometries) {
  std::vector<LinkStatus>& status = watch_->poses.status;
  status.assign(status.size(), LinkStatus::missing);
  watch_->cycle();
  status.assign(status.size(), LinkStatus::known);
  expectGeometriesJudge();
}

TEST_F(WatchTest, floatingPartsAreJoined_theFirstVerdictIsOfTheGeometries) {
  std::vector<PartId>& part = watch_->poses.part;
  for (std::size_t link = 0; link < part.size(); ++link) {
    part[link] = static_cast<PartId>(link);
  }
  watch_->cycle();
  part.assign(part.size(), kWorldPart);
  expectGeometriesJudge();
}

TEST_F(WatchTest, partsAreJoinedFarFromTheWorld_theFirstVerdictIsOfTheGeometries) {
  std::vector<PartId>& part = watch_->poses.part;
  for (std::size_t link = 0; link < part.size(); ++link) {
    part[link] = static_cast<PartId>(link);
  }
  watch_->cycle();
  part.assign(part.size(), 0);
  expectGeometriesJudge();
}

TEST_F(WatchTest, linksAreLostAsOthersComeToBeKnown_theFirstVerdictIsOfTheGeometries) {
  std::vector<LinkStatus>& status = watch_->poses.status;
  for (std::size_t link = 1; link < status.size(); ++link) {
    status[link] = link <= 6 ? LinkStatus::known : LinkStatus::missing;
  }
  watch_->cycle();
  for (std::size_t link = 1; link < status.size(); ++link) {
    status[link] = link <= 6 ? LinkStatus::stale : LinkStatus::known;
  }
  expectGeometriesJudge();
}

}  // namespace
}  // namespace collision_monitor::test
