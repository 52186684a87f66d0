// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/outputs/sentences.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <limits>

#include "unit/ros_edge/world_scene.h"

namespace collision_monitor::test {
namespace {

TEST(FixedText, isWhatPrintfSays) {
  for (const double value :
       {0.0, -0.0, 0.125, 2.5, 0.05, 9.995, -1.25, 1234.5678, 1e22, 5e-324,
        std::numeric_limits<double>::max(), std::numeric_limits<double>::infinity()}) {
    for (const int decimals : {0, 1, 2, 3}) {
      char expected[400];
      std::snprintf(expected, sizeof expected, "%.*f", decimals, value);
      EXPECT_EQ(fixedText(value, decimals), expected) << decimals;
    }
  }
}

TEST(LengthText, changesItsUnitWhereItWouldRoundUp) {
  EXPECT_EQ(lengthText(0.0), "0.0 mm");
  EXPECT_EQ(lengthText(-0.00994), "9.9 mm");
  EXPECT_EQ(lengthText(0.00996), "10 mm");
  EXPECT_EQ(lengthText(0.9994), "999 mm");
  EXPECT_EQ(lengthText(0.9996), "1.00 m");
  EXPECT_EQ(lengthText(12.345), "12.35 m");
}

using SentencesTest = EdgeScene;

// As the log says it: who waits for a clock must not look for a transform.
TEST_F(SentencesTest, beforeTheClockStarts_itIsTheReasonOfEachLink) {
  const auto watch = watchAt(0.0);
  watch->read(ros::Time(), ClockState());
  EXPECT_EQ(unknownSentence(*watch, linkNamed(setup_->setup.model, "tool")),
            "link tool is unknown: no time on /clock yet");
}

TEST_F(SentencesTest, ofAnObject_callItOne) {
  setup_ = slidingSetupWith({objectOf("table", Box{{0.1, 0.1, 0.1}}, at(0.0, 0.0, 0.212))});
  const auto near = watchAt(0.5);
  EXPECT_EQ(stateOf(*near, facts()).sentence, "base is 12 mm from object table");
  LinkPoses poses = slidingPoses(setup_->setup.model, 0.0, 0.5);
  poses.status[index(linkNamed(setup_->setup.model, "table"))] = LinkStatus::missing;
  const auto lost = judged(setup_, store_, poses);
  LinkPoses unused = makeLinkPoses(setup_->setup.model);
  lost->reader.read(ros::Time(13.0), unused);  // it explains what it has read
  const State state = stateOf(*lost, facts());
  EXPECT_EQ(state.sentence.rfind("object table is unknown: ", 0), 0U) << state.sentence;
  EXPECT_EQ(state.unknown_links, std::vector<std::string>{"object table (missing)"});
}

/// What carries an object has no geometry; it is the object that is missed.
TEST_F(SentencesTest, ofAFrameThatCarriesObjects_nameTheObject) {
  WorldObject crate = objectOf("crate", Box{{0.1, 0.1, 0.1}}, at(0.0, 0.0, 3.0));
  crate.frame = "conveyor";
  setup_ = slidingSetupWith({crate});
  LinkPoses poses = slidingPoses(setup_->setup.model, 0.0, 0.5);
  const RobotModel& model = setup_->setup.model;
  const Joint& joint = model.joint(*model.link(linkNamed(model, "crate")).parent_joint);
  const std::size_t carrier = index(joint.parent);
  floatFrom(carrier, LinkStatus::missing, poses);
  poses.part[index(linkNamed(setup_->setup.model, "crate"))] = static_cast<PartId>(carrier);
  const auto lost = judged(setup_, store_, poses);
  LinkPoses unused = makeLinkPoses(setup_->setup.model);
  lost->reader.read(ros::Time(13.0), unused);
  const State state = stateOf(*lost, facts());
  EXPECT_EQ(state.sentence.rfind("object crate is unknown: ", 0), 0U) << state.sentence;
}

}  // namespace
}  // namespace collision_monitor::test
