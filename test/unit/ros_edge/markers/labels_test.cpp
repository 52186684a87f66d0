// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/markers/labels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "geometry/constants.h"
#include "unit/ros_edge/world_scene.h"

namespace collision_monitor::test {
namespace {

/// base, tool and finger at x = 0, 0.16 and 0.1, finger 1 m aside: a contact of 40 mm and two
/// pairs that are 800 mm apart.
std::unique_ptr<Watch> threeNear(const TransformStore& store, double warning_distance) {
  SetupOptions options;
  options.limits.report_distance = 1.0;
  options.limits.warning_distance = warning_distance;
  const auto setup = slidingSetup(options);
  return judged(setup, store, slidingPoses(setup->setup.model, 0.0, -0.34));
}

TEST(ChooseLabelled, contactsComeFirstAndClearPairsNotAtAll) {
  TransformStore store;
  const auto watch = threeNear(store, 0.05);
  const std::vector<LinkPairIndex> chosen = chooseLabelled(*watch, 6);
  ASSERT_EQ(chosen.size(), 1U) << "the closest is the contact";
  EXPECT_EQ(watch->buffers.events.verdicts[chosen[0]], Verdict::contact);
}

TEST(ChooseLabelled, noMoreThanAsked_theMostUrgentOnes) {
  TransformStore store;
  const auto watch = threeNear(store, 1.0);
  EXPECT_EQ(chooseLabelled(*watch, 6).size(), 3U);
  const std::vector<LinkPairIndex> two = chooseLabelled(*watch, 2);
  ASSERT_EQ(two.size(), 2U);
  EXPECT_EQ(watch->buffers.events.verdicts[two[0]], Verdict::contact);
  EXPECT_EQ(watch->buffers.events.verdicts[two[1]], Verdict::warning);
  EXPECT_TRUE(chooseLabelled(*watch, 0).empty());
}

TEST(ChooseLabelled, ofTwoWarnings_theOneThatTouchesSoonerComesFirst) {
  TransformStore store;
  const auto watch = threeNear(store, 1.0);
  PairEvents& events = watch->buffers.events;
  const std::vector<LinkPairIndex> before = chooseLabelled(*watch, 6);
  ASSERT_EQ(before.size(), 3U);
  const LinkPairIndex last = before[2];
  events.soonest[last] = events.closest[last];
  watch->buffers.distances.pairs[events.closest[last]].time_to_contact = 0.2;
  const std::vector<LinkPairIndex> after = chooseLabelled(*watch, 6);
  ASSERT_EQ(after.size(), 3U);
  EXPECT_EQ(after[1], last);
}

TEST(ChooseLabelled, whereAllIsClear_theClosestIsLabelled) {
  TransformStore store;
  const auto setup = slidingSetup();
  const auto watch = judged(setup, store, slidingPoses(setup->setup.model, 0.0, 0.5));
  const std::vector<LinkPairIndex> chosen = chooseLabelled(*watch, 6);
  ASSERT_EQ(chosen.size(), 1U);
  EXPECT_EQ(watch->buffers.events.verdicts[chosen[0]], Verdict::clear);
}

TEST(LabelText, namesAnObjectAsOne) {
  TransformStore store;
  const auto setup =
      slidingSetupWith({objectOf("table", Box{{0.1, 0.1, 0.1}}, at(0.0, 0.0, 0.23))});
  const auto watch = judged(setup, store, slidingPoses(setup->setup.model, 0.0, 0.5));
  Snapshot snapshot;
  takeSnapshot(*watch, snapshot);
  ASSERT_EQ(snapshot.labels.size(), 1U);
  EXPECT_EQ(labelText(watch->setup(), snapshot.labels[0]), "30 mm\nbase - object table");
}

TEST(LabelPlaces, textsAtOnePlace_areSpread) {
  LabelPlaces places;
  const std::string text = "12 mm\nhand - table";
  std::vector<double> heights;
  for (int i = 0; i < 9; ++i) {
    const Eigen::Vector3d place = places.take({1.0, 2.0, 3.0}, text, {});
    EXPECT_EQ(place.head<2>(), Eigen::Vector2d(1.0, 2.0));
    heights.push_back(place.z());
  }
  EXPECT_EQ(heights[0], 3.0) << "the most urgent stands where it belongs";
  for (std::size_t i = 1; i < heights.size(); ++i) {
    EXPECT_GE(heights[i] - heights[i - 1], 2.0 * kTextHeight) << "two lines";
  }
  EXPECT_LT(heights.back() - heights.front(), 9 * 4.0 * kTextHeight) << "and near";
}

TEST(LabelPlaces, textsNearEachOther_areApartInViewsFromAbove) {
  LabelPlaces places;
  const std::string text = "12 mm\nhand - table";
  std::vector<Eigen::Vector3d> taken;
  for (int i = 0; i < 9; ++i) {
    taken.push_back(places.take({0.03 * i, 0.05 * (i % 3), 0.02 * (i % 4)}, text, {}));
  }
  const double width = 0.5 * 12 * kTextHeight;
  const Eigen::Vector3d up(0.0, -std::sin(kHalfPi / 3.0), std::cos(kHalfPi / 3.0));
  for (std::size_t i = 0; i < taken.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const Eigen::Vector3d apart = taken[i] - taken[k];
      EXPECT_TRUE(std::abs(apart.x()) > width || std::abs(up.dot(apart)) > 2.0 * kTextHeight)
          << i << ", " << k << ": " << apart.transpose();
    }
  }
}

TEST(LabelPlaces, textsBesideEachOther_stayWhereTheyBelong) {
  LabelPlaces places;
  places.take({0.0, 0.0, 0.0}, "12 mm\na - b", {});
  EXPECT_EQ(places.take({1.0, 0.0, 0.0}, "12 mm\na - c", {}).z(), 0.0);
  EXPECT_NE(places.take({1.2, 0.0, 0.0}, "12 mm\na_link_of_a_long_name - c", {}).z(), 0.0);
}

TEST(LabelPlaces, solids_hideNoTextFromAViewerAbove) {
  const Eigen::Vector3d wanted(0.0, 0.0, 0.2);
  const std::string text = "12 mm\nhand - table";
  const double width = 0.55 * 12 * kTextHeight;
  const Aabb beside{{0.3, -0.1, 0.0}, {0.5, 0.1, 0.7}};
  const double height = LabelPlaces().take(wanted, text, {beside}).z();
  EXPECT_GT(height - kTextHeight, 0.7 - std::tan(kHalfPi / 3.0) * (0.3 - 0.5 * width) - 0.02)
      << "seen over its edge";
  EXPECT_LT(height, 0.7) << "and not higher than that";
  const Aabb above{{-0.1, -0.1, 0.3}, {0.1, 0.1, 0.9}};
  EXPECT_GT(LabelPlaces().take(wanted, text, {beside, above}).z(), 0.9);
  const Aabb far{{5.0, -0.1, 0.0}, {6.0, 0.1, 1.0}};
  const Aabb room{{-4.0, -4.0, 0.0}, {4.0, 4.0, 3.0}};
  EXPECT_EQ(LabelPlaces().take(wanted, text, {far, room}), wanted);
}

}  // namespace
}  // namespace collision_monitor::test
