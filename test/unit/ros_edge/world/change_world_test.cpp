// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <malloc.h>

#include <algorithm>
#include <map>
#include <utility>

#include "collision_monitor/model/kinematics.h"
#include "pipeline/world/add_world.h"
#include "ros_edge/world/convert_objects.h"
#include "ros_edge/world/world_places.h"
#include "support/robots/world_objects.h"
#include "unit/ros_edge/edge_scene.h"

namespace collision_monitor::test {
namespace {

/// The sliding robot beside objects, watched as by the node.
class ChangeWorld : public testing::Test {
 protected:
  ChangeWorld() {
    auto made = partsOf(*slidingSetup());
    made->robots = std::make_shared<CycleSetup>(withoutPairs(slidingSetup()->setup));
    made->setup = slidingSetup()->setup;
    setup_ = std::move(made);
    watch_ = std::make_unique<Watch>(setup_, store_, joints_);
    cycle();
  }

  void change(ChangeKind kind, const WorldObject& object) {
    SetupReport report;
    KnownPlaces places = placesOf(setup_->robots->model, setup_->world_frame);
    places.find_pose = [&](const std::string& parent, const std::string& child) {
      const RobotModel& model = setup_->robots->model;
      const std::vector<Pose> poses = defaultPoses(model);
      return inverse(poses[index(linkNamed(model, parent))]) *
             poses[index(linkNamed(model, child))];
    };
    const World world = applyChanges(setup_->world, {{kind, {object}, true}}, places, report);
    throwIfErrors(report);
    const std::shared_ptr<const MonitorSetup> next = changeWorld(*setup_, world, {});
    auto watch = std::make_unique<Watch>(next, store_, joints_);
    watch->planTakeOver(setup_);
    watch->prepare(ros::Time(12.5), ClockState());
    watch->takeOver(*watch_);
    watch_ = std::move(watch);
    setup_ = next;
    cycle();
  }

  /// All links of the robot known, and the objects where these carry them.
  void cycle() {
    const RobotModel& model = watch_->setup().model;
    LinkPoses poses = makeLinkPoses(model);
    std::fill(poses.status.begin(), poses.status.end(), LinkStatus::known);
    poses.world_from_link = defaultPoses(model);
    stamp_ns_ += 10'000'000;
    poses.stamp_ns = stamp_ns_;
    std::fill(poses.robot_stamp_ns.begin(), poses.robot_stamp_ns.end(), stamp_ns_);
    watch_->poses = std::move(poses);
    watch_->cycle();
  }

  /// Of pairs without this object.
  std::map<std::pair<std::string, std::string>, Verdict> verdictsWithout(
      const std::string& object) const {
    std::map<std::pair<std::string, std::string>, Verdict> verdicts;
    const CycleSetup& setup = watch_->setup();
    for (std::size_t i = 0; i < setup.checked.size(); ++i) {
      const std::string& a = setup.model.link(setup.checked[i].a).name;
      const std::string& b = setup.model.link(setup.checked[i].b).name;
      if (a != object && b != object) {
        verdicts[{a, b}] = watch_->buffers.events.verdicts[i];
      }
    }
    return verdicts;
  }

  TransformStore store_;
  JointStore joints_;
  std::shared_ptr<const MonitorSetup> setup_;
  std::unique_ptr<Watch> watch_;
  std::int64_t stamp_ns_{12'500'000'000};
};

std::size_t allocatedBytes() {
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

// `scripts/figures world` does it 10,000 times.
TEST_F(ChangeWorld, attachingAndDetachingManyTimes_takesNoMemoryAndChangesNoOtherVerdict) {
  change(ChangeKind::add, objectOf("post", Box{{0.1, 0.1, 0.1}}, at(0.65, 0, 0)));
  change(ChangeKind::add, objectOf("part", Sphere{0.05}, at(0.5, 0, 0.2)));
  const auto verdicts = verdictsWithout("part");
  ASSERT_TRUE(std::any_of(verdicts.begin(), verdicts.end(),
                          [](const auto& one) { return one.second == Verdict::contact; }));
  WorldObject held = attached(named("part"), "tool");
  held.frame_from_object = at(0, 0, 0.2);
  std::size_t before = 0;
  for (int i = 0; i < 300; ++i) {
    change(ChangeKind::attach, held);
    ASSERT_EQ(verdictsWithout("part"), verdicts);
    change(ChangeKind::detach, named("part"));
    ASSERT_EQ(verdictsWithout("part"), verdicts);
    before = i == 20 ? allocatedBytes() : before;
  }
  EXPECT_LT(allocatedBytes(), before + 100'000);
}

TEST_F(ChangeWorld, planForAnotherSetup_isMadeAnew) {
  const auto before = setup_;
  auto late = std::make_unique<Watch>(changeWorld(*before, World(), {}), store_, joints_);
  late->planTakeOver(before);
  EXPECT_TRUE(late->buffers.refine.skips_robots);
  late->prepare(ros::Time(12.5), ClockState());
  change(ChangeKind::add, objectOf("part", Sphere{0.05}, at(0.5, 0, 0.2)));
  late->takeOver(*watch_);
  EXPECT_FALSE(late->buffers.refine.skips_robots);
  EXPECT_EQ(late->carried.pair_to.size(), watch_->setup().checked.size());
}

TEST_F(ChangeWorld, linksThatTheFormerWatchKnewNot_areLearntInTheFirstCycle) {
  auto next = std::make_unique<Watch>(changeWorld(*setup_, World(), {}), store_, joints_);
  next->planTakeOver(setup_);
  next->joined_to.assign(next->joined_to.size(), kWorldPart);
  ASSERT_EQ(watch_->joined_to[0], kWorldPart);
  watch_->joined_to[1] = 1;  // not joined
  next->takeOver(*watch_);
  EXPECT_EQ(next->joined_to[0], kWorldPart);
  EXPECT_EQ(next->joined_to[1], 1U);
}

TEST(ReadObjects, moreThanAreAccepted_areRefusedUnread) {
  SceneChange change;
  change.objects.resize(kMostObjects + 1);
  SetupReport report;
  const std::vector<ObjectChange> changes = fromMessages({change}, {{}, {}}, report);
  EXPECT_TRUE(changes.empty());
  EXPECT_EQ(textsOf(report.errors),
            (std::vector<std::string>{"change 1 (add): 20001 objects; accepted: at most 20000"}));
}

}  // namespace
}  // namespace collision_monitor::test
