// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/broad_phase/small_box.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "broad_phase/box_tests.h"
#include "geometry/constants.h"
#include "support/instruction_sets.h"

namespace collision_monitor {
namespace {

constexpr float kGreatest = std::numeric_limits<float>::max();

Aabb cube(double min, double max) {
  return {Eigen::Vector3d::Constant(min), Eigen::Vector3d::Constant(max)};
}

TEST(SmallBox, isRoundedOutwardByThreePlacesAtMost) {
  for (const double value : {0.0, 1.0, 0.1, 0.7, 1234.5678, 1e-20}) {
    for (const double sign : {-1.0, 1.0}) {
      const SmallBox box = smallBoxOf(cube(sign * value, sign * value));
      const double allowed = 3.0 * value * std::numeric_limits<float>::epsilon() + 1.2e-38;
      EXPECT_LT(static_cast<double>(box.min[1]), sign * value);
      EXPECT_GT(static_cast<double>(box.max[1]), sign * value);
      EXPECT_NEAR(box.min[1], sign * value, allowed);
      EXPECT_NEAR(box.max[1], sign * value, allowed);
    }
  }
  EXPECT_LT(smallBoxOf(cube(-1e-60, 1e-60)).min[0], 0.0F);
}

TEST(SmallBox, beyondSinglePrecisionBoxesOnlyGrow) {
  const float inward = kGreatest - kGreatest * std::numeric_limits<float>::epsilon();
  EXPECT_EQ(smallBoxOf(cube(-1e300, 1e300)).min[0], -std::numeric_limits<float>::infinity());
  EXPECT_EQ(smallBoxOf(cube(-1e300, 1e300)).max[0], std::numeric_limits<float>::infinity());
  EXPECT_EQ(smallBoxOf(cube(1e300, kInfinity)).min[0], inward);
  EXPECT_EQ(smallBoxOf(cube(-kInfinity, -1e300)).max[0], -inward);
}

/// To the last bit, whatever the instruction set; the last box takes another way than the others.
TEST(SmallBox, manyAtOnceAreAsOneByOne_onEveryInstructionSet) {
  BodyBounds bounds;
  for (const double min : {-kInfinity, -1e300, -1234.5678, -0.1, -1e-60, 0.0, 0.7, 1e30}) {
    for (const double max : {-1e300, -0.1, 0.0, 0.3, 1e-20, 7.7, 1e300, kInfinity}) {
      bounds.boxes.push_back({{min, 0.1, min}, {max, 0.3, max}});
      bounds.known.push_back(bounds.boxes.size() % 7 == 0 ? 0 : 1);
    }
  }
  bounds.boxes[5].max.y() = std::numeric_limits<double>::quiet_NaN();
  for (const std::int64_t target : test::instructionSets()) {
    const test::OnlyInstructionSet only(target);
    std::vector<SmallBox> boxes(bounds.boxes.size());
    fillSmallBoxes(bounds, boxes);
    for (std::size_t body = 0; body < boxes.size(); ++body) {
      const SmallBox expected =
          bounds.known[body] != 0 ? smallBoxOf(bounds.boxes[body]) : emptyBox();
      EXPECT_EQ(std::memcmp(&boxes[body], &expected, sizeof expected), 0)
          << hwy::TargetName(target) << ", box " << body;
    }
  }
}

TEST(SmallBox, noBoxIsEmptyAndMeetsNothing) {
  Aabb broken = cube(0.0, 1.0);
  broken.max.z() = std::numeric_limits<double>::quiet_NaN();
  const SmallBox everything = smallBoxOf(cube(-kInfinity, kInfinity));
  for (const Aabb& none : {broken, cube(1.0, 0.0)}) {
    const SmallBox box = smallBoxOf(none);
    EXPECT_TRUE(isEmpty(box));
    EXPECT_FALSE(meets(box, everything));
    EXPECT_FALSE(meets(box, box));
    EXPECT_TRUE(isInside(box, everything));
    EXPECT_FALSE(isInside(everything, box));
  }
  EXPECT_TRUE(meets(everything, everything));
}

TEST(SmallBox, touchingMeets_aGapOnOneAxisDoesNot) {
  const SmallBox box = smallBoxOf(cube(0.0, 1.0));
  EXPECT_TRUE(meets(box, smallBoxOf(cube(1.0, 2.0))));
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    Aabb apart = cube(0.0, 1.0);
    apart.min[axis] = 1.25;
    apart.max[axis] = 2.0;
    EXPECT_FALSE(meets(box, smallBoxOf(apart)));
    EXPECT_FALSE(meets(smallBoxOf(apart), box));
  }
}

}  // namespace
}  // namespace collision_monitor
