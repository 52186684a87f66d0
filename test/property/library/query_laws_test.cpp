// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <thread>

#include "collision_monitor/geometry/ids.h"
#include "collision_monitor/robot_query.h"
#include "pipeline/cycle/place_bodies.h"
#include "pipeline/pair_search/joint_ranges.h"
#include "pipeline/refine/measure_elements.h"
#include "support/allocation_guard.h"
#include "support/fixed_seed.h"
#include "support/random_poses.h"
#include "support/robots/file_loader.h"

// What a query answers, held to the core's routines and to itself.
namespace collision_monitor::test::query_laws {
namespace {

/// A robot for the library, and its set-up for the core.
struct Scene {
  RobotMonitor monitor;
  CycleSetup setup;
  Random random{kSeed};
  std::vector<JointRange> ranges{jointRanges(setup.model)};

  JointPositions draw() { return drawState(setup.model, ranges, random); }
  std::vector<double> drawMany(std::size_t count) {
    std::vector<double> states;
    for (std::size_t i = 0; i < count; ++i) {
      const JointPositions state = draw();
      states.insert(states.end(), state.begin(), state.end());
    }
    return states;
  }
};

/// @param name as RobotFile::name
Scene sceneOf(const std::string& name) {
  for (const RobotFile& robot : allRobotFiles()) {
    if (robot.name == name) {
      MonitorOptions options;
      options.fit_cache = "none";
      options.load_resource = fileLoader(robot.package_root);
      SetupOptions for_core;
      for_core.is_continuous = false;
      return Scene{RobotMonitor({describe(robot)}, options),
                   buildSetup({describe(robot)}, options.load_resource, for_core)};
    }
  }
  throw std::runtime_error("no robot " + name);
}

/// Robots of primitives, of hulls and, if there is shared data, of concave meshes.
std::vector<std::string> robotNames() {
  std::vector<std::string> names{"urdf/arm6.urdf", "urdf/humanoid.urdf"};
  if (sharedDataDir()) {
    names.insert(names.end(), {"panda_moveit/panda.urdf", "go2/go2.urdf"});
  }
  std::vector<std::string> there;
  for (const RobotFile& robot : allRobotFiles()) {
    if (std::find(names.begin(), names.end(), robot.name) != names.end()) {
      there.push_back(robot.name);
    }
  }
  return there;
}

/// The distance of each pair of links by the plain routine, one pair of elements after the other,
/// from no warm start.
std::vector<double> coldDistances(const CycleSetup& setup, const JointPositions& state) {
  std::vector<Pose> world_from_link;
  placeLinks(setup.model, state, std::vector<Pose>(setup.model.robots.size()), world_from_link);
  std::vector<double> least(setup.checked.size(), std::numeric_limits<double>::infinity());
  const auto scratch = std::make_unique<RefineScratch>();
  const auto poseOf = [&](const Element& element) {
    return world_from_link[index(element.link)] * element.link_from_element;
  };
  for (const ElementPair& pair : setup.element_pairs) {
    const Element& a = setup.elements[index(pair.a)];
    const Element& b = setup.elements[index(pair.b)];
    RefineMemory memory;
    ElementSearch search{std::numeric_limits<std::uint32_t>::max(), memory, *scratch};
    const Pose world_from_a = poseOf(a);
    const Pose world_from_b = poseOf(b);
    const ElementDistance found = measureElements({a, world_from_a}, {b, world_from_b}, search);
    least[pair.link_pair] = std::min(least[pair.link_pair], found.measured.distance);
  }
  return least;
}

TEST(QueryLaws, distances_areThoseOfEachPairAlone) {
  for (const std::string& name : robotNames()) {
    SCOPED_TRACE(name);
    Scene scene = sceneOf(name);
    RobotQuery query(scene.monitor);
    for (int i = 0; i < 30; ++i) {
      const JointPositions state = scene.draw();
      const std::vector<double> expected = coldDistances(scene.setup, state);
      const DistanceTable& table = query.distances(state);
      ASSERT_EQ(table.pairs.size(), expected.size());
      for (const MeasuredPair& pair : table.pairs) {
        const double distance = pair.measured.distance;
        if (expected[pair.pair] > 0.0) {
          EXPECT_NEAR(distance, expected[pair.pair], 1e-8);
        } else {
          EXPECT_LE(distance, 1e-8);
        }
        EXPECT_LT((pair.measured.point_on_a + distance * pair.measured.normal_a_to_b -
                   pair.measured.point_on_b)
                      .norm(),
                  1e-8);
      }
    }
  }
}

TEST(QueryLaws, nearerQuestions_areAnsweredAsAll) {
  for (const std::string& name : robotNames()) {
    SCOPED_TRACE(name);
    Scene scene = sceneOf(name);
    RobotQuery query(scene.monitor);
    const double warning = scene.monitor.limits().warning_distance;
    for (int i = 0; i < 30; ++i) {
      const JointPositions state = scene.draw();
      const DistanceTable all = query.distances(state);
      double least = std::numeric_limits<double>::infinity();
      Verdict worst = Verdict::clear;
      bool is_at_threshold = false;
      for (const MeasuredPair& pair : all.pairs) {
        least = std::min(least, pair.measured.distance);
        worst = std::max(worst, pair.verdict);
        is_at_threshold = is_at_threshold || std::abs(pair.measured.distance - warning) < 1e-7 ||
                          std::abs(pair.measured.distance) < 1e-7;
      }
      const double nearest = query.nearest(state).measured.distance;
      EXPECT_TRUE(least > 0.0 ? std::abs(nearest - least) < 1e-8 : nearest <= 1e-8)
          << nearest << " " << least;
      std::size_t within = 0;
      for (const MeasuredPair& pair : all.pairs) {
        within += pair.measured.distance <= 0.2 ? 1 : 0;
      }
      if (!is_at_threshold) {
        EXPECT_EQ(query.verdict(state), worst);
        EXPECT_EQ(query.contacts(state).empty(), worst != Verdict::contact);
        EXPECT_EQ(query.distances(state, {0.2}).pairs.size(), within);
      }
    }
  }
}

bool areSameBytes(const std::vector<StateAnswer>& one, const std::vector<StateAnswer>& other) {
  return one.size() == other.size() &&
         std::equal(one.begin(), one.end(), other.begin(),
                    [](const StateAnswer& x, const StateAnswer& y) {
                      return x.verdict == y.verdict && x.quality == y.quality && x.pair == y.pair &&
                             std::memcmp(&x.distance, &y.distance, sizeof x.distance) == 0;
                    });
}

TEST(QueryLaws, manyStates_areAnsweredAsOneByOneByAnyNumberOfThreads) {
  for (const std::string& name : robotNames()) {
    for (const StateQuestion question : {StateQuestion::contact, StateQuestion::nearest}) {
      SCOPED_TRACE(name);
      Scene scene = sceneOf(name);
      RobotQuery query(scene.monitor);
      std::vector<double> states = scene.drawMany(300);
      const std::size_t n = scene.setup.model.variable_count;
      for (std::size_t i = 0; i < 300; i += 11) {
        states[i * n] = 1e9;  // such angles have a sine of their own, their neighbours have not
      }
      StatesRequest request{question, 1, {}};
      const std::vector<StateAnswer> expected = query.check(states, request);
      for (const unsigned threads : {2U, 7U, 0U}) {
        request.threads = threads;
        EXPECT_TRUE(areSameBytes(query.check(states, request), expected)) << threads;
      }
      std::vector<StateAnswer> alone;
      for (std::size_t i = 0; i < 300; ++i) {
        alone.push_back(query.check(Numbers(states.data() + i * n, n), request).at(0));
      }
      EXPECT_TRUE(areSameBytes(alone, expected));
    }
  }
}

TEST(QueryLaws, oddNumbers_areUnknownOrMeasuredButNeverLeftOut) {
  constexpr double kOdd[] = {0.0,    std::numeric_limits<double>::quiet_NaN(),
                             1e300,  -std::numeric_limits<double>::infinity(),
                             1e9,    -1e9,
                             1e-300, 0.5};
  for (const char* name : {"urdf/humanoid.urdf", "urdf/three_capsules.urdf"}) {
    SCOPED_TRACE(name);
    Scene scene = sceneOf(name);
    RobotQuery query(scene.monitor);
    for (int i = 0; i < 1000; ++i) {
      JointPositions state = scene.draw();
      for (int k = 0; k < 3; ++k) {
        state[scene.random() % state.size()] = kOdd[scene.random() % std::size(kOdd)];
      }
      const bool is_sound = std::all_of(state.begin(), state.end(),
                                        [](double number) { return std::abs(number) <= 1e9; });
      const DistanceTable& table = query.distances(state, {0.1, true});
      for (const MeasuredPair& pair : table.pairs) {
        EXPECT_EQ(std::isnan(pair.measured.distance), pair.quality == Quality::unknown);
        EXPECT_EQ(pair.verdict == Verdict::unknown, pair.quality == Quality::unknown);
      }
      EXPECT_EQ(query.distances(state).pairs.size(), scene.setup.checked.size());
      EXPECT_TRUE(is_sound || query.verdict(state) >= Verdict::unknown);
      EXPECT_TRUE(is_sound || query.check(state).at(0).verdict == Verdict::unknown);
      query.nearest(state);
      query.contacts(state);
    }
  }
}

TEST(QueryLaws, twoThreads_shareOneMonitor) {
  Scene scene = sceneOf("urdf/arm6.urdf");
  const std::vector<double> states = scene.drawMany(200);
  const std::size_t n = scene.setup.model.variable_count;
  const auto run = [&](std::vector<double>& found) {
    RobotQuery query(scene.monitor);
    for (std::size_t i = 0; i < 200; ++i) {
      for (const MeasuredPair& pair : query.distances(Numbers(states.data() + i * n, n)).pairs) {
        found.push_back(pair.measured.distance);
      }
    }
  };
  std::vector<double> expected;
  std::vector<double> one;
  std::vector<double> other;
  run(expected);
  std::thread first(run, std::ref(one));
  std::thread second(run, std::ref(other));
  first.join();
  second.join();
  EXPECT_EQ(one, expected);
  EXPECT_EQ(other, expected);
}

TEST(QueryLaws, calls_doNotAllocateAfterTheFirst) {
  Scene scene = sceneOf("urdf/arm6.urdf");
  RobotQuery query(scene.monitor);
  std::vector<JointPositions> states;
  for (int i = 0; i < 100; ++i) {
    states.push_back(scene.draw());
  }
  const auto ask = [&](const JointPositions& state) {
    query.distances(state, {0.5, true});
    query.distances(state);
    query.nearest(state);
    query.contacts(state);
    query.verdict(state);
  };
  ask(states.front());
  const AllocationGuard guard;
  for (int i = 0; i < 10000; ++i) {
    ask(states[static_cast<std::size_t>(i) % states.size()]);
  }
  EXPECT_EQ(guard.count(), 0U);
}

}  // namespace
}  // namespace collision_monitor::test::query_laws
