// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "collision_monitor/motion/speed_scale.h"
#include "pipeline/cycle/judge_pairs.h"
#include "split_links.h"

// A link of several elements slows the robot down as a link for each of them
// would.
namespace collision_monitor::test::measure_told_laws {
namespace {

/// Four links of two meshes. The second mesh has two parts, which two shapes enclose.
Links linksOfTwoElements() {
  Links links(4, std::vector<CollisionElement>(2));
  const Eigen::Vector3d up(0.0, 0.11, 0.0);
  const TriangleMesh part = prismMesh(0.06, 0.05, 3);
  for (std::vector<CollisionElement>& link : links) {
    link[0].geometry = bumpyMesh(0.1, 12);
    link[1].geometry = joined(part, moved(part, Eigen::Vector3d::Zero(), up));
    link[1].link_from_geometry.translation = up;
  }
  return links;
}

/// Two more links overlap. While they part they ask for nothing, but their time to contact is 0.
Links withAContact() {
  Links links = linksOfTwoElements();
  links.resize(6, std::vector<CollisionElement>(2));
  for (std::size_t i = 0; i < 4; ++i) {
    CollisionElement& element = links[4 + i / 2][i % 2];
    element.geometry = Box{Eigen::Vector3d::Constant(0.05)};
    element.link_from_geometry.translation.y() = i % 2 == 0 ? 0.0 : 0.2;
  }
  return links;
}

/// What links are set up with.
struct Conditions {
  double contact_time{0.2};     ///< [s] 0: no verdict depends on times
  std::uint32_t max_shapes{3};  ///< of a link
  RefineGeometry geometry{RefineGeometry::mesh};
};

CycleSetup makeSetup(const Links& links, const Conditions& conditions) {
  SetupOptions options;
  options.default_limits.max_shapes = conditions.max_shapes;
  options.refine.geometry = conditions.geometry;
  CycleSetup setup = linkSetup(links, options);
  setup.refine.budget = kAmple;
  setup.refine.distance = 0.3;
  setup.limits.contact_time = conditions.contact_time;
  setup.limits.warning_time = 2.0 * conditions.contact_time;
  setup.limits.warning_distance = setup.limits.report_distance = 0.2;
  setup.limits.hysteresis = setup.limits.time_hysteresis = 0.0;
  setup.ahead.stop.release_time = 1e-9;  // no scale depends on earlier ones,
  setup.ahead.stop.rest_speed = 0.0;     // and nothing that was stopped rests
  return setup;
}

/// Links 1 and 3 move about beside links 0 and 2, mostly within 2 cm. Link 5 creeps away from 4.
class Hover {
 public:
  explicit Hover(const CycleSetup& setup) : poses_(randomLinkPoses(setup, 0.1, kSeed)) {
    for (std::size_t link = 0; link < poses_.world_from_link.size(); ++link) {
      poses_.velocities.of_link[link] = Twist();
      poses_.velocities.known[link] = 1;
      putBack(link);
    }
    if (poses_.world_from_link.size() > 4) {
      poses_.world_from_link[5].translation.x() = 0.05;
    }
  }

  /// @param gaps [m] of links 0 and 1, and of links 2 and 3
  const LinkPoses& next(const std::array<double, 2>& gaps) {
    poses_.stamp_ns += kPeriod;
    for (std::size_t i = 0; i < gaps.size(); ++i) {
      const std::size_t link = 2 * i + 1;
      if (gaps[i] < 0.002) {
        putBack(link);
      }
      if (gaps[i] > 0.02 || random_() % 20 == 0) {
        twists_[i] = {randomPoint(random_, kSpeed), randomPoint(random_, 1.0)};
        twists_[i].linear.x() = gaps[i] > 0.02 ? -5.0 * kSpeed : twists_[i].linear.x();
      }
      move(twists_[i], link);
    }
    if (poses_.world_from_link.size() > 4) {
      move({{1e-5, 0.0, 0.0}, Eigen::Vector3d::Zero()}, 5);
    }
    return poses_;
  }

 private:
  static constexpr double kSpeed = 0.05;  // [m/s]

  void putBack(std::size_t link) {
    const Eigen::Vector3d place(link % 2 == 0 ? 0.0 : 0.14, static_cast<double>(link / 2), 0.0);
    poses_.world_from_link[link] = {Eigen::Matrix3d::Identity(), place};
  }
  /// @param twist of the link's origin
  void move(const Twist& twist, std::size_t link) {
    constexpr double kSeconds = 1e-9 * static_cast<double>(kPeriod);
    const Eigen::Vector3d& spin = twist.angular;
    const Eigen::AngleAxisd turned(kSeconds * spin.norm(), spin.stableNormalized());
    Pose& pose = poses_.world_from_link[link];
    pose.translation += kSeconds * twist.linear;
    pose.rotation = turned.toRotationMatrix() * pose.rotation;
    poses_.velocities.of_link[link] = {twist.linear - spin.cross(pose.translation), spin};
  }

  LinkPoses poses_;
  Random random_{kSeed};
  std::array<Twist, 2> twists_{};
};

/// What the elements of different links ask for.
struct Asked {
  double scale{1.0};
  double time{std::numeric_limits<double>::infinity()};
  std::array<double, 2> gaps{1.0, 1.0};                             ///< [m] as in Hover
  std::map<std::pair<std::size_t, std::size_t>, Verdict> verdicts;  ///< of links
  std::set<std::pair<std::size_t, std::size_t>> stopped;  ///< links that close at stop_distance
};

Asked askedBy(const CycleSetup& setup, const PairDistances& distances) {
  Asked asked;
  for (const PairDistance& pair : distances.pairs) {
    const CheckedLinkPair& elements = setup.checked[setup.link_pair_of[index(pair.pair)]];
    const std::pair links(index(elements.a) / 2, index(elements.b) / 2);
    if (links.first == links.second) {
      continue;
    }
    const double gap = pair.measured.distance;
    Verdict& verdict = asked.verdicts[links];
    verdict =
        std::max(verdict, verdictFor(gap, pair.time_to_contact, setup.limits, Verdict::clear));
    const double scale = scaleForPair(gap, pair.closing_speed, setup.ahead.stop);
    asked.scale = std::min(asked.scale, scale);
    asked.time = std::min(asked.time, pair.time_to_contact);
    if (links == std::pair<std::size_t, std::size_t>(0, 1) ||
        links == std::pair<std::size_t, std::size_t>(2, 3)) {
      asked.gaps[links.first / 2] = std::min(asked.gaps[links.first / 2], gap);
    }
    if (scale == 0.0) {
      asked.stopped.insert(links);
    }
  }
  return asked;
}

void expectAsked(const CycleSetup& setup, const CycleBuffers& buffers, const Asked& asked) {
  ASSERT_NEAR(buffers.memory.speed.scale, asked.scale, 1e-5);
  if (std::isfinite(asked.time)) {
    ASSERT_NEAR(buffers.events.time_to_contact, asked.time, 1e-5);
  }
  for (std::size_t pair = 0; pair < setup.checked.size(); ++pair) {
    const std::pair links(index(setup.checked[pair].a), index(setup.checked[pair].b));
    ASSERT_EQ(buffers.memory.speed.stopped[pair] != 0, asked.stopped.count(links) != 0);
    const auto verdict = asked.verdicts.find(links);
    ASSERT_EQ(buffers.events.verdicts[pair],
              verdict == asked.verdicts.end() ? Verdict::clear : verdict->second);
  }
}

/// Elements that were measured have one entry, however many shapes enclose
/// them.
void expectOneEntry(const CycleSetup& setup, const PairDistances& distances) {
  std::set<ElementPairIndex> refined;
  for (const PairDistance& pair : distances.pairs) {
    if (pair.is_refined) {
      refined.insert(setup.element_pair_of[index(pair.pair)]);
    }
  }
  std::size_t entries = 0;
  for (const PairDistance& pair : distances.pairs) {
    entries += refined.count(setup.element_pair_of[index(pair.pair)]);
  }
  ASSERT_EQ(entries, refined.size());
}

void expectAsTheElements(const Links& links, const Conditions& conditions, bool tells_all) {
  const CycleSetup setup = makeSetup(links, conditions);
  const CycleSetup split_setup = makeSetup(split(links), conditions);
  CycleBuffers buffers = makeBuffers(setup, BroadPhaseKind::brute_force);
  CycleBuffers split_buffers = makeBuffers(split_setup, BroadPhaseKind::brute_force);
  buffers.refine.tells_all = tells_all;
  Hover hover(setup);
  LinkPoses split_poses = randomLinkPoses(split_setup, 0.1, kSeed);
  Asked asked;
  int slowed = 0;
  int stopped = 0;
  for (int cycle = 0; cycle < 20000; ++cycle) {
    const LinkPoses& poses = hover.next(asked.gaps);
    place(links, poses, split_poses);
    runCycle(setup, poses, buffers);
    runCycle(split_setup, split_poses, split_buffers);
    asked = askedBy(split_setup, split_buffers.distances);
    if (asked.gaps[0] < 0.0 || asked.gaps[1] < 0.0) {
      continue;  // contacts are held
    }
    expectAsked(setup, buffers, asked);
    expectOneEntry(setup, buffers.distances);
    ASSERT_FALSE(::testing::Test::HasFatalFailure()) << cycle;
    slowed += asked.scale > 0.0 && asked.scale < 1.0 ? 1 : 0;
    stopped += asked.stopped.empty() ? 0 : 1;
  }
  EXPECT_GT(slowed, 1000);
  EXPECT_GT(stopped, 1000);
}

void expectAsTheElements(const Links& links, const Conditions& conditions) {
  for (const bool tells_all : {true, false}) {
    SCOPED_TRACE(tells_all ? "somebody listens" : "nobody listens");
    expectAsTheElements(links, conditions, tells_all);
  }
}

TEST(ElementsLaws, scaleTimeAndVerdicts_areThoseOfTheElements) {
  expectAsTheElements(linksOfTwoElements(), {});
}

TEST(ElementsLaws, besideAContact_scaleIsThatOfTheElements) {
  expectAsTheElements(withAContact(), {0.0});
}

TEST(ElementsLaws, withOneShapeForAnElement_scaleTimeAndVerdictsAreThoseOfTheElements) {
  expectAsTheElements(linksOfTwoElements(), {0.2, 2});
}

TEST(ElementsLaws, ofHulls_scaleTimeAndVerdictsAreThoseOfTheElements) {
  expectAsTheElements(linksOfTwoElements(), {0.2, 4, RefineGeometry::hull});
}

}  // namespace
}  // namespace collision_monitor::test::measure_told_laws
