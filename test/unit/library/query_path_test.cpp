// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "collision_monitor/geometry/ids.h"
#include "collision_monitor/robot_query.h"

// Paths of the two boxes of urdf/two_boxes.urdf, which touch where the slide is at -0.1 m.
namespace collision_monitor::test::query_path {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

RobotQuery queryOf(const char* file) {
  MonitorOptions options;
  options.fit_cache = "none";
  const std::filesystem::path folder = std::filesystem::path(COLLISION_MONITOR_SOURCE_DIR) / "urdf";
  return RobotQuery(RobotMonitor::fromFiles({{folder / file}}, options));
}

std::vector<std::string> faultsOf(const WayPoints& path) {
  try {
    queryOf("two_boxes.urdf").checkPath(path);
  } catch (const ArgumentError& fault) {
    return fault.faults();
  }
  return {};
}

/// Each fault holds the words of its place.
void expectFaults(const WayPoints& path, const std::vector<std::string>& words) {
  const std::vector<std::string> faults = faultsOf(path);
  ASSERT_EQ(faults.size(), words.size());
  for (std::size_t i = 0; i < words.size(); ++i) {
    EXPECT_NE(faults[i].find(words[i]), std::string::npos) << faults[i];
  }
}

TEST(QueryPath, boxesThatMeet_touchWhereTheyMustByHand) {
  RobotQuery query = queryOf("two_boxes.urdf");
  const std::vector<double> positions{0.0, 0.0, -0.2, 0.0};
  const std::vector<double> times{1.0, 3.0};
  const PathAnswer answer = query.checkPath({positions, times});
  EXPECT_EQ(answer.verdict, Verdict::contact);
  ASSERT_NE(answer.first_contact, kNone);
  EXPECT_EQ(answer.pairs[answer.first_contact].state, ApproachState::contact);
  EXPECT_NEAR(answer.pairs[answer.first_contact].time, 2.0, 1e-4);
  const PathAnswer by_count = query.checkPath({positions});
  EXPECT_NEAR(by_count.pairs[by_count.first_contact].time, 0.5, 1e-4);
}

TEST(QueryPath, boxesThatComeNear_areAWarningWithTheirLeastDistance) {
  RobotQuery query = queryOf("two_boxes.urdf");
  const std::vector<double> positions{0.0, 0.0, -0.07, 0.0, 0.0, 0.0};
  const PathAnswer answer = query.checkPath({positions});
  EXPECT_EQ(answer.verdict, Verdict::warning);
  EXPECT_EQ(answer.first_contact, kNone);
  double least = 1.0;
  for (const PairOnPath& pair : answer.pairs) {
    EXPECT_EQ(pair.state, ApproachState::clear);
    least = std::min(least, pair.at_least);
  }
  EXPECT_NEAR(least, 0.03, 2e-3);
  const std::vector<double> away{0.0, 0.0, 0.3, 1.0};
  EXPECT_EQ(query.checkPath({away}).verdict, Verdict::clear);
}

TEST(QueryPath, cubics_swingBeyondTheirWayPoints) {
  RobotQuery query = queryOf("two_boxes.urdf");
  const std::vector<double> positions{0.0, 0.0, 0.0, 0.0};
  const std::vector<double> times{0.0, 1.0};
  const std::vector<double> velocities{-1.0, 0.0, 1.0, 0.0};  // to -0.25 m in between
  EXPECT_EQ(query.checkPath({positions, times, velocities}).verdict, Verdict::contact);
}

TEST(QueryPath, numberThatIsNotFinite_isUnknownNotClear) {
  RobotQuery query = queryOf("two_boxes.urdf");
  const std::vector<double> positions{0.0, 0.0, kNaN, 0.0};
  const PathAnswer answer = query.checkPath({positions});
  EXPECT_EQ(answer.verdict, Verdict::unknown);
  for (const PairOnPath& pair : answer.pairs) {
    EXPECT_EQ(pair.state, ApproachState::unknown);
    EXPECT_EQ(pair.nearest.quality, Quality::unknown);
  }
}

TEST(QueryPath, badPaths_nameAllFaults) {
  const std::vector<double> two{0.0, 0.0, 0.1, 0.0};
  const std::vector<double> none;
  expectFaults({none}, {"at least one way-point"});
  const std::vector<double> three{0.0, 1.0, 2.0};
  expectFaults({three}, {"has 3 numbers"});
  const std::vector<double> one{0.0};
  expectFaults({two, one, one}, {"`times`", "`velocities`"});
  const std::vector<double> back{1.0, 0.5};
  const std::vector<double> wild{0.0, 0.0, kNaN, 1e10};
  expectFaults({two, back, wild}, {"times[1] is 0.5", "velocities[1][0]", "velocities[1][1]"});
}

TEST(QueryPath, badOptions_nameAllFaults) {
  RobotQuery query = queryOf("two_boxes.urdf");
  const std::vector<double> two{0.0, 0.0, 0.1, 0.0};
  TrajectoryOptions options;
  options.margin = kNaN;
  options.resolution = 0.0;
  options.tolerance = -1.0;
  try {
    query.checkPath({two}, options);
    FAIL() << "accepted";
  } catch (const ArgumentError& fault) {
    EXPECT_EQ(fault.faults().size(), 3U);
  }
}

TEST(QueryPath, planarJointThatMoves_isRefused) {
  RobotQuery query = queryOf("three_capsules.urdf");
  JointPositions first = query.monitor().defaultState();
  JointPositions both = first;
  both.insert(both.end(), first.begin(), first.end());
  EXPECT_NO_THROW(query.checkPath({both}));
  const auto& variables = query.monitor().variables();
  for (std::size_t i = 0; i < variables.size(); ++i) {
    if (variables[i].name == "drift/y") {
      both[variables.size() + i] += 0.1;
    }
  }
  EXPECT_THROW(query.checkPath({both}), ArgumentError);
}

TEST(QueryPath, progressThatGivesUp_leavesPairsUndecided) {
  RobotQuery query = queryOf("two_boxes.urdf");
  std::vector<double> positions;
  for (int i = 0; i < 50; ++i) {
    positions.push_back(i % 2 == 0 ? 0.0 : 0.1);
    positions.push_back(0.0);
  }
  TrajectoryOptions options;
  options.progress = [](double) { return false; };
  EXPECT_EQ(query.checkPath({positions}, options).verdict, Verdict::unknown);
}

}  // namespace
}  // namespace collision_monitor::test::query_path
