// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <memory>

#include "collision_monitor/geometry/ids.h"
#include "narrow_phase/mesh/mesh_distance.h"
#include "support/query_meshes.h"
#include "support/sample_meshes.h"

namespace collision_monitor::test {
namespace {

using State = MeshContact::State;

/// A box of 0.2 m, and the same at x.
class MeshContactTest : public testing::Test {
 protected:
  MeshContact touch(double x, const MeshContactQuery& query, const TrianglePair& start = {}) {
    return contactOf({box_, Pose()}, {box_, at(x)}, query, *memory_, start);
  }
  static Pose at(double x) {
    Pose pose;
    pose.translation = {x, 0.01, 0.02};
    return pose;
  }

  static TriangleMesh withoutATriangle() {
    TriangleMesh open = boxMesh({0.1, 0.1, 0.1});
    open.triangles.pop_back();
    return open;
  }

  MeshTree box_{boxMesh({0.1, 0.1, 0.1}), true};
  MeshTree small_{boxMesh({0.02, 0.02, 0.02}), true};
  std::unique_ptr<MeshQueryMemory> memory_ = std::make_unique<MeshQueryMemory>();
};

TEST_F(MeshContactTest, surfacesThatCross_areInContact) {
  const MeshContact found = touch(0.15, {});
  EXPECT_EQ(found.state, State::contact);
  EXPECT_LT(found.triangles.a, box_.triangles().size());
}

TEST_F(MeshContactTest, apart_isNoContactUpToTheDistanceAskedFor) {
  EXPECT_EQ(touch(0.21, {}).state, State::apart);
  EXPECT_EQ(touch(0.21, {0.009}).state, State::apart);
  EXPECT_EQ(touch(0.21, {0.011}).state, State::contact);
}

TEST_F(MeshContactTest, oneInsideOfTheOther_isContactWithoutTriangles) {
  const MeshContact found = contactOf({box_, Pose()}, {small_, at(0.0)}, {}, *memory_);
  EXPECT_EQ(found.state, State::contact);
  EXPECT_EQ(found.triangles.a, kNone);
  EXPECT_EQ(contactOf({small_, at(0.0)}, {box_, Pose()}, {}, *memory_).state, State::contact);
}

TEST_F(MeshContactTest, trianglesInContactBefore_areAskedFirst) {
  const MeshContact before = touch(0.15, {});
  const MeshContact again = touch(0.151, {}, before.triangles);
  EXPECT_EQ(again.state, State::contact);
  EXPECT_EQ(again.visits, 1U);
  EXPECT_EQ(touch(0.3, {}, before.triangles).state, State::apart) << "they are asked, not believed";
}

TEST_F(MeshContactTest, probeHeldBefore_isAskedFirst) {
  const MeshTree outer = test::openTree(withoutATriangle());
  for (const bool is_of_b : {true, false}) {
    const auto touchAt = [&](double x, HeldProbe held) {
      MeshContactQuery query;
      query.held = held;
      return is_of_b ? contactOf({outer, Pose()}, {small_, at(x)}, query, *memory_)
                     : contactOf({small_, at(x)}, {outer, Pose()}, query, *memory_);
    };
    const MeshContact before = touchAt(0.0, kNone);
    ASSERT_NE(before.held, kNone);
    const MeshContact again = touchAt(0.001, before.held);
    EXPECT_EQ(again.state, State::contact);
    EXPECT_EQ(again.held, before.held);
    EXPECT_LT(again.visits, before.visits);
    const MeshContact across = touchAt(0.1, before.held);
    EXPECT_EQ(across.state, State::contact) << "surfaces cross";
    for (const HeldProbe held : {before.held, HeldProbe{1000}}) {
      const MeshContact beside = touchAt(0.3, held);
      EXPECT_EQ(beside.state, State::apart) << "it is asked, not believed";
      EXPECT_EQ(beside.held, kNone);
    }
  }
}

TEST_F(MeshContactTest, probesOutsideBefore_areAskedAgainOnlyAfterTravel) {
  const MeshTree outer = test::openTree(withoutATriangle());
  std::array<KeptProbe, 32> kept;
  ASSERT_LE(countProbes(outer, small_), kept.size());
  const auto touchAt = [&](double x) {
    MeshContactQuery query;
    query.distance = 0.01;
    query.asks_outside = true;
    query.probes = {kept.data(), kept.size()};
    return contactOf({outer, Pose()}, {small_, at(x)}, query, *memory_);
  };
  const double outside = touchAt(0.3).outside;
  const KeptProbe first = kept[0];
  EXPECT_GE(first.hold, outside);
  EXPECT_EQ(first.apart, 0.01);
  const MeshContact near_by = touchAt(0.301);
  EXPECT_EQ(near_by.state, State::apart);
  EXPECT_EQ(kept[0].point, first.point) << "it was not asked";
  EXPECT_NEAR(near_by.outside, outside - 0.001, 1e-12);
  EXPECT_EQ(touchAt(0.32).state, State::apart);
  EXPECT_NE(kept[0].point, first.point) << "it moved by more than the surfaces were apart";
  EXPECT_EQ(touchAt(0.0).state, State::contact) << "a jump into the other";
}

TEST_F(MeshContactTest, whereNotAllProbesCanBeKept_noneIs) {
  const MeshTree outer = test::openTree(withoutATriangle());
  std::array<KeptProbe, 1> few;
  ASSERT_GT(countProbes(outer, small_), few.size());
  MeshContactQuery query;
  query.distance = 0.01;
  query.asks_outside = true;
  query.probes = {few.data(), few.size()};
  EXPECT_EQ(contactOf({outer, Pose()}, {small_, at(0.3)}, query, *memory_).state, State::apart);
  EXPECT_EQ(few[0].hold, 0.0);
}

TEST_F(MeshContactTest, distanceOfAProbeHeldBefore_isThatOfAnyOther) {
  MeshQueryLimits limits;
  const PlacedMesh outer{box_, Pose()};
  const Pose inside = at(0.01);
  const MeshDistance before = distanceBetween(outer, {small_, inside}, *memory_, {}, limits);
  ASSERT_EQ(before.state, MeshState::overlapping);
  limits.held = before.held;
  const MeshDistance again = distanceBetween(outer, {small_, inside}, *memory_, {}, limits);
  EXPECT_EQ(again.state, MeshState::overlapping);
  EXPECT_EQ(again.measured.distance, 0.0);
  EXPECT_EQ(again.measured.point_on_a, before.measured.point_on_a);
  EXPECT_LT(again.visits, before.visits);
  const Pose beside = at(0.3);
  EXPECT_EQ(distanceBetween(outer, {small_, beside}, *memory_, {}, limits).measured.distance,
            distanceBetween(outer, {small_, beside}, *memory_).measured.distance);
}

TEST_F(MeshContactTest, budgetSpent_isOpen) {
  MeshContactQuery query;
  query.visit_budget = 1;
  EXPECT_EQ(touch(0.15, query).state, State::open);
  EXPECT_LE(touch(0.15, query).visits, 1U);
}

TEST_F(MeshContactTest, poseNotFinite_isOpen) {
  EXPECT_EQ(touch(std::numeric_limits<double>::quiet_NaN(), {}).state, State::open);
}

TEST_F(MeshContactTest, holeInTheOuterMesh_outsideIsToldWhereAsked) {
  const MeshTree outer = test::openTree(withoutATriangle());
  EXPECT_EQ(contactOf({outer, Pose()}, {small_, at(0.0)}, {}, *memory_).state, State::contact);
  MeshContactQuery query;
  query.asks_outside = true;
  const MeshContact beside = contactOf({outer, Pose()}, {small_, at(0.3)}, query, *memory_);
  EXPECT_EQ(beside.state, State::apart);
  EXPECT_LT(beside.outside, 0.5) << "how far it may go until it can be inside";
  EXPECT_GT(beside.outside, 0.0);
}

TEST_F(MeshContactTest, knownToBeOutside_isNotLookedForInside) {
  MeshContactQuery query;
  query.asks_outside = true;
  query.outside = 0.02;
  for (const TriangleMesh& mesh : {boxMesh({0.1, 0.1, 0.1}), withoutATriangle()}) {
    const MeshTree outer = test::openTree(mesh);
    const MeshContact told = contactOf({outer, Pose()}, {small_, at(0.0)}, query, *memory_);
    EXPECT_EQ(told.state, State::apart) << "as the caller says";
    EXPECT_EQ(told.outside, 0.02);
    const ConvexGeometry ball = Sphere{0.01};
    const MeshContact of_ball =
        contactOf({outer, Pose()}, PlacedConvex{ball, at(0.0)}, query, *memory_);
    EXPECT_EQ(of_ball.state, State::apart);
    EXPECT_EQ(of_ball.outside, 0.02);
  }
  EXPECT_EQ(touch(0.15, query).state, State::contact) << "surfaces that cross are in contact";
}

}  // namespace
}  // namespace collision_monitor::test
