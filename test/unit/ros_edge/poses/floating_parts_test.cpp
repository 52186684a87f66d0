// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/poses/floating_parts.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "pipeline/cycle/run_cycle.h"
#include "ros_edge/markers/markers.h"
#include "ros_edge/outputs/distance_list.h"
#include "ros_edge/outputs/sentences.h"
#include "transform_along_x.h"
#include "unit/ros_edge/draw_markers.h"
#include "unit/ros_edge/edge_scene.h"

namespace collision_monitor::test {
namespace {

/// All pairs are in contact at 0.9 m, so that something can be seen of every pair.
SetupOptions wideLimits() {
  SetupOptions options;
  options.limits.contact_distance = 0.9;
  options.limits.warning_distance = options.limits.report_distance = 1.0;
  return options;
}

/// The sliding robot, of which tf tells only what is named, everything at x = 0.
class FloatingPartsTest : public EdgeScene {
 protected:
  FloatingPartsTest() { ros::Time::init(); }

  void send(const std::string& parent, const std::string& child) {
    store_.accept({transformAlongX(parent, child, 0.0, 0.0)}, true);
  }
  void sendSlider() {
    send("slider", "tool");
    send("slider", "finger");
  }
  void seeFrom(const std::string& world_frame, const SetupOptions& options = SetupOptions()) {
    auto made = std::make_shared<MonitorSetup>(*slidingSetup(options));
    made->world_frame = world_frame;
    setup_ = made;
  }
  std::unique_ptr<Watch> watchNow() {
    static const JointStore no_joint_states;
    auto watch = std::make_unique<Watch>(setup_, store_, no_joint_states);
    watch->read(ros::Time(13.0), ClockState());
    runCycle(watch->setup(), watch->poses, watch->buffers);
    return watch;
  }
};

TEST_F(FloatingPartsTest, partOfARobot_isNamedAndItsOwnPairsAreJudged) {
  sendSlider();
  const auto watch = watchNow();
  const State state = stateOf(*watch, facts());
  EXPECT_EQ(state.level, State::CONTACT) << "tool and finger stand at one place";
  EXPECT_EQ(state.sentence, "tool overlaps finger by 200 mm");
  EXPECT_EQ(state.unknown_links, (std::vector<std::string>{"tool (missing)", "finger (missing)"}));
  EXPECT_EQ(state.closest.frame_id, "slider");
  EXPECT_EQ(state.header.frame_id, "base");
  EXPECT_EQ(state.pairs_unknown, 2U);
  EXPECT_EQ(state.speed_scale, 0.0);
}

TEST_F(FloatingPartsTest, nothingTouches_theSentenceSaysWhatFloats) {
  send("slider", "tool");
  auto finger = transformAlongX("slider", "finger", 0.0, 0.5);
  store_.accept({finger}, true);
  const State state = stateOf(*watchNow(), facts());
  EXPECT_EQ(state.level, State::UNKNOWN);
  EXPECT_EQ(state.sentence,
            "the part of robot 'r' from link 'slider' on floats: no transform from 'base' to "
            "'slider' yet; its 1 own pair is checked, 2 pairs with others are unknown");
  EXPECT_NEAR(state.closest.distance, 0.3, 1e-12);
}

TEST_F(FloatingPartsTest, linkAlone_isUnknownAsEver) {
  send("base", "slider");
  store_.accept({transformAlongX("slider", "finger", 0.0, 0.5)}, true);
  const State state = stateOf(*watchNow(), facts());
  EXPECT_EQ(state.level, State::UNKNOWN);
  EXPECT_EQ(state.sentence, "link tool is unknown: no transform from 'slider' to 'tool' yet");
  EXPECT_EQ(state.unknown_links, std::vector<std::string>{"tool (missing)"});
}

TEST_F(FloatingPartsTest, robotThatFloatsAsAWhole_isNoReasonForUnknown) {
  seeFrom("map");
  send("base", "slider");
  store_.accept({transformAlongX("slider", "tool", 0.0, 0.5)}, true);
  store_.accept({transformAlongX("slider", "finger", 0.0, -0.5)}, true);
  const auto watch = watchNow();
  const State state = stateOf(*watch, facts());
  EXPECT_EQ(state.level, State::OK);
  EXPECT_EQ(state.sentence, "clear; base is 300 mm from tool");
  EXPECT_TRUE(state.unknown_links.empty());
  EXPECT_EQ(state.pairs_unknown, 0U);
  EXPECT_EQ(state.closest.frame_id, "base");
  EXPECT_EQ(state.header.frame_id, "map");
}

TEST_F(FloatingPartsTest, robotThatFloatsWithAPartOfItLost_onlyThatPartIsUnknown) {
  seeFrom("map");
  send("base", "slider");
  store_.accept({transformAlongX("slider", "finger", 0.0, 0.5)}, true);
  const State state = stateOf(*watchNow(), facts());
  EXPECT_EQ(state.level, State::UNKNOWN);
  EXPECT_EQ(state.unknown_links, std::vector<std::string>{"tool (missing)"});
  EXPECT_EQ(state.sentence, "link tool is unknown: no transform from 'slider' to 'tool' yet");
}

// Where one robot's root stands is of no matter to its pairs, so it is not to blame.
TEST_F(FloatingPartsTest, robotThatFloatsWithAPartThatFloatsInIt_theInnerOneIsTold) {
  seeFrom("map");
  send("slider", "tool");
  store_.accept({transformAlongX("slider", "finger", 0.0, 0.5)}, true);
  const State state = stateOf(*watchNow(), facts());
  EXPECT_EQ(state.level, State::UNKNOWN);
  EXPECT_EQ(state.unknown_links, (std::vector<std::string>{"tool (missing)", "finger (missing)"}));
  EXPECT_EQ(state.sentence,
            "the part of robot 'r' from link 'slider' on floats: no transform from 'base' to "
            "'slider' yet; its 1 own pair is checked, 2 pairs with others are unknown");
}

TEST_F(FloatingPartsTest, nothingIsKnown_oneLinkSpeaksForAll) {
  seeFrom("map");
  const State state = stateOf(*watchNow(), facts());
  EXPECT_EQ(state.level, State::UNKNOWN);
  EXPECT_EQ(state.unknown_links, (std::vector<std::string>{"tool (missing)", "finger (missing)"}));
  EXPECT_EQ(state.sentence,
            "link tool is unknown: no transform from 'base' to 'slider' yet (and 1 more link)");
}

TEST_F(FloatingPartsTest, pairThatComesToBeUnknown_namesTheLinkThatFloats) {
  const auto watch = this->watchAt(-0.28);
  floatSlider(setup_->setup.model, watch->poses);
  runCycle(watch->setup(), watch->poses, watch->buffers);
  ASSERT_EQ(watch->buffers.events.changes.size(), 1U);
  const std::string sentence = changeSentence(*watch, watch->buffers.events.changes[0]);
  EXPECT_EQ(sentence.rfind("link tool is unknown: ", 0), 0U) << sentence;
  EXPECT_NE(sentence.find(", near base before"), std::string::npos) << sentence;
}

TEST_F(FloatingPartsTest, messages_nameTheFrameOfTheirPoints) {
  seeFrom("base", wideLimits());
  sendSlider();
  const auto watch = watchNow();
  Contacts contacts;
  toMessage(*watch, contacts);
  ASSERT_EQ(contacts.contacts.size(), 1U);
  EXPECT_EQ(contacts.header.frame_id, "base");
  EXPECT_EQ(contacts.contacts[0].frame_id, "slider");
  DistanceList list;
  const Distances& distances = list.fill(*watch);
  ASSERT_EQ(distances.pairs.size(), 1U);
  EXPECT_EQ(distances.pairs[0].frame_id, "slider");
  EXPECT_EQ(distances.pairs_unknown, 2U);
  const auto placed = judged(setup_, store_, slidingPoses(setup_->setup.model, 0.0, 0.0));
  toMessage(*placed, contacts);
  ASSERT_EQ(contacts.contacts.size(), 3U);
  EXPECT_TRUE(std::all_of(contacts.contacts.begin(), contacts.contacts.end(),
                          [](const Contact& contact) { return contact.frame_id == "base"; }));
}

TEST_F(FloatingPartsTest, markers_standInTheFrameOfTheirPart) {
  seeFrom("base", wideLimits());
  const auto watch = judged(setup_, store_, slidingPoses(setup_->setup.model, 0.0, 0.0));
  floatSlider(setup_->setup.model, watch->poses);
  runCycle(watch->setup(), watch->poses, watch->buffers);
  Markers markers(*watch->fixed);
  std::size_t floating = 0;
  for (const auto& marker : draw(markers, *watch).markers) {
    // The base is drawn where it was seen, the rest as seen from the slider, whenever that was.
    const bool floats = marker.ns != "shapes" || marker.id != 0;
    if (marker.action == visualization_msgs::Marker::ADD && floats) {
      EXPECT_EQ(marker.header.frame_id, "slider") << marker.ns << marker.id;
      EXPECT_TRUE(marker.header.stamp.isZero()) << marker.ns << marker.id;
      ++floating;
    } else if (marker.action == visualization_msgs::Marker::ADD) {
      EXPECT_EQ(marker.header.frame_id, "base");
      EXPECT_EQ(marker.header.stamp, ros::Time(12.5));
    }
  }
  EXPECT_EQ(floating, 3U + 3U + 1U + 2U) << "shapes, contact of two points, distance, label";
}

}  // namespace
}  // namespace collision_monitor::test
