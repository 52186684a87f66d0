// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "collision_monitor/motion/speed_scale.h"
#include "pipeline/cycle/judge_pairs.h"
#include "split_links.h"

// Links of many convex parts are told as links of one part each would be, though most parts are
// passed over: they close too slowly, or others of their links are nearer.
namespace collision_monitor::test::lone_bodies_laws {
namespace {

using measure_told_laws::Drift;
using measure_told_laws::kAmple;
using measure_told_laws::kPeriod;
using measure_told_laws::Links;
using measure_told_laws::place;
using measure_told_laws::split;

constexpr std::size_t kParts = 9;  // of a link

/// Parts in three rows of three: meshes, boxes or both.
Links linksOfParts(bool has_meshes, bool has_boxes) {
  Links links(4, std::vector<CollisionElement>(kParts));
  for (std::size_t link = 0; link < links.size(); ++link) {
    for (std::size_t i = 0; i < kParts; ++i) {
      CollisionElement& part = links[link][i];
      if (has_boxes && !(has_meshes && i % 2 == 0)) {
        const double length = i == 0 ? 0.2 : 0.03;  // ends move fast where the link turns
        part.geometry = Box{{length, 0.02, 0.01 * static_cast<double>(i % 3 + 1)}};
      } else {
        part.geometry = prismMesh(0.035, 0.04, static_cast<int>(3 + (i + link) % 2));
      }
      part.link_from_geometry.translation = {0.09 * static_cast<double>(i % 3),
                                             0.09 * static_cast<double>(i / 3), 0.0};
    }
  }
  return links;
}

struct Conditions {
  RefineGeometry geometry{RefineGeometry::mesh};
  double padding{0.0};       ///< [m]
  double warning_time{0.0};  ///< [s] 0: no verdict depends on times
  bool hides_velocities{false};
};

CycleSetup makeSetup(const Links& links, const Conditions& conditions) {
  SetupOptions options;
  options.default_limits.max_shapes = 1;
  options.refine.geometry = conditions.geometry;
  options.padding = conditions.padding;
  CycleSetup setup = linkSetup(links, options);
  setup.refine.budget = kAmple;
  setup.limits.warning_time = conditions.warning_time;
  setup.limits.hysteresis = setup.limits.time_hysteresis = 0.0;
  setup.ahead.stop.release_time = 1e-9;  // no scale depends on earlier ones,
  setup.ahead.stop.rest_speed = 0.0;     // and nothing that was stopped rests
  return setup;
}

using TwoLinks = std::pair<std::size_t, std::size_t>;

/// What the parts of different links ask for.
struct Asked {
  double scale{1.0};
  double time{std::numeric_limits<double>::infinity()};
  std::map<TwoLinks, double> nearest;  ///< [m]
  std::map<TwoLinks, Verdict> verdicts;
  bool has_unknown_time{false};
  bool overlap{false};
};

Asked askedBy(const CycleSetup& setup, const PairDistances& distances) {
  Asked asked;
  for (const PairDistance& pair : distances.pairs) {
    const CheckedLinkPair& parts = setup.checked[setup.link_pair_of[index(pair.pair)]];
    const TwoLinks links(index(parts.a) / kParts, index(parts.b) / kParts);
    if (links.first == links.second) {
      continue;
    }
    const double gap = pair.measured.distance;
    const StopRule& rule = setup.ahead.stop;
    asked.scale =
        std::min(asked.scale, std::isnan(pair.closing_speed)
                                  ? scaleForUnknownSpeed(gap, setup.limits.warning_distance, rule)
                                  : scaleForPair(gap, pair.closing_speed, rule));
    asked.has_unknown_time = asked.has_unknown_time || std::isnan(pair.time_to_contact);
    asked.time = std::fmin(asked.time, pair.time_to_contact);
    const auto nearest = asked.nearest.emplace(links, gap).first;
    nearest->second = std::min(nearest->second, gap);
    Verdict& verdict = asked.verdicts[links];
    verdict =
        std::max(verdict, verdictFor(gap, pair.time_to_contact, setup.limits, Verdict::clear));
    asked.overlap = asked.overlap || gap <= 0.0;
  }
  return asked;
}

/// The nearest of two links is told up to report_distance, and the nearest of all in any case.
void expectNearest(const CycleSetup& setup, const CycleBuffers& buffers, const Asked& asked) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t pair = 0; pair < setup.checked.size(); ++pair) {
    const auto wanted =
        asked.nearest.find({index(setup.checked[pair].a), index(setup.checked[pair].b)});
    if (wanted == asked.nearest.end() || wanted->second > setup.limits.report_distance) {
      continue;
    }
    least = std::min(least, wanted->second);
    if (buffers.refine.tells_all) {
      ASSERT_NE(buffers.events.closest[pair], kNone);
      ASSERT_NEAR(buffers.distances.pairs[buffers.events.closest[pair]].measured.distance,
                  wanted->second, 1e-6);
    }
  }
  if (std::isfinite(least)) {
    ASSERT_NE(buffers.events.closest_of_all, kNone);
    ASSERT_NEAR(buffers.distances.pairs[buffers.events.closest_of_all].measured.distance, least,
                1e-6);
  }
}

void expectAsked(const CycleSetup& setup, const CycleBuffers& buffers, const Asked& asked) {
  ASSERT_NEAR(buffers.memory.speed.scale, asked.scale, 1e-5);
  if (std::isfinite(asked.time)) {
    ASSERT_NEAR(buffers.events.time_to_contact, asked.time, 1e-5);
  } else if (asked.has_unknown_time) {
    ASSERT_TRUE(std::isnan(buffers.events.time_to_contact));
  }
  for (std::size_t pair = 0; pair < setup.checked.size(); ++pair) {
    const auto verdict =
        asked.verdicts.find({index(setup.checked[pair].a), index(setup.checked[pair].b)});
    ASSERT_EQ(buffers.events.verdicts[pair],
              verdict == asked.verdicts.end() ? Verdict::clear : verdict->second);
  }
  expectNearest(setup, buffers, asked);
}

void expectAsTheParts(const Links& links, const Conditions& conditions, bool tells_all) {
  const CycleSetup setup = makeSetup(links, conditions);
  const CycleSetup split_setup = makeSetup(split(links), conditions);
  CycleBuffers buffers = makeBuffers(setup, BroadPhaseKind::brute_force);
  CycleBuffers split_buffers = makeBuffers(split_setup, BroadPhaseKind::brute_force);
  buffers.refine.tells_all = tells_all;
  Drift drift(setup, 5.0, 0.8);
  if (conditions.hides_velocities) {
    drift.hideVelocities();
  }
  LinkPoses split_poses = randomLinkPoses(split_setup, 0.1, kSeed);
  int slowed = 0;
  int soon = 0;
  for (int cycle = 0; cycle < 2000; ++cycle) {
    const LinkPoses& poses = drift.next();
    place(links, poses, split_poses);
    runCycle(setup, poses, buffers);
    runCycle(split_setup, split_poses, split_buffers);
    const Asked asked = askedBy(split_setup, split_buffers.distances);
    if (asked.overlap) {
      continue;
    }
    expectAsked(setup, buffers, asked);
    ASSERT_FALSE(::testing::Test::HasFatalFailure()) << cycle;
    slowed += asked.scale > 0.0 && asked.scale < 1.0 ? 1 : 0;
    soon += std::isfinite(asked.time) ? 1 : 0;
  }
  EXPECT_GT(slowed, 100);
  EXPECT_GT(soon, 200);
}

void expectAsTheParts(const Links& links, const Conditions& conditions) {
  for (const bool tells_all : {true, false}) {
    SCOPED_TRACE(tells_all ? "somebody listens" : "nobody listens");
    expectAsTheParts(links, conditions, tells_all);
  }
}

/// The first parts of both links pass: one has a hole that the other is before. Their shapes are
/// nearest, the other parts are nearer than the first parts themselves.
Links linksWithAHole() {
  Links links(2, std::vector<CollisionElement>(kParts));
  const TriangleMesh bar = prismMesh(0.02, 0.02, 4);
  links[1][0].geometry = joined(bar, moved(bar, Eigen::Vector3d::Zero(), {0.0, 0.2, 0.0}));
  links[1][0].link_from_geometry.translation.y() = -0.1;
  links[0][0].geometry = Box{Eigen::Vector3d::Constant(0.01)};
  for (std::size_t i = 1; i < kParts; ++i) {
    for (std::size_t link = 0; link < 2; ++link) {
      links[link][i].geometry = Box{Eigen::Vector3d::Constant(0.01)};
      links[link][i].link_from_geometry.translation.z() = static_cast<double>(i);
    }
  }
  return links;
}

TEST(LoneBodiesLaws, whereAShapeIsMuchNearerThanItsPart_nearestIsThatOfTheParts) {
  const Links links = linksWithAHole();
  const CycleSetup setup = makeSetup(links, {});
  const CycleSetup split_setup = makeSetup(split(links), {});
  CycleBuffers buffers = makeBuffers(setup, BroadPhaseKind::brute_force);
  CycleBuffers split_buffers = makeBuffers(split_setup, BroadPhaseKind::brute_force);
  LinkPoses poses = randomLinkPoses(setup, 0.1, kSeed);
  LinkPoses split_poses = randomLinkPoses(split_setup, 0.1, kSeed);
  poses.world_from_link = {Pose(), Pose()};
  poses.velocities.of_link = {Twist(), Twist()};
  poses.velocities.known = {1, 1};
  for (int cycle = 0; cycle < 400; ++cycle) {
    poses.stamp_ns += kPeriod;
    poses.world_from_link[1].translation.x() = 0.12 - 0.0002 * cycle;
    place(links, poses, split_poses);
    runCycle(setup, poses, buffers);
    runCycle(split_setup, split_poses, split_buffers);
    expectNearest(setup, buffers, askedBy(split_setup, split_buffers.distances));
    ASSERT_FALSE(::testing::Test::HasFatalFailure()) << cycle;
  }
}

TEST(LoneBodiesLaws, ofConvexMeshes_distancesTimeAndScaleAreThoseOfTheParts) {
  expectAsTheParts(linksOfParts(true, false), {});
}

TEST(LoneBodiesLaws, ofBoxes_distancesTimeAndScaleAreThoseOfTheParts) {
  expectAsTheParts(linksOfParts(false, true), {});
}

TEST(LoneBodiesLaws, ofBoth_withTimesAndPadding_distancesTimeAndScaleAreThoseOfTheParts) {
  expectAsTheParts(linksOfParts(true, true), {RefineGeometry::mesh, 0.01, 0.3});
}

TEST(LoneBodiesLaws, ofHulls_whileVelocitiesAreUnknown_timeAndScaleAreThoseOfTheParts) {
  expectAsTheParts(linksOfParts(true, true), {RefineGeometry::hull, 0.0, 0.3, true});
}

}  // namespace
}  // namespace collision_monitor::test::lone_bodies_laws
