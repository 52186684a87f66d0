// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/robot_query.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>

#include "collision_monitor/geometry/ids.h"

// Two boxes of known distance; urdf/two_boxes.urdf works them out.
namespace collision_monitor::test::robot_query {
namespace {

const std::filesystem::path kRobots = std::filesystem::path(COLLISION_MONITOR_SOURCE_DIR) / "urdf";
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

RobotMonitor monitorOf(const char* file, const Limits& limits = Limits()) {
  MonitorOptions options;
  options.fit_cache = "none";
  options.limits = limits;
  return RobotMonitor::fromFiles({{kRobots / file}}, options);
}

/// The pair of the two boxes.
std::uint32_t boxes(const RobotMonitor& monitor) {
  const LinkId a = *monitor.model().findLink("box_a");
  const LinkId b = *monitor.model().findLink("box_b");
  for (std::uint32_t i = 0; i < monitor.pairs().size(); ++i) {
    if (monitor.pairs()[i].a == a && monitor.pairs()[i].b == b) {
      return i;
    }
  }
  return kNone;
}

TEST(RobotQuery, boxesApart_distanceIsThatByHand) {
  RobotQuery query(monitorOf("two_boxes.urdf"));
  const DistanceTable& table = query.distances({-0.02, 0.0});
  ASSERT_EQ(table.pairs.size(), query.monitor().pairs().size());
  const MeasuredPair& pair = table.pairs[boxes(query.monitor())];
  EXPECT_EQ(pair.pair, boxes(query.monitor()));
  EXPECT_EQ(pair.quality, Quality::exact);
  EXPECT_EQ(pair.verdict, Verdict::clear);
  EXPECT_NEAR(pair.measured.distance, 0.08, 1e-12);
  EXPECT_NEAR(pair.measured.normal_a_to_b.x(), 1.0, 1e-12);
  EXPECT_NEAR(pair.measured.point_on_a.x(), 0.1, 1e-12);
  EXPECT_NEAR(pair.measured.point_on_b.x(), 0.18, 1e-12);
}

TEST(RobotQuery, pairsBeyondTheDistance_areLeftOut) {
  RobotQuery query(monitorOf("two_boxes.urdf"));
  EXPECT_EQ(query.distances({0.0, 0.0}, {0.11}).pairs.size(), 1U);
  EXPECT_EQ(query.distances({0.0, 0.0}, {0.09}).pairs.size(), 0U);
}

TEST(RobotQuery, verdicts_followTheLimits) {
  RobotQuery query(monitorOf("two_boxes.urdf"));
  EXPECT_EQ(query.verdict({0.0, 0.0}), Verdict::clear);
  EXPECT_EQ(query.verdict({-0.06, 0.0}), Verdict::warning);
  EXPECT_EQ(query.verdict({-0.13, 0.0}), Verdict::contact);
  EXPECT_EQ(query.verdict({kNaN, 0.0}), Verdict::unknown);
}

TEST(RobotQuery, nearest_isThePairOfTheBoxes) {
  RobotQuery query(monitorOf("two_boxes.urdf"));
  const double kTurn = 0.25 * std::acos(-1.0);
  const MeasuredPair& nearest = query.nearest({0.0, kTurn});
  EXPECT_EQ(nearest.pair, boxes(query.monitor()));
  EXPECT_NEAR(nearest.measured.distance, 0.15 - 0.05 * std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(query.nearest({-0.13, 0.0}).measured.distance, -0.03, 1e-9);
}

TEST(RobotQuery, contacts_haveDepthAndPointsBetweenTheSurfaces) {
  RobotQuery query(monitorOf("two_boxes.urdf"));
  EXPECT_TRUE(query.contacts({0.0, 0.0}).empty());
  const std::vector<TouchingPair>& contacts = query.contacts({-0.13, 0.0});
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_NEAR(contacts[0].between.measured.distance, -0.03, 1e-9);
  ASSERT_EQ(contacts[0].point_count, 4U);
  for (const Eigen::Vector3d& point : contacts[0].points) {
    EXPECT_NEAR(point.x(), 0.085, 1e-9);
    EXPECT_NEAR(std::abs(point.y()), 0.05, 1e-9);
  }
}

TEST(RobotQuery, gradients_areThoseOfDifferences) {
  RobotQuery query(monitorOf("two_boxes.urdf"));
  const JointPositions state{0.01, 0.3};
  const DistanceTable table = query.distances(state, {1.0, true});
  ASSERT_EQ(table.gradients.size(), 2 * table.pairs.size());
  constexpr double kStep = 1e-6;
  for (std::size_t variable = 0; variable < 2; ++variable) {
    JointPositions after = state;
    after[variable] += kStep;
    const DistanceTable& moved = query.distances(after, {1.0});
    ASSERT_EQ(moved.pairs.size(), table.pairs.size());
    for (std::size_t i = 0; i < table.pairs.size(); ++i) {
      const double difference =
          (moved.pairs[i].measured.distance - table.pairs[i].measured.distance) / kStep;
      EXPECT_NEAR(table.gradients[2 * i + variable], difference, 1e-5);
    }
  }
}

TEST(RobotQuery, numberThatIsNotFinite_leavesItsPairsUnknown) {
  RobotQuery query(monitorOf("two_boxes.urdf"));
  for (const double number : {kNaN, std::numeric_limits<double>::infinity(), 1e300}) {
    const DistanceTable& table = query.distances({number, 0.0}, {0.01, true});
    ASSERT_EQ(table.pairs.size(), 1U);
    for (const MeasuredPair& pair : table.pairs) {
      EXPECT_EQ(pair.quality, Quality::unknown);
      EXPECT_EQ(pair.verdict, Verdict::unknown);
      EXPECT_TRUE(std::isnan(pair.measured.distance));
    }
    EXPECT_TRUE(std::isnan(table.gradients.at(0)));
    EXPECT_EQ(query.contacts({0.0, number}).size(), 1U);
    EXPECT_EQ(query.nearest({0.0, number}).quality, Quality::unknown);
    const std::vector<StateAnswer> answers = query.check({0.0, 0.0, number, 0.0});
    EXPECT_EQ(answers.at(0).verdict, Verdict::clear);
    EXPECT_EQ(answers.at(1).verdict, Verdict::unknown);
    EXPECT_EQ(answers.at(1).pair, kNone);
  }
}

TEST(RobotQuery, badCalls_areRefusedAndChangeNothing) {
  RobotQuery query(monitorOf("two_boxes.urdf"));
  EXPECT_THROW(query.distances({0.0}), ArgumentError);
  EXPECT_THROW(query.distances({0.0, 0.0}, {kNaN}), ArgumentError);
  EXPECT_THROW(query.nearest({0.0, 0.0, 0.0}), ArgumentError);
  EXPECT_THROW(query.contacts({}), ArgumentError);
  EXPECT_THROW(query.linkPoses({}), ArgumentError);
  EXPECT_THROW(query.verdict({}), ArgumentError);
  EXPECT_THROW(query.check({0.0, 0.0, 0.0}), ArgumentError);
  EXPECT_TRUE(query.check({}).empty());
  EXPECT_EQ(query.verdict({0.0, 0.0}), Verdict::clear);
}

TEST(RobotQuery, queryOutlivesItsMonitor) {
  std::optional<RobotMonitor> monitor = monitorOf("two_boxes.urdf");
  RobotQuery query(*monitor);
  monitor.reset();
  EXPECT_EQ(query.verdict({-0.13, 0.0}), Verdict::contact);
  RobotQuery moved = std::move(query);
  EXPECT_NEAR(moved.nearest({0.0, 0.0}).measured.distance, 0.1, 1e-9);
}

TEST(RobotQuery, linkPoses_areThoseOfTheModel) {
  RobotQuery query(monitorOf("two_boxes.urdf"));
  const std::size_t box_b = index(*query.monitor().model().findLink("box_b"));
  EXPECT_NEAR(query.linkPoses({0.1, 0.0})[box_b].translation.x(), 0.35, 1e-12);
}

TEST(RobotQuery, progress_growsAndCanGiveUp) {
  RobotQuery query(monitorOf("two_boxes.urdf"));
  const std::vector<double> states(2 * 1000, 0.0);
  StatesRequest request;
  request.threads = 1;
  double last = 0.0;
  request.progress = [&](double done) {
    EXPECT_GT(done, last);
    last = done;
    return true;
  };
  EXPECT_EQ(query.check(states, request).size(), 1000U);
  EXPECT_EQ(last, 1.0);
  request.progress = [](double) { return false; };
  EXPECT_TRUE(query.check(states, request).empty());
}

TEST(RobotQuery, nothingChecked_isUnknown) {
  MonitorOptions options;
  options.fit_cache = "none";
  options.ignored_pairs = {{"*", "*"}};
  RobotQuery query(RobotMonitor::fromFiles({{kRobots / "two_boxes.urdf"}}, options));
  EXPECT_TRUE(query.monitor().pairs().empty());
  EXPECT_EQ(query.verdict({0.0, 0.0}), Verdict::unknown);
  EXPECT_EQ(query.nearest({0.0, 0.0}).pair, kNone);
  EXPECT_TRUE(query.distances({0.0, 0.0}).pairs.empty());
}

}  // namespace
}  // namespace collision_monitor::test::robot_query
