// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/refine/touch_elements.h"

#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <vector>

#include "support/robots/geometry_setup.h"
#include "support/sample_meshes.h"

namespace collision_monitor::test {
namespace {

using State = ElementContact::State;

/// Two elements, the second at x.
class TouchElements : public testing::Test {
 protected:
  void set(const Geometry& a, const Geometry& b) {
    setup_ = geometrySetup({a, b}, SetupOptions());
    memory_ = RefineMemory();
  }

  ElementContact touch(double x, double distance = 0.0,
                       std::uint32_t budget = std::numeric_limits<std::uint32_t>::max()) {
    at_b_.translation.x() = x;
    ElementSearch search{budget, memory_, *scratch_};
    return touchElements({setup_.elements[0], Pose()}, {setup_.elements[1], at_b_},
                         {distance, false}, search);
  }

  CycleSetup setup_;
  RefineMemory memory_;
  std::unique_ptr<RefineScratch> scratch_ = std::make_unique<RefineScratch>();
  Pose at_b_;
};

TEST_F(TouchElements, solidsOfEveryKind_touchUpToTheDistance) {
  const std::vector<Geometry> kinds = {Sphere{0.1}, Capsule{0.1, 0.1}, Box{{0.1, 0.1, 0.1}},
                                       Cylinder{0.1, 0.1}, boxMesh({0.1, 0.1, 0.1})};
  for (const Geometry& a : kinds) {
    for (const Geometry& b : kinds) {
      set(a, b);
      SCOPED_TRACE(testing::Message() << a.index() << " and " << b.index());
      EXPECT_EQ(touch(0.19).state, State::contact);
      EXPECT_EQ(touch(0.21).state, State::apart);
      EXPECT_EQ(touch(0.21, 0.009).state, State::apart);
      EXPECT_EQ(touch(0.21, 0.011).state, State::contact);
      EXPECT_TRUE(touch(0.21).is_complete);
    }
  }
}

TEST_F(TouchElements, solidsOfEveryKind_touchAHalfSpaceUpToTheDistance) {
  const std::vector<Geometry> kinds = {Sphere{0.1}, Capsule{0.0, 0.1}, Box{{0.1, 0.1, 0.1}},
                                       Cylinder{0.1, 0.1}, boxMesh({0.1, 0.1, 0.1})};
  for (const Geometry& kind : kinds) {
    set(kind, Sphere{0.1});
    setup_.elements[1].convex = HalfSpace();  // z <= 0
    SCOPED_TRACE(kind.index());
    at_b_.translation.z() = -0.105;
    EXPECT_EQ(touch(0.0).state, State::apart);
    EXPECT_EQ(touch(0.0, 0.004).state, State::apart);
    EXPECT_EQ(touch(0.0, 0.006).state, State::contact);
    at_b_.translation.z() = -0.095;
    EXPECT_EQ(touch(0.0).state, State::contact);
  }
}

TEST_F(TouchElements, concaveMeshesWhoseHullsOverlap_areAskedThemselves) {
  set(angleMesh(), angleMesh());
  at_b_ = hookedPose();
  const double hooked = at_b_.translation.x();
  EXPECT_EQ(touch(hooked).state, State::apart);
  EXPECT_EQ(touch(hooked, 0.019).state, State::apart);
  EXPECT_EQ(touch(hooked, 0.021).state, State::contact);
}

TEST_F(TouchElements, meshInsideOfAMesh_isContact) {
  set(angleMesh(), scaled(angleMesh(), 0.1));
  at_b_.translation = {0.0, 0.04, 0.0};
  EXPECT_EQ(touch(0.04).state, State::contact);
}

TEST_F(TouchElements, paddings_countAsIfTheyWereThere) {
  set(angleMesh(), angleMesh());
  setup_.elements[0].padding = 0.01;
  setup_.elements[1].padding = 0.005;
  at_b_ = hookedPose();
  EXPECT_EQ(touch(at_b_.translation.x(), 0.004).state, State::apart);
  EXPECT_EQ(touch(at_b_.translation.x(), 0.006).state, State::contact);
}

TEST_F(TouchElements, distanceBelowZero_allowsConvexOnesSomeDepth) {
  set(Box{{0.1, 0.1, 0.1}}, Cylinder{0.1, 0.1});
  EXPECT_EQ(touch(0.19, -0.02).state, State::apart);
  EXPECT_EQ(touch(0.17, -0.02).state, State::contact);
  set(angleMesh(), Sphere{0.1});
  EXPECT_EQ(touch(0.35, -0.08).state, State::contact) << "concave ones overlap or not";
}

TEST_F(TouchElements, budgetSpent_isNotTold) {
  set(angleMesh(), angleMesh());
  at_b_ = hookedPose();
  const ElementContact found = touch(at_b_.translation.x(), 0.0, 12);
  EXPECT_EQ(found.state, State::unknown);
  EXPECT_FALSE(found.is_complete);
}

TEST_F(TouchElements, poseNotFinite_isNotTold) {
  for (const Geometry& a : {Geometry(angleMesh()), Geometry(Cylinder{0.1, 0.1})}) {
    set(a, Cylinder{0.1, 0.1});
    EXPECT_EQ(touch(std::numeric_limits<double>::quiet_NaN()).state, State::unknown);
  }
}

TEST_F(TouchElements, theSameAgain_costsLessThanTheFirstTime) {
  set(angleMesh(), angleMesh());
  const ElementContact first = touch(0.05);
  const ElementContact again = touch(0.0501);
  EXPECT_EQ(first.state, State::contact);
  EXPECT_EQ(again.state, State::contact);
  EXPECT_LE(again.work, first.work);
}

TEST_F(TouchElements, afterManyContactsOfTriangles_theseAreAskedFirst) {
  set(angleMesh(), angleMesh());
  at_b_ = hookedPose();
  const double hooked = at_b_.translation.x();
  const ElementContact second = (touch(hooked, 0.021), touch(hooked, 0.021));
  for (int i = 0; i < 10; ++i) {
    EXPECT_EQ(touch(hooked, 0.021).state, State::contact);
  }
  EXPECT_TRUE(memory_.triangles_meet.isLikely());
  EXPECT_LT(touch(hooked, 0.021).work, second.work) << "no hulls";
  EXPECT_EQ(touch(hooked, 0.019).state, State::apart);
  EXPECT_EQ(touch(10.0).state, State::apart);
  EXPECT_EQ(touch(std::numeric_limits<double>::quiet_NaN()).state, State::unknown);
  EXPECT_FALSE(memory_.triangles_meet.isLikely());
}

TEST_F(TouchElements, contactsThatInnerShapesTell_doNotCallForTriangles) {
  set(angleMesh(), angleMesh());
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(touch(0.05).state, State::contact);
  }
  EXPECT_FALSE(memory_.triangles_meet.isLikely());
}

TEST(ContactForecast, contactsThatComeLessThanTwiceAsOftenAsGaps_areNotLikely) {
  ContactForecast forecast;
  for (int i = 0; i < 30; ++i) {
    forecast.add(i % 3 != 0);
    EXPECT_FALSE(forecast.isLikely());
  }
  for (int i = 0; i < 30; ++i) {
    forecast.add(true);
  }
  EXPECT_TRUE(forecast.isLikely());
}

}  // namespace
}  // namespace collision_monitor::test
