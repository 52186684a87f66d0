// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/trajectory/check_trajectory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "collision_monitor/geometry/ids.h"
#include "geometry/constants.h"
#include "support/robots/two_link_arm.h"

namespace collision_monitor::test {
namespace {

class CheckTrajectoryTest : public testing::Test {
 protected:
  CheckTrajectoryTest() {
    path_.joints = {*setup_.model.findJoint("shoulder"), *setup_.model.findJoint("elbow")};
    options_.margin = 0.05;
  }
  /// Way-points one second apart, by shoulder and elbow.
  void go(const std::vector<std::pair<double, double>>& waypoints) {
    for (const auto& [shoulder, elbow] : waypoints) {
      path_.times.push_back(static_cast<double>(path_.times.size()));
      path_.positions.insert(path_.positions.end(), {shoulder, elbow});
    }
  }
  TrajectoryReport check() {
    LinkPoses start = makeLinkPoses(setup_.model);
    JointPositions positions(setup_.model.variable_count, 0.0);
    positions[setup_.model.joint(*setup_.model.findJoint("shoulder")).first_variable] = shoulder_;
    placeLinks(setup_.model, positions, {Pose()}, start.world_from_link);
    std::fill(start.status.begin(), start.status.end(), LinkStatus::known);
    start.world_from_link[index(setup_.model.findLink("post").value())].translation += post_off_;
    if (!lost_.empty()) {
      start.status[index(setup_.model.findLink(lost_).value())] = LinkStatus::stale;
    }
    return checkTrajectory(setup_, path_, start, options_);
  }
  const PairApproach& of(const TrajectoryReport& report, const std::string& a,
                         const std::string& b) {
    for (std::size_t i = 0; i < setup_.checked.size(); ++i) {
      if (setup_.model.link(setup_.checked[i].a).name == a &&
          setup_.model.link(setup_.checked[i].b).name == b) {
        return report.pairs[i];
      }
    }
    throw std::out_of_range(a + " and " + b);
  }

  CycleSetup setup_ = armSetup();
  JointPath path_;
  TrajectoryOptions options_;
  std::string lost_;
  double shoulder_{0.0};                               ///< where it stands at the start
  Eigen::Vector3d post_off_{Eigen::Vector3d::Zero()};  ///< from where the URDF has the post
};

TEST_F(CheckTrajectoryTest, stretchedArmSweepsOverAPost_contactAtItsTime) {
  // Elbow at a right angle: the hand is sqrt(2) out, where the post is, and 45 degrees ahead of the
  // shoulder.
  go({{-0.25 * kPi, 0.5 * kPi}, {-0.5 * kPi, 0.5 * kPi}, {0.0, 0.5 * kPi}});
  const TrajectoryReport report = check();
  const PairApproach& post = of(report, "hand", "post");
  ASSERT_EQ(post.state, ApproachState::contact);
  // They touch when a chord of the circle of radius sqrt(2) is 0.2.
  const double apart = 2.0 * std::asin(0.1 / std::sqrt(2.0));
  EXPECT_NEAR(post.time, 2.0 - apart / (0.5 * kPi), 1e-5);
  EXPECT_NEAR(post.nearest.measured.distance, 0.0, 1.1e-6);
  EXPECT_EQ(report.first_contact, static_cast<LinkPairIndex>(&post - report.pairs.data()));
  EXPECT_EQ(of(report, "base", "hand").state, ApproachState::clear);
  EXPECT_GE(of(report, "base", "hand").at_least, options_.margin);
  EXPECT_LE(of(report, "base", "hand").at_least, std::sqrt(2.0) - 0.2 + 1e-12);
}

TEST_F(CheckTrajectoryTest, nearMissAtAWaypoint_isFoundThere) {
  // On a circle of radius sqrt(2), 0.16 rad from the post.
  go({{-0.25 * kPi, 0.5 * kPi}, {-0.16, 0.5 * kPi}});
  const TrajectoryReport report = check();
  const PairApproach& post = of(report, "hand", "post");
  ASSERT_EQ(post.state, ApproachState::clear);
  const double expected = 2.0 * std::sqrt(2.0) * std::sin(0.08) - 0.2;
  EXPECT_NEAR(post.nearest.measured.distance, expected, 1e-12);
  EXPECT_EQ(post.time, 1.0);
  EXPECT_LE(post.at_least, expected);
  EXPECT_GE(post.at_least, expected - options_.resolution);
  EXPECT_EQ(report.first_contact, kNone);
}

/// Way-points of the elbow alone, a second and 0.2 rad apart; the shoulder points up, and the
/// forearm at the post when the elbow is at a right angle.
JointPath elbowPath(JointId elbow, const std::vector<int>& fifths) {
  JointPath path;
  path.joints = {elbow};
  for (const int fifth : fifths) {
    path.times.push_back(static_cast<double>(path.times.size()));
    path.positions.push_back(-0.2 * fifth);
  }
  return path;
}

TEST_F(CheckTrajectoryTest, manyWaypoints_otherJointsStayAsTheyStand) {
  shoulder_ = 0.5 * kPi;
  path_ = elbowPath(path_.joints[1], {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10});
  const TrajectoryReport report = check();
  const PairApproach& post = of(report, "hand", "post");
  ASSERT_EQ(post.state, ApproachState::contact);
  EXPECT_NEAR(post.time, (0.5 * kPi - 2.0 * std::asin(0.1)) / 0.2, 1e-5);
  EXPECT_NEAR(post.nearest.measured.distance, 0.0, 1.1e-6);
  EXPECT_EQ(of(report, "base", "hand").state, ApproachState::clear);
}

TEST_F(CheckTrajectoryTest, manyWaypoints_whatStaysBeyondTheMarginIsNearestAtOne) {
  shoulder_ = 0.5 * kPi;
  path_ = elbowPath(path_.joints[1], {0, 1, 2, 3, 4, 5, 6, 5, 4, 3, 2});
  const TrajectoryReport report = check();
  const PairApproach& post = of(report, "hand", "post");
  ASSERT_EQ(post.state, ApproachState::clear);
  const double expected = 2.0 * std::sin(0.5 * (0.5 * kPi - 1.2)) - 0.2;  // 0.169
  EXPECT_NEAR(post.nearest.measured.distance, expected, 1e-12);
  EXPECT_EQ(post.time, 6.0);
  EXPECT_GE(post.at_least, options_.margin);
  EXPECT_LE(post.at_least, expected);
}

TEST_F(CheckTrajectoryTest, manyWaypoints_lostLinkIsUnknownAndTheRestIsNot) {
  lost_ = "hand";
  path_ = elbowPath(path_.joints[1], {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10});
  const TrajectoryReport report = check();
  EXPECT_EQ(of(report, "hand", "post").state, ApproachState::unknown);
  EXPECT_EQ(report.first_contact, kNone);
}

/// tf may tell better than the URDF where a fixed link stands, as after a calibration.
TEST_F(CheckTrajectoryTest, manyWaypoints_fixedLinksStayAsTheyStand) {
  shoulder_ = 0.5 * kPi;
  path_ = elbowPath(path_.joints[1], {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10});
  for (double& position : path_.positions) {
    position *= 0.5;  // so near each other that way-points alone could clear the way
  }
  post_off_ = {std::sin(0.5) - 1.0, std::cos(0.5), 0.0};  // on the way of the hand
  const PairApproach post = of(check(), "hand", "post");
  ASSERT_EQ(post.state, ApproachState::contact);
  EXPECT_NEAR(post.time, (0.5 - 2.0 * std::asin(0.1)) / 0.1, 1e-5);
}

TEST_F(CheckTrajectoryTest, nearMissBetweenWaypoints_isSearchedFor) {
  // The elbow stands 1.23 m from the post, so that the hand, 1 m out, passes it by 0.23 m from
  // center to center when it points there.
  const double sum = 0.5 * (3.0 - 1.23 * 1.23);  // of the shoulder's cosine and sine
  const double shoulder = std::asin(sum / std::sqrt(2.0)) - 0.25 * kPi;
  const double there = std::atan2(1.0 - std::sin(shoulder), 1.0 - std::cos(shoulder)) - shoulder;
  go({{shoulder, there - 0.4}, {shoulder, there + 0.5}});
  const TrajectoryReport report = check();
  const PairApproach& post = of(report, "hand", "post");
  ASSERT_EQ(post.state, ApproachState::clear);
  EXPECT_LE(post.at_least, 0.03 + 1e-12);
  EXPECT_GE(post.nearest.measured.distance, 0.03 - 1e-12);
  EXPECT_LE(post.nearest.measured.distance - post.at_least, options_.resolution);
  EXPECT_NEAR(post.time, 0.4 / 0.9, 0.1);
}

TEST_F(CheckTrajectoryTest, cubicWay_leavesTheLine) {
  // The shoulder is at the same angle at both way-points and swings up to the post in between.
  go({{-0.25 * kPi, 0.5 * kPi}, {-0.25 * kPi, 0.5 * kPi}});
  EXPECT_EQ(of(check(), "hand", "post").state, ApproachState::clear);
  path_.velocities = {kPi, 0.0, -kPi, 0.0};  // pi s (1 - s): 45 degrees up in the middle
  const TrajectoryReport report = check();
  ASSERT_EQ(of(report, "hand", "post").state, ApproachState::contact);
  const double apart = 2.0 * std::asin(0.1 / std::sqrt(2.0));
  // pi s (1 - s) = pi / 4 - apart.
  const double expected = 0.5 - std::sqrt(apart / kPi);
  EXPECT_NEAR(of(report, "hand", "post").time, expected, 1e-5);
}

TEST_F(CheckTrajectoryTest, contactAtTheStart_atTheFirstTime) {
  go({{0.0, 0.5 * kPi}, {1.0, 0.5 * kPi}});
  path_.times = {3.0, 4.0};
  const TrajectoryReport report = check();
  EXPECT_EQ(of(report, "hand", "post").state, ApproachState::contact);
  EXPECT_EQ(of(report, "hand", "post").time, 3.0);
}

TEST_F(CheckTrajectoryTest, oneWaypoint_isAStateToCheck) {
  go({{0.0, 0.5 * kPi}});
  EXPECT_EQ(of(check(), "hand", "post").state, ApproachState::contact);
}

TEST_F(CheckTrajectoryTest, farPair_isMeasuredWhereItIsNearest) {
  go({{-2.0, 0.0}, {-1.0, 0.0}});
  const TrajectoryReport report = check();
  const PairApproach& base = of(report, "base", "hand");
  ASSERT_EQ(base.state, ApproachState::clear);
  EXPECT_NEAR(base.nearest.measured.distance, 1.8, 1e-12);
  EXPECT_GE(base.at_least, options_.margin);
  EXPECT_LE(base.at_least, 1.8);
}

TEST_F(CheckTrajectoryTest, unknownLinkOrPath_isUnknown) {
  go({{0.0, 0.0}, {1.0, 0.0}});
  lost_ = "post";
  EXPECT_EQ(of(check(), "hand", "post").state, ApproachState::unknown);
  EXPECT_EQ(of(check(), "base", "hand").state, ApproachState::clear);
  lost_.clear();
  path_.positions[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(of(check(), "base", "hand").state, ApproachState::unknown);
}

TEST_F(CheckTrajectoryTest, budgetSpentOrCancelled_undecided) {
  go({{-0.25 * kPi, 0.5 * kPi}, {0.25 * kPi, 0.5 * kPi}, {0.0, 0.0}});
  options_.budget = 0;
  EXPECT_EQ(of(check(), "hand", "post").state, ApproachState::undecided);
  options_.budget = 1000000;
  std::vector<double> told;
  options_.progress = [&](double done) {
    told.push_back(done);
    return done < 0.5;
  };
  const TrajectoryReport report = check();
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_GT(told.size(), 1U) << "between way-points, too";
  EXPECT_EQ(told.back(), 0.5) << "and nothing after that";
  EXPECT_EQ(of(report, "hand", "post").state, ApproachState::contact) << "found before";
  EXPECT_EQ(of(report, "base", "hand").state, ApproachState::undecided);
  EXPECT_EQ(of(report, "base", "hand").time, 1.0);
}

/// All that the search does counts, also where links are so far apart that their shapes are never
/// measured: the hand passes the post at 0.39 m, 16,000 times.
TEST_F(CheckTrajectoryTest, budgetSpentOnWhatIsFar_undecided) {
  go({{0.0, 0.0}, {1e5, 0.0}});
  options_.budget = 100000;
  const TrajectoryReport report = check();
  EXPECT_EQ(of(report, "hand", "post").state, ApproachState::undecided);
  EXPECT_LT(report.work, 110000U);
}

TEST_F(CheckTrajectoryTest, longSearchInOneSegment_looksForProgressAllTheTime) {
  go({{0.0, 0.0}, {1e5, 0.0}});
  options_.budget = 1000000;
  std::vector<double> told;
  options_.progress = [&](double done) {
    told.push_back(done);
    return true;
  };
  const TrajectoryReport report = check();
  EXPECT_GT(report.work, 500000U);
  EXPECT_GT(told.size(), report.work / 4000);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  std::size_t calls = 0;
  options_.progress = [&](double /*done*/) { return ++calls < 10; };
  const TrajectoryReport ended = check();
  EXPECT_EQ(of(ended, "hand", "post").state, ApproachState::undecided);
  EXPECT_LT(ended.work, 50000U);
  EXPECT_EQ(calls, 10U) << "and none after the end";
}

TEST_F(CheckTrajectoryTest, cancelledBetweenTwoWaypoints_undecidedFromThereOn) {
  go({{-0.25 * kPi, 0.5 * kPi}, {0.25 * kPi, 0.5 * kPi}});
  options_.progress = [](double) { return false; };
  const TrajectoryReport report = check();
  EXPECT_EQ(of(report, "hand", "post").state, ApproachState::undecided);
  EXPECT_GT(of(report, "hand", "post").time, 0.0);
  EXPECT_LT(of(report, "hand", "post").time, 1.0);
}

}  // namespace
}  // namespace collision_monitor::test
