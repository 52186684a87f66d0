// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/robots/absence.h"

#include <gtest/gtest.h>

#include "unit/ros_edge/edge_scene.h"

namespace collision_monitor::test {
namespace {

/// The joints of the sliding robot: slide, reach and follow move, mast is fixed.
class Absence : public EdgeScene {
 protected:
  bool isAbsentNow() const { return isAbsent(setup_->setup.model, RobotId{0}, poses_); }
  void lose(const std::string& name) {
    floatFrom(index(linkNamed(setup_->setup.model, name)), LinkStatus::stale, poses_);
  }

  LinkPoses poses_ = slidingPoses(setup_->setup.model, 0.0, 0.0);
};

TEST_F(Absence, ofARobotThatIsKnown_isFalse) { EXPECT_FALSE(isAbsentNow()); }

TEST_F(Absence, ofARobotThatLostOneJoint_isFalse) {
  lose("tool");
  EXPECT_FALSE(isAbsentNow());
}

TEST_F(Absence, ofARobotThatLostEveryJoint_isTrueThoughItsBaseIsKnown) {
  for (const char* name : {"slider", "tool", "finger"}) {
    lose(name);
  }
  EXPECT_TRUE(isAbsentNow());
}

TEST_F(Absence, ofARobotWhoseRootAloneIsLost_isFalse) {
  lose("base");
  for (const char* name : {"slider", "tool", "finger"}) {
    poses_.part[index(linkNamed(setup_->setup.model, name))] =
        static_cast<PartId>(index(linkNamed(setup_->setup.model, "base")));
  }
  EXPECT_FALSE(isAbsentNow()) << "its joints are heard";
}

TEST_F(Absence, ofLinksThatWereNeverSeen_isTrue) {
  for (LinkStatus& status : poses_.status) {
    status = LinkStatus::missing;
  }
  EXPECT_TRUE(isAbsentNow());
}

TEST_F(Absence, ofARobotOfWhichFaultyPosesAreHeard_isFalse) {
  for (const LinkStatus fault : {LinkStatus::contradicted, LinkStatus::not_finite}) {
    for (const char* name : {"slider", "tool", "finger"}) {
      floatFrom(index(linkNamed(setup_->setup.model, name)), fault, poses_);
    }
    EXPECT_FALSE(isAbsentNow()) << "two publishers tell of it";
    for (LinkStatus& status : poses_.status) {
      status = fault;
    }
    EXPECT_FALSE(isAbsentNow());
  }
}

TEST_F(Absence, ofASilentRobotWhoseBaseIsContradicted_isFalse) {
  for (const char* name : {"slider", "tool", "finger"}) {
    lose(name);
  }
  floatFrom(index(linkNamed(setup_->setup.model, "base")), LinkStatus::contradicted, poses_);
  EXPECT_FALSE(isAbsentNow());
}

}  // namespace
}  // namespace collision_monitor::test
