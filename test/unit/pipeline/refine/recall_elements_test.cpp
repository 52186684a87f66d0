// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/refine/recall_elements.h"

#include <gtest/gtest.h>

#include <optional>

#include "support/expect_distance.h"

namespace collision_monitor::test {
namespace {

/// Two balls of 0.1 m that were measured with their centers 0.5 m apart.
class RecallElements : public testing::Test {
 protected:
  RecallElements() {
    ball_.convex = Sphere{0.1};
    last_.found.quality = Quality::exact;
    last_.found.is_complete = last_.found.has_points = true;
    last_.found.work = 7;
    last_.found.measured.distance = 0.3;
    last_.world_from_b = at(0.5, 0, 0);
  }

  ElementDistance recall(const Pose& world_from_a, const Pose& world_from_b) const {
    return recallElements(last_, {ball_, world_from_a}, {ball_, world_from_b},
                          {ballOf(ball_), ballOf(ball_)});
  }

  Element ball_;
  LastMeasurement last_;
};

TEST_F(RecallElements, nearTheHoleOfAMesh_noMoreThanTheWayThere) {
  last_.found.outside = 0.05;
  const ElementDistance recalled = recall(Pose(), at(0.5, 0.02, 0));
  EXPECT_EQ(recalled.quality, Quality::lower_bound);
  EXPECT_NEAR(recalled.measured.distance, 0.03, 1e-9);
  EXPECT_NEAR(recalled.outside, 0.03, 1e-9);
  EXPECT_EQ(recall(Pose(), at(0.5, 0, 0)).measured.distance, 0.3);
}

TEST_F(RecallElements, nothingMoved_theSameAtNoCost) {
  const ElementDistance recalled = recall(Pose(), at(0.5, 0, 0));
  EXPECT_EQ(recalled.quality, Quality::exact);
  EXPECT_TRUE(recalled.is_complete && recalled.has_points);
  EXPECT_EQ(recalled.measured.distance, 0.3);
  EXPECT_EQ(recalled.work, 0U);
}

TEST_F(RecallElements, oneMoved_aBoundLessItsWay) {
  const ElementDistance recalled = recall(Pose(), at(0.5, 0.03, 0.04));
  EXPECT_EQ(recalled.quality, Quality::lower_bound);
  EXPECT_FALSE(recalled.is_complete || recalled.has_points);
  EXPECT_NEAR(recalled.measured.distance, 0.25, 1e-9);
  EXPECT_LT(recalled.measured.distance, 0.25) << "rounding is allowed for";
}

TEST_F(RecallElements, bothMovedTheSameWay_nothingIsLostButRounding) {
  EXPECT_NEAR(recall(at(1, 2, 3), at(1.5, 2, 3)).measured.distance, 0.3, 1e-9);
}

TEST_F(RecallElements, overlapThatMoved_saysNothing) {
  last_.found.quality = Quality::estimate;
  last_.found.measured.distance = -0.02;
  EXPECT_EQ(recall(Pose(), at(0.5, 0, 0)).quality, Quality::estimate) << "while it stands";
  const ElementDistance recalled = recall(Pose(), at(0.5, 0, 1e-6));
  EXPECT_EQ(recalled.quality, Quality::unknown);
  EXPECT_FALSE(recalled.is_complete || recalled.has_points);
}

/// The first ball has a mesh in its place.
class RecallPoints : public RecallElements {
 protected:
  RecallPoints() { last_.found.measured = {0.3, {0.1, 0, 0}, {0.4, 0, 0}, {1, 0, 0}}; }

  std::optional<ElementDistance> pointsFor(const Pose& world_from_b) const {
    const Pose origin;
    return recallPoints(witnessOf(last_), {mesh_, origin}, {ball_, world_from_b},
                        recall(origin, world_from_b).measured.distance);
  }

  Element mesh_;
};

TEST_F(RecallPoints, areThoseOfTheBound_andSayHowShortItIs) {
  const auto found = pointsFor(at(0.505, 0, 0));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->quality, Quality::exact);
  EXPECT_TRUE(found->has_points && found->is_complete);
  EXPECT_NEAR(found->measured.distance, 0.295, 1e-9);
  EXPECT_NEAR(found->measured.point_on_a.x(), 0.1, 1e-9);
  EXPECT_NEAR(found->measured.point_on_b.x(), 0.395, 1e-9);
  EXPECT_NEAR(found->measured.normal_a_to_b.x(), 1.0, 1e-9);
  EXPECT_NEAR(found->shortfall, 0.01, 1e-9);
}

TEST_F(RecallPoints, measuredWithATolerance_areShorterByThat) {
  last_.found.shortfall = 0.002;
  EXPECT_NEAR(pointsFor(at(0.505, 0, 0))->shortfall, 0.012, 1e-9);
}

TEST_F(RecallPoints, ofABoundThatFollows_areThoseOfTheDistance) {
  RefineMemory memory;
  remember(last_, memory);
  LastMeasurement bound;
  bound.found.quality = Quality::lower_bound;
  bound.world_from_b = at(0.7, 0, 0);
  remember(bound, memory);
  const auto found =
      recallPoints(memory.last.witness, {mesh_, Pose()}, {ball_, at(0.505, 0, 0)}, 0.2);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->quality, Quality::exact);
  EXPECT_NEAR(found->measured.distance, 0.2, 1e-12);
  EXPECT_NEAR(found->shortfall, 0.105, 1e-9);
}

/// An overlap of meshes, 2 cm deep.
class RecallOverlap : public RecallElements {
 protected:
  RecallOverlap() {
    last_.found.quality = Quality::estimate;
    last_.found.measured = {-0.02, {0.1, 0, 0}, {0.08, 0, 0}, {1, 0, 0}};
  }

  std::optional<ElementDistance> overlapAt(const Pose& world_from_b) const {
    return recallOverlap(last_, {mesh_, Pose()}, {mesh_, world_from_b},
                         {ballOf(ball_), ballOf(ball_)});
  }

  Element mesh_;
};

TEST_F(RecallOverlap, isAsDeepAsMotionAllows) {
  const auto found = overlapAt(at(0.505, 0, 0));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->quality, Quality::estimate);
  EXPECT_TRUE(found->has_points && found->is_complete);
  EXPECT_NEAR(found->measured.distance, -0.025, 1e-9);
  EXPECT_NEAR(found->shortfall, 0.025, 1e-9);
  EXPECT_NEAR(found->measured.normal_a_to_b.x(), 1.0, 1e-9) << "B goes that way out";
}

TEST_F(RecallOverlap, thatMovedByHalf_isForgotten) {
  EXPECT_TRUE(overlapAt(at(0.5099, 0, 0)));
  EXPECT_FALSE(overlapAt(at(0.5101, 0, 0)));
  EXPECT_FALSE(overlapAt(at(kUnknown, 0, 0)));
  last_.found.quality = Quality::exact;
  EXPECT_FALSE(overlapAt(at(0.5, 0, 0)));
}

TEST_F(RecallPoints, ofABoundOrAnOverlap_areNone) {
  last_.found.has_points = false;
  EXPECT_FALSE(pointsFor(at(0.505, 0, 0)));
  last_.found.has_points = true;
  last_.found.quality = Quality::estimate;
  EXPECT_FALSE(pointsFor(at(0.505, 0, 0)));
}

}  // namespace
}  // namespace collision_monitor::test
