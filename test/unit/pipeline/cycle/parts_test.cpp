// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "collision_monitor/geometry/ids.h"
#include "collision_monitor/model/kinematics.h"
#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/cycle/run_cycle.h"
#include "pipeline/trajectory/check_trajectory.h"
#include "support/robots/hand_made_setup.h"
#include "support/robots/urdf_text.h"

// Robots of which a part floats: LinkPoses::part.
namespace collision_monitor {
namespace {

using test::describeText;
using test::handMadeSetup;
using test::jointXml;
using test::knownPoses;
using test::linkXml;
using test::robotXml;
using test::textLoader;

/// Balls of 0.1 m on links 0 to 4. 0 and 1 stand in the world at x = 0 and 1, 2 and 3 in a part of
/// their own that begins at 2, at x = 0 and 1; 4 floats alone. Cycles 20 ms apart.
class Parts : public testing::Test {
 protected:
  Parts() {
    setup_.is_continuous = true;
    poses_.stamp_ns = 1'000'000'000;
    put(1, 1.0);
    put(3, 1.0);
    floatAs(2, 2);
    floatAs(3, 2);
    floatAs(4, 4);
  }
  void put(std::size_t link, double x) { poses_.world_from_link[link].translation.x() = x; }
  void floatAs(std::size_t link, PartId part) {
    poses_.part[link] = part;
    poses_.part_status[link] = part == kWorldPart ? LinkStatus::known : LinkStatus::stale;
  }
  void run() {
    runCycle(setup_, poses_, buffers_);
    poses_.stamp_ns += 20'000'000;
  }
  Verdict verdict(std::uint32_t a, std::uint32_t b) const {
    for (std::size_t i = 0; i < setup_.checked.size(); ++i) {
      if (setup_.checked[i].a == LinkId{a} && setup_.checked[i].b == LinkId{b}) {
        return buffers_.events.verdicts[i];
      }
    }
    throw std::out_of_range("no such pair");
  }
  /// NaN where there is none.
  double closest() const {
    const std::uint32_t place = buffers_.events.closest_of_all;
    return place == kNone ? kUnknown : buffers_.distances.pairs[place].measured.distance;
  }

  CycleSetup setup_ = handMadeSetup(
      {{0, Sphere{0.1}}, {1, Sphere{0.1}}, {2, Sphere{0.1}}, {3, Sphere{0.1}}, {4, Sphere{0.1}}});
  CycleBuffers buffers_ = makeBuffers(setup_, BroadPhaseKind::brute_force);
  LinkPoses poses_ = knownPoses(setup_);
};

TEST_F(Parts, pairsWithinAPartAreJudged_pairsAcrossAreUnknown) {
  put(1, 0.24);
  put(3, 0.15);
  run();
  EXPECT_EQ(verdict(0, 1), Verdict::warning);
  EXPECT_EQ(verdict(2, 3), Verdict::contact);
  EXPECT_NEAR(closest(), -0.05, 1e-12) << "and not the 0.2 m of what stands at one place by number";
  std::size_t unknown = 0;
  for (const Verdict verdict : buffers_.events.verdicts) {
    unknown += verdict == Verdict::unknown ? 1 : 0;
  }
  EXPECT_EQ(unknown, 8U);
  EXPECT_EQ(buffers_.events.overall, Verdict::contact);
  EXPECT_EQ(buffers_.counters.candidates, 2U);
  EXPECT_EQ(buffers_.counters.unknown_pairs, 8U);
  EXPECT_EQ(buffers_.distances.pairs.size(), 2U);
  EXPECT_EQ(buffers_.events.island_of_link, (std::vector<std::uint32_t>{0, 0, 1, 1, 0}));
  EXPECT_EQ(buffers_.memory.speed.scale, 0.0) << "a pair is unknown";
}

TEST_F(Parts, allFarApart_closestIsNotOneAcross) {
  put(1, 5.0);
  put(2, 0.5);  // 0.3 m from link 0 by number
  put(3, 7.0);
  run();
  EXPECT_NEAR(closest(), 4.8, 1e-12);
  EXPECT_EQ(buffers_.events.overall, Verdict::unknown);
  EXPECT_TRUE(std::isnan(buffers_.events.time_to_contact));
}

TEST_F(Parts, linkThatFloatsAlone_isUnknown) {
  run();
  EXPECT_EQ(buffers_.body_poses.known, (std::vector<unsigned char>{1, 1, 1, 1, 0}));
  EXPECT_EQ(buffers_.counters.unknown_links, 1U);
}

TEST_F(Parts, everythingInOneFloatingPart_nothingIsUnknown) {
  for (std::size_t link = 0; link < 5; ++link) {
    put(link, static_cast<double>(link));
    floatAs(link, 0);
  }
  run();
  EXPECT_FALSE(buffers_.body_poses.is_split);
  EXPECT_EQ(buffers_.events.overall, Verdict::clear);
  EXPECT_NEAR(closest(), 0.8, 1e-12);
  EXPECT_EQ(buffers_.counters.unknown_pairs, 0U);
  EXPECT_EQ(buffers_.memory.speed.scale, 1.0);
}

TEST_F(Parts, statusThatIsNotKnown_isUnknownInAnyPart) {
  put(3, 0.15);
  std::fill(poses_.status.begin(), poses_.status.end(), LinkStatus::stale);
  run();
  EXPECT_TRUE(std::all_of(buffers_.events.verdicts.begin(), buffers_.events.verdicts.end(),
                          [](Verdict verdict) { return verdict == Verdict::unknown; }));
}

TEST_F(Parts, linkThatChangesItsPart_isNotFollowedOnAWay) {
  run();
  put(3, -1.0);
  run();
  EXPECT_EQ(verdict(2, 3), Verdict::contact) << "it came through link 2";
  EXPECT_EQ(buffers_.distances.passed.size(), 1U);
  run();
  EXPECT_EQ(verdict(2, 3), Verdict::clear);
  for (const std::size_t link : {2U, 3U, 4U}) {
    floatAs(link, kWorldPart);
  }
  put(2, 3.0);
  put(3, 4.0);
  put(4, 6.0);
  run();
  EXPECT_TRUE(buffers_.distances.passed.empty()) << "where it was beside 0 and 1 nobody knows";
  EXPECT_EQ(buffers_.events.overall, Verdict::clear);
  put(2, -3.0);
  run();
  EXPECT_FALSE(buffers_.distances.passed.empty()) << "it came through both";
}

/// Beside link 1, and so far off that boxes grown by the reach meet and balls do not.
TEST_F(Parts, gapsOfOtherParts_areForgotten) {
  std::fill(poses_.velocities.known.begin(), poses_.velocities.known.end(), 1);
  for (const std::size_t link : {2U, 3U, 4U}) {
    floatAs(link, kWorldPart);
    put(link, static_cast<double>(link) + 5.0);
  }
  poses_.world_from_link[2].translation = {1.39, 0.39, 0.0};
  put(4, -0.3);  // near link 0, so that the closest is not searched for
  run();
  ASSERT_EQ(buffers_.counters.culled_by_spheres, 1U);
  floatAs(2, 2);
  floatAs(3, 2);
  poses_.world_from_link[2] = Pose();
  run();
  floatAs(2, kWorldPart);
  floatAs(3, kWorldPart);
  put(2, 0.85);
  run();
  EXPECT_EQ(verdict(1, 2), Verdict::contact);
}

TEST_F(Parts, pairsAcross_haveNoStepLimit) {
  run();
  put(1, 1.125);
  run();
  const StepCap& cap = buffers_.sweep.step.at_poses;
  ASSERT_NE(cap.pair, kNone);
  EXPECT_EQ(setup_.checked[cap.pair].a, LinkId{0});
  EXPECT_EQ(setup_.checked[cap.pair].b, LinkId{1});
  put(0, 0.125);  // without a rounding
  put(1, 1.25);
  run();
  EXPECT_EQ(cap.pair, kNone) << "beside each other they rest; beside others nobody knows";
  for (const std::size_t link : {2U, 3U, 4U}) {
    floatAs(link, kWorldPart);
  }
  run();
  put(0, 0.25);
  put(1, 1.375);
  run();
  EXPECT_NE(cap.pair, kNone) << "they move past the others, which rest";
}

/// base turns a stem, on which a part floats: a, and b, which slides along x up to it.
TEST(PartsOnAWay, pointsOfAPart_areAsSeenFromItsTopWhereverItIsCarried) {
  const std::string ball = "<sphere radius='0.1'/>";
  const std::string slide = "<limit lower='-1' upper='1' velocity='1' effort='1'/>";
  const CycleSetup setup = buildSetup(
      {describeText(robotXml(
          linkXml("base", ball, "<origin xyz='0 0 -9'/>") + "<link name='stem'/>" +
          linkXml("a", ball) + linkXml("rail", ball, "<origin xyz='0 0 9'/>") + linkXml("b", ball) +
          jointXml("turn", "continuous", "base", "stem", "<axis xyz='0 0 1'/>") +
          jointXml("lift", "prismatic", "stem", "a", "<axis xyz='0 0 1'/>" + slide) +
          jointXml("mount", "fixed", "a", "rail", "<origin xyz='0.5 0 0'/>") +
          jointXml("slide", "prismatic", "rail", "b", "<axis xyz='1 0 0'/>" + slide)))},
      textLoader({}), SetupOptions());
  LinkPoses start = makeLinkPoses(setup.model);
  placeLinks(setup.model, JointPositions(setup.model.variable_count, 0.0), {Pose()},
             start.world_from_link);
  std::fill(start.status.begin(), start.status.end(), LinkStatus::known);
  for (std::size_t link = 2; link < 5; ++link) {
    start.part[link] = 2;
  }
  JointPath path;
  path.joints = {*setup.model.findJoint("turn"), *setup.model.findJoint("slide")};
  path.times = {0.0, 1.0};
  path.positions = {0.0, 0.0, 1.5, -0.2};
  TrajectoryOptions options;
  options.margin = 0.5;
  const TrajectoryReport report = checkTrajectory(setup, path, start, options);
  for (std::size_t i = 0; i < setup.checked.size(); ++i) {
    const bool is_own = index(setup.checked[i].a) == 2 && index(setup.checked[i].b) == 4;
    const PairApproach& pair = report.pairs[i];
    if (is_own) {
      EXPECT_EQ(pair.state, ApproachState::clear);
      EXPECT_NEAR(pair.nearest.measured.distance, 0.1, 1e-9);
      EXPECT_LT((pair.nearest.measured.point_on_b - Eigen::Vector3d(0.2, 0, 0)).norm(), 1e-9);
    } else if (index(setup.checked[i].a) == 0) {
      EXPECT_EQ(pair.state, ApproachState::unknown);
    }
  }
}

}  // namespace
}  // namespace collision_monitor
