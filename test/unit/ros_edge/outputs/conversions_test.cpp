// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/outputs/conversions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "collision_monitor/geometry/ids.h"
#include "pipeline/cycle/run_cycle.h"
#include "ros_edge/outputs/distance_list.h"
#include "ros_edge/outputs/sentences.h"
#include "unit/ros_edge/edge_scene.h"

namespace collision_monitor::test {
namespace {

class ConversionsTest : public EdgeScene {
 protected:
  /// The tool goes along x at `speed` [m/s], all else stands still.
  std::unique_ptr<Watch> watchMoving(double reach, double speed) {
    LinkPoses poses = slidingPoses(setup_->setup.model, 0.0, reach);
    std::fill(poses.velocities.known.begin(), poses.velocities.known.end(), 1);
    poses.velocities.of_link[index(linkNamed(setup_->setup.model, "tool"))].linear.x() = speed;
    return judged(setup_, store_, poses);
  }
  std::unique_ptr<Watch> watchWithout(const std::string& link) {
    LinkPoses poses = slidingPoses(setup_->setup.model, 0.0, -0.4);
    poses.status[index(linkNamed(setup_->setup.model, link))] = LinkStatus::missing;
    return judged(setup_, store_, poses);
  }
};

TEST_F(ConversionsTest, clearState) {
  const State state = stateOf(*watchAt(0.25), facts());
  EXPECT_EQ(state.level, State::OK);
  EXPECT_EQ(state.sentence, "clear; base is 550 mm from tool");
  EXPECT_EQ(state.header.stamp, ros::Time(12.5));
  EXPECT_TRUE(state.has_closest);
  EXPECT_NEAR(state.closest.distance, 0.55, 1e-12);
  EXPECT_EQ(state.closest.shape_a, "collision_0/box");
  EXPECT_TRUE(state.unknown_links.empty());
  EXPECT_TRUE(std::isnan(state.time_to_contact)) << "no velocity is known";
  EXPECT_EQ(state.speed_scale, 1.0);
}

TEST_F(ConversionsTest, closingPair_sentenceTimeAndScale) {
  const auto watch = watchMoving(-0.26, -0.2);
  const State state = stateOf(*watch, facts());
  EXPECT_EQ(state.sentence, "base is 40 mm from tool, closing at 0.20 m/s, contact in 0.20 s");
  EXPECT_NEAR(state.closest.closing_speed, 0.2, 1e-12);
  EXPECT_NEAR(state.closest.time_to_contact, 0.2, 1e-12);
  EXPECT_NEAR(state.time_to_contact, 0.2, 1e-12);
  EXPECT_NEAR(state.speed_scale, 0.6, 1e-12) << "30 mm to stop_distance, at 0.12 m/s in 0.25 s";
}

TEST_F(ConversionsTest, partingPair_isFree) {
  const State state = stateOf(*watchMoving(-0.26, 0.2), facts());
  EXPECT_EQ(state.sentence, "base is 40 mm from tool, moving apart at 0.20 m/s");
  EXPECT_EQ(state.closest.time_to_contact, std::numeric_limits<double>::infinity());
  EXPECT_EQ(state.speed_scale, 1.0);
}

TEST_F(ConversionsTest, overlappingPair_goesDeeperOrApart) {
  EXPECT_EQ(stateOf(*watchMoving(-0.303, -0.2), facts()).sentence,
            "base overlaps tool by 3.0 mm, going deeper at 0.20 m/s");
  EXPECT_EQ(stateOf(*watchMoving(-0.303, 0.2), facts()).sentence,
            "base overlaps tool by 3.0 mm, moving apart at 0.20 m/s");
  EXPECT_EQ(stateOf(*watchMoving(-0.303, 0.2), facts()).speed_scale, 1.0);
}

TEST_F(ConversionsTest, fastPairThatIsFar_warnsByItsTime) {
  const auto watch = watchMoving(-0.15, -3.0);
  EXPECT_EQ(stateOf(*watch, facts()).level, State::WARNING);
  ASSERT_EQ(watch->buffers.events.changes.size(), 1U);
  PairWarning warning;
  toMessage(*watch, watch->buffers.events.changes[0], warning);
  EXPECT_EQ(warning.sentence, "base is 150 mm from tool, closing at 3.00 m/s, contact in 0.05 s");
}

TEST_F(ConversionsTest, lowerBound_contactIsNotEarlier) {
  const auto watch = watchMoving(-0.26, -0.2);
  PairDistance distance = watch->buffers.distances.pairs[0];
  distance.quality = Quality::lower_bound;
  EXPECT_EQ(distanceSentence(setup_->setup, distance),
            "base is at least 40 mm from tool, closing at 0.20 m/s, contact in 0.20 s at the "
            "earliest");
}

TEST_F(ConversionsTest, speedScale_isZeroWithoutKnowledge) {
  EXPECT_EQ(stateOf(*watchWithout("tool"), facts()).speed_scale, 0.0);
  CycleFacts off = facts();
  off.is_enabled = false;
  EXPECT_EQ(speedScaleOf(*watchAt(0.25), off), 0.0);
  CycleFacts no_time = facts();
  no_time.now = ros::Time();
  EXPECT_EQ(speedScaleOf(*watchAt(0.25), no_time), 0.0);
  EXPECT_TRUE(std::isnan(stateOf(*watchMoving(0.25, 1.0), no_time).time_to_contact));
}

TEST_F(ConversionsTest, distances_haveTheirGradientRows) {
  DistanceList list;
  const Distances& message = list.fill(*watchMoving(-0.26, -0.2));
  ASSERT_EQ(message.pairs.size(), 1U);
  EXPECT_EQ(message.pairs[0].gradient_joints, (std::vector<std::string>{"slide", "reach"}));
  ASSERT_EQ(message.pairs[0].gradient_values.size(), 2U);
  EXPECT_NEAR(message.pairs[0].gradient_values[0], 1.0, 1e-12);
  EXPECT_NEAR(message.pairs[0].gradient_values[1], 1.0, 1e-12);
}

TEST_F(ConversionsTest, warningAndContactStates) {
  EXPECT_EQ(stateOf(*watchAt(-0.26), facts()).level, State::WARNING);
  EXPECT_EQ(stateOf(*watchAt(-0.26), facts()).sentence, "base is 40 mm from tool");
  EXPECT_EQ(stateOf(*watchAt(-0.3), facts()).level, State::CONTACT);
  EXPECT_EQ(stateOf(*watchAt(-0.3), facts()).sentence, "base touches tool");
  EXPECT_EQ(stateOf(*watchAt(-0.303), facts()).sentence, "base overlaps tool by 3.0 mm");
  EXPECT_EQ(stateOf(*watchAt(-0.29998), facts()).level, State::WARNING);
  EXPECT_EQ(stateOf(*watchAt(-0.29998), facts()).sentence, "base is less than 0.1 mm from tool")
      << "what touches is a contact";
}

TEST_F(ConversionsTest, unknownLink_isNamedWithItsReason) {
  const State state = stateOf(*watchWithout("finger"), facts());
  EXPECT_EQ(state.level, State::CONTACT) << "a contact outranks what is not known";
  ASSERT_EQ(state.unknown_links.size(), 1U);
  EXPECT_EQ(state.unknown_links[0], "finger (missing)");
  EXPECT_EQ(stateOf(*watchWithout("tool"), facts()).level, State::UNKNOWN);
}

TEST_F(ConversionsTest, noTimeYet_isUnknown) {
  CycleFacts no_time = facts();
  no_time.now = ros::Time();
  const State state = stateOf(*watchAt(0.25), no_time);
  EXPECT_EQ(state.level, State::UNKNOWN);
  EXPECT_EQ(state.sentence, "no time on /clock yet");
}

TEST_F(ConversionsTest, switchedOff_isAtLeastWarning) {
  CycleFacts off = facts();
  off.is_enabled = false;
  off.enabled_again_in = 12.0;
  EXPECT_EQ(levelOf(*watchAt(0.25), off), State::WARNING);
  EXPECT_EQ(levelOf(*watchAt(-0.4), off), State::CONTACT);
  EXPECT_EQ(stateOf(*watchAt(0.25), off).sentence,
            "switched off for another 12 s; clear; base is 550 mm from tool");
}

TEST_F(ConversionsTest, distances_nearPairsAndTheClosest) {
  DistanceList list;
  const Distances& message = list.fill(*watchAt(-0.25));
  ASSERT_EQ(message.pairs.size(), 1U) << "the finger is 0.8 m away";
  EXPECT_EQ(message.closest, 0);
  EXPECT_EQ(message.pairs_checked, 3U);
  list.fill(*watchAt(0.25));
  ASSERT_EQ(message.pairs.size(), 1U) << "the closest stays, however far";
  EXPECT_NEAR(message.pairs[0].distance, 0.55, 1e-12);
  list.fill(*watchWithout("tool"));
  EXPECT_EQ(message.pairs_unknown, 2U);
}

TEST_F(ConversionsTest, contacts_pointDepthNormalIsland) {
  Contacts message;
  toMessage(*watchAt(-0.34), message);
  ASSERT_EQ(message.contacts.size(), 1U);
  const Contact& contact = message.contacts[0];
  EXPECT_EQ(contact.link_a, "base");
  EXPECT_EQ(contact.link_b, "tool");
  EXPECT_NEAR(contact.depth, 0.04, 1e-12);
  EXPECT_NEAR(contact.normal.x, 1.0, 1e-12);
  ASSERT_EQ(contact.points.size(), 4U) << "the corners of the faces that meet";
  EXPECT_EQ(contact.feature, "face_face");
  for (const auto& point : contact.points) {
    EXPECT_NEAR(point.x, 0.08, 1e-12) << "middle of 0.06 and 0.1";
    EXPECT_NEAR(std::abs(point.y), 0.1, 1e-12);
  }
  EXPECT_EQ(contact.island, 1U);
  EXPECT_EQ(message.island_count, 1U);
  toMessage(*watchAt(0.0), message);
  EXPECT_TRUE(message.contacts.empty());
}

TEST_F(ConversionsTest, contacts_holdAnEstimateOfADepthThatIsAllowed) {
  const auto watch = estimatedDepth(store_);
  EXPECT_EQ(stateOf(*watch, facts()).level, State::CONTACT);
  Contacts message;
  toMessage(*watch, message);
  ASSERT_EQ(message.contacts.size(), 1U);
  EXPECT_NEAR(message.contacts[0].depth, 0.04, 1e-12);
}

TEST_F(ConversionsTest, contactBetweenCycles_isToldWithItsTimeAndPoses) {
  // The tool goes from x = 0.75 to -0.75 in 30 ms, through the base; they touch at 0.2.
  const auto watch = watchAt(0.25);
  watch->poses = slidingPoses(setup_->setup.model, 0.0, -1.25);
  watch->poses.stamp_ns += 30'000'000;
  runCycle(watch->setup(), watch->poses, watch->buffers);
  const State state = stateOf(*watch, facts());
  EXPECT_EQ(state.level, State::CONTACT);
  EXPECT_EQ(state.sentence,
            "base touched tool between two cycles, 11.0 ms after the poses of the last one");
  EXPECT_EQ(state.pairs_passed, 1U);
  EXPECT_NEAR(state.closest.passed_at, 0.011, 1e-9);
  EXPECT_NEAR(state.step, 0.03, 1e-12);
  EXPECT_TRUE(std::isinf(state.step_limit)) << "one step tells no acceleration";
  EXPECT_NEAR(state.step_cap, 0.03 * 0.4 / 1.5, 1e-9);
  Contacts contacts;
  toMessage(*watch, contacts);
  ASSERT_EQ(contacts.contacts.size(), 1U);
  const Contact& contact = contacts.contacts[0];
  EXPECT_NEAR(contact.passed_at, 0.011, 1e-9);
  EXPECT_NEAR(contact.points[0].x, 0.1, 1e-9);
  EXPECT_NEAR(contact.pose_a.position.x, 0.0, 1e-12);
  EXPECT_NEAR(contact.pose_b.position.x, 0.2, 1e-9);
  EXPECT_NEAR(contact.depth, 0.0, 1e-9);
  DistanceList list;
  const Distances& distances = list.fill(*watch);
  ASSERT_EQ(distances.pairs.size(), 1U);
  EXPECT_NEAR(distances.pairs[0].passed_at, 0.011, 1e-9);
  EXPECT_NEAR(distances.pairs[0].distance, 0.55, 1e-12);
  ASSERT_EQ(watch->buffers.events.changes.size(), 1U);
  PairWarning warning;
  toMessage(*watch, watch->buffers.events.changes[0], warning);
  EXPECT_EQ(warning.after, PairWarning::CONTACT);
  EXPECT_EQ(warning.sentence, state.sentence);
  EXPECT_NEAR(warning.pair.passed_at, 0.011, 1e-9);
}

TEST_F(ConversionsTest, contactBetweenCyclesOfOneShapeAndNowOfAnother_isToldAsOfNow) {
  const auto watch = watchAt(0.25);
  watch->poses = slidingPoses(setup_->setup.model, 0.0, -1.25);
  watch->poses.stamp_ns += 30'000'000;
  runCycle(watch->setup(), watch->poses, watch->buffers);
  // As if it were of another shape of the tool.
  const std::uint32_t closest = watch->buffers.events.closest_of_all;
  watch->buffers.distances.pairs[closest].measured.distance = 0.0;
  EXPECT_EQ(stateOf(*watch, facts()).sentence, "base touches tool");
  DistanceList list;
  const Distances& distances = list.fill(*watch);
  ASSERT_EQ(distances.pairs.size(), 1U);
  EXPECT_TRUE(std::isnan(distances.pairs[0].passed_at)) << "the links are not apart again";
}

TEST_F(ConversionsTest, contactNow_hasNoTimeAndThePosesOfNow) {
  Contacts message;
  toMessage(*watchAt(-0.34), message);
  ASSERT_EQ(message.contacts.size(), 1U);
  EXPECT_TRUE(std::isnan(message.contacts[0].passed_at));
  EXPECT_NEAR(message.contacts[0].pose_b.position.x, 0.16, 1e-12);
}

TEST_F(ConversionsTest, changes_sayWhatHappened) {
  const auto watch = watchAt(-0.26);
  ASSERT_EQ(watch->buffers.events.changes.size(), 1U);
  PairWarning warning;
  toMessage(*watch, watch->buffers.events.changes[0], warning);
  EXPECT_EQ(warning.before, PairWarning::CLEAR);
  EXPECT_EQ(warning.after, PairWarning::WARNING);
  EXPECT_EQ(warning.sentence, "base is 40 mm from tool");
  EXPECT_NEAR(warning.pair.distance, 0.04, 1e-12);
  EXPECT_EQ(changeSentence(*watchAt(0.25), {0, Verdict::warning, Verdict::clear}),
            "base is 550 mm from tool, clear again");
}

TEST_F(ConversionsTest, pairOutOfReach_isABoundWithoutPoints) {
  const auto watch = watchAt(-0.25);
  const auto& checked = setup_->setup.checked;
  for (LinkPairIndex i = 0; i < checked.size(); ++i) {
    LinkDistance message;
    toMessage(*watch, i, message);
    if (watch->buffers.events.closest[i] == kNone) {
      EXPECT_EQ(message.quality, LinkDistance::LOWER_BOUND);
      EXPECT_EQ(message.distance, 0.2);
      EXPECT_TRUE(std::isnan(message.point_on_a.x));
    }
  }
}

TEST_F(ConversionsTest, lengthsAreReadable) {
  EXPECT_EQ(lengthText(-0.003), "3.0 mm");
  EXPECT_EQ(lengthText(0.012), "12 mm");
  EXPECT_EQ(lengthText(0.00996), "10 mm");
  EXPECT_EQ(lengthText(1.2345), "1.23 m");
}

TEST_F(ConversionsTest, boundsAreCalledBounds) {
  const auto watch = watchAt(-0.26);
  PairDistance distance = watch->buffers.distances.pairs[0];
  distance.quality = Quality::lower_bound;
  distance.measured.distance = 0.04;
  EXPECT_EQ(distanceSentence(setup_->setup, distance), "base is at least 40 mm from tool");
  distance.measured.distance = -0.003;
  EXPECT_EQ(distanceSentence(setup_->setup, distance),
            "base overlaps tool by 3.0 mm (enclosing shapes)");
}

}  // namespace
}  // namespace collision_monitor::test
