// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "broad_phase/methods/aabb_tree.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "boxes_along_x.h"

namespace collision_monitor::test {
namespace {

/// Of so many bodies that one more or less does not build the tree anew.
constexpr std::size_t kBodies = 32;

Meetings chainMeetings() {
  Meetings meetings;
  for (std::uint32_t i = 0; i + 1 < kBodies; ++i) {
    meetings.emplace_back(i, i + 1);
  }
  return meetings;
}

TEST(AabbTree, noBodyOrOne_meetsNothing) {
  AabbTree method(2);
  EXPECT_TRUE(meetingsOf(method, Boxes(2, emptyBox())).empty());
  EXPECT_TRUE(meetingsOf(method, {boxAlongX(0, 1), emptyBox()}).empty());
  EXPECT_EQ(meetingsOf(method, {boxAlongX(0, 1), boxAlongX(1, 2)}), (Meetings{{0, 1}}));
}

TEST(AabbTree, bodyTakenOutAndPutInElsewhere_hasThePairsOfItsPlace) {
  AabbTree method(kBodies);
  Boxes boxes = chainOfBoxes(kBodies);
  Meetings expected = chainMeetings();
  EXPECT_EQ(meetingsOf(method, boxes), expected);
  boxes[5] = emptyBox();
  expected.erase(expected.begin() + 4, expected.begin() + 6);
  EXPECT_EQ(meetingsOf(method, boxes), expected);
  boxes[5] = boxAlongX(20.5F, 20.75F);  // within body 20
  expected.insert(expected.begin() + 4, {5, 20});
  EXPECT_EQ(meetingsOf(method, boxes), expected);
}

TEST(AabbTree, allBodiesTakenOut_oneAtATimeAndPutInAgain) {
  AabbTree method(kBodies);
  const Boxes whole = chainOfBoxes(kBodies);
  Boxes boxes = whole;
  for (std::size_t body = 0; body < kBodies; ++body) {
    boxes[body] = emptyBox();
    EXPECT_EQ(meetingsOf(method, boxes).size(), body + 1 < kBodies ? kBodies - body - 2 : 0);
  }
  for (std::size_t body = 0; body < kBodies; ++body) {
    boxes[body] = whole[body];
    EXPECT_EQ(meetingsOf(method, boxes).size(), body);
  }
}

TEST(AabbTree, bodiesThatChangePlaces_findTheSamePairs) {
  AabbTree method(kBodies);
  Boxes boxes = chainOfBoxes(kBodies);
  meetingsOf(method, boxes);
  for (std::size_t body = 0; body + 1 < kBodies; ++body) {  // the first one wanders to the end
    std::swap(boxes[body], boxes[body + 1]);
    EXPECT_EQ(meetingsOf(method, boxes).size(), kBodies - 1);
  }
  std::rotate(boxes.begin(), boxes.begin() + static_cast<std::ptrdiff_t>(kBodies) - 1, boxes.end());
  std::reverse(boxes.begin(), boxes.end());
  EXPECT_EQ(meetingsOf(method, boxes), chainMeetings()) << "a worn tree is built anew";
}

}  // namespace
}  // namespace collision_monitor::test
