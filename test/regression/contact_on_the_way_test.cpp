// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause

// Contacts on the way that the budget had left open stayed for half a second of cycles.
// What is apart now was counted among what shows such a contact, so it held like one of geometries.
// Now only what met on the way shows it, and a bound that met holds nothing.
#include <gtest/gtest.h>

#include "pipeline/cycle/judge_pairs.h"
#include "unit/pipeline/cycle/two_balls.h"

namespace collision_monitor::test {
namespace {

class ContactOnTheWay : public TwoBalls {};

/// As a search on the way tells it that the budget ended: the hysteresis holds none of it.
TEST_F(ContactOnTheWay, contactOnTheWayThatTheBudgetLeftOpen_isNotHeld) {
  runWithGap(0.002);
  const auto judge = [&] {
    judgePairs(setup_, buffers_.body_poses, poses_.velocities, buffers_.distances, buffers_.memory,
               buffers_.events);
    return verdict();
  };
  PassedContact passed;
  passed.distance = buffers_.distances.pairs[0];
  passed.distance.quality = Quality::lower_bound;
  buffers_.distances.passed = {passed};
  EXPECT_EQ(judge(), Verdict::contact);
  buffers_.distances.passed.clear();
  EXPECT_EQ(judge(), Verdict::warning);
  passed.distance.quality = Quality::exact;
  buffers_.distances.passed = {passed};
  EXPECT_EQ(judge(), Verdict::contact);
  buffers_.distances.passed.clear();
  EXPECT_EQ(judge(), Verdict::contact) << "one of the geometries is held";
}

}  // namespace
}  // namespace collision_monitor::test
