// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "broad_phase/automatic.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "unit/broad_phase/methods/boxes_along_x.h"

namespace collision_monitor::test {
namespace {

/// Holds each call to brute force: whichever method is chosen, and whenever it changes.
class AutomaticTest : public testing::Test {
 protected:
  void expectSameAsBruteForce(Automatic& method, const Boxes& boxes) {
    ASSERT_EQ(meetingsOf(method, boxes), meetingsInOrder(brute_force_, boxes));
  }

  BruteForce brute_force_{600};
};

TEST_F(AutomaticTest, orderTurnsToDisorderAndBack_pairsStayTrue) {
  Automatic method(100);
  Boxes boxes = chainOfBoxes(100);
  for (int call = 0; call < 250; ++call) {
    if (call >= 10 && call < 130) {  // longer than until the next trial
      std::rotate(boxes.begin(), boxes.begin() + 37, boxes.end());
    } else {
      moveAlongX(0.01F, boxes);
    }
    expectSameAsBruteForce(method, boxes);
  }
}

/// Each body meets all others, so a sweep sees 300 rows a body: the way of sweep and prune.
TEST_F(AutomaticTest, crowdInCoherentMotionThatScatters_pairsStayTrue) {
  Automatic method(600);
  Boxes boxes(600, boxAlongX(0.0F, 1.0F));
  for (int call = 0; call < 6; ++call) {
    moveAlongX(0.01F, boxes);
    expectSameAsBruteForce(method, boxes);
  }
  boxes = chainOfBoxes(600);
  std::rotate(boxes.begin(), boxes.begin() + 251, boxes.end());
  for (int call = 0; call < 6; ++call) {
    std::reverse(boxes.begin(), boxes.end());
    expectSameAsBruteForce(method, boxes);
  }
}

TEST_F(AutomaticTest, fewBodies_areMarkedInTheTableItselfAndManyAreNot) {
  const PairTable table({{BodyId{0}, BodyId{1}}}, 201);
  MarkedPairs marks(1);
  Automatic method(201);
  Boxes boxes(200, boxAlongX(0.0F, 1.0F));
  const PairTable table_of_few({{BodyId{0}, BodyId{1}}}, 200);
  EXPECT_TRUE(method.markPairs(boxes, table_of_few, marks));
  EXPECT_EQ(marks.words[0], 1U);
  boxes.push_back(boxes[0]);
  marks = MarkedPairs(1);
  EXPECT_FALSE(method.markPairs(boxes, table, marks));
  EXPECT_EQ(marks.words[0], 0U);
}

}  // namespace
}  // namespace collision_monitor::test
