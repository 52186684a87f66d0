// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/pace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace collision_monitor::test {
namespace {

using Seconds = std::chrono::duration<double>;

/// A cycle begins late by one of these [s], in turn.
constexpr std::array<double, 5> kLateness = {0.0, 0.004, 0.001, 0.003, 0.0005};
constexpr double kLatest = 0.004;

Parameters parametersOf(double rate, double heartbeat_rate, Trigger trigger = Trigger::timer) {
  Parameters parameters;
  parameters.rate = rate;
  parameters.heartbeat_rate = heartbeat_rate;
  parameters.trigger = trigger;
  return parameters;
}

struct Gaps {
  double least{std::numeric_limits<double>::infinity()};
  double most{0.0};
};

/// Between states of a minute in which nothing happens; by poses, messages that say nothing new
/// come each `news` seconds.
Gaps gapsOf(const Parameters& parameters, double news = 1e6) {
  const SteadyClock::time_point begin(std::chrono::seconds(1000));
  const auto at = [&](double time) {
    return begin + std::chrono::duration_cast<SteadyClock::duration>(Seconds(time));
  };
  CyclePace pace{begin, begin, begin};
  SteadyClock::time_point now = begin;
  Gaps gaps;
  for (std::size_t cycle = 0; now < at(60.0); ++cycle) {
    now += at(kLateness[cycle % kLateness.size()]) - begin;
    if (cycle > 0 && isStateDue(parameters, pace, now)) {
      const double gap = Seconds(now - pace.last_state).count();
      gaps = {std::min(gaps.least, gap), std::max(gaps.most, gap)};
      pace.last_state = now;
    }
    pace.planned_start = nextStart(parameters, pace, now);
    if (parameters.trigger == Trigger::pose) {
      const double next_news = news * std::ceil(Seconds(now - begin).count() / news + 1e-9);
      now = std::min(at(next_news), endOfWait(parameters, pace, now));
    }
    now = std::max(now, pace.planned_start);
  }
  return gaps;
}

TEST(Pace, rateOfTheHeartbeat_everyCycleHasAState) {
  for (const double rate : {1.0, 2.0, 7.0}) {
    EXPECT_LT(gapsOf(parametersOf(rate, rate)).most, 1.0 / rate + 2.0 * kLatest) << rate;
  }
  EXPECT_LT(gapsOf(parametersOf(1.0, 2.0)).most, 0.5 + 2.0 * kLatest) << "the rate is raised";
}

TEST(Pace, cyclesThatMissTheHeartbeat_stateComesEarlyAndNotLate) {
  const Gaps gaps = gapsOf(parametersOf(3.0, 2.0));
  EXPECT_LT(gaps.most, 1.0 / 3.0 + 2.0 * kLatest);
}

TEST(Pace, manyCycles_stateComesNoMoreOftenThanItMust) {
  const Gaps gaps = gapsOf(parametersOf(100.0, 1.0));
  EXPECT_LT(gaps.most, 1.0 + 2.0 * kLatest);
  EXPECT_GT(gaps.least, 0.99 - kLatest);
}

TEST(Pace, waitForPoses_endsWhenAStateIsDue) {
  Parameters parameters = parametersOf(100.0, 1.0, Trigger::pose);
  for (const double max_age : {0.5, 10.0}) {
    parameters.max_age = max_age;
    for (const double news : {1e6, 0.7, 0.03}) {
      const Gaps gaps = gapsOf(parameters, news);
      EXPECT_LT(gaps.most, 1.0 + 2.0 * kLatest) << max_age << " " << news;
      EXPECT_GT(gaps.least, 0.99 - kLatest) << max_age << " " << news;
    }
  }
  parameters = parametersOf(1.0, 1.0, Trigger::pose);
  EXPECT_LT(gapsOf(parameters, 0.03).most, 1.0 + 2.0 * kLatest);
}

TEST(Pace, cycleThatStartsLate_hasNoMoreTimeUnlessPosesStartIt) {
  const SteadyClock::time_point plan(std::chrono::seconds(1000));
  const SteadyClock::time_point woken = plan + std::chrono::milliseconds(3);
  const CyclePace pace{plan, plan, woken};
  const std::chrono::milliseconds period(10);
  EXPECT_EQ(endOfCycle(parametersOf(100.0, 1.0), pace), plan + period);
  EXPECT_EQ(endOfCycle(parametersOf(100.0, 1.0, Trigger::pose), pace), woken + period);
}

TEST(Pace, longestPeriod_isThatWithoutPoses) {
  EXPECT_EQ(longestPeriodOf(parametersOf(1.0, 2.0)), 0.5);
  EXPECT_EQ(longestPeriodOf(parametersOf(100.0, 2.0)), 0.01);
  EXPECT_EQ(longestPeriodOf(parametersOf(100.0, 2.0, Trigger::pose)), 0.125) << "max_age / 4";
}

}  // namespace
}  // namespace collision_monitor::test
