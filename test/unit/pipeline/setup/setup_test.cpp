// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/pipeline/setup.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "support/robots/file_loader.h"
#include "support/robots/urdf_text.h"

namespace collision_monitor {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

const std::string kRobot =
    test::robotXml(test::linkXml("base", "<box size='0.2 0.2 0.2'/>") +
                   test::linkXml("rod", "<cylinder radius='0.05' length='1'/>") +
                   test::jointXml("turn", "continuous", "base", "rod"));

/// What is wrong with the options, one sentence each, sorted.
std::vector<std::string> faultsOf(const SetupOptions& options) {
  std::vector<std::string> faults;
  try {
    buildSetup({test::describeText(kRobot)}, test::textLoader({}), options);
  } catch (const SetupError& error) {
    for (const Problem& problem : error.problems()) {
      faults.push_back(toString(problem));
    }
  }
  std::sort(faults.begin(), faults.end());
  return faults;
}

TEST(BuildSetup, defaultOptions_areWithoutFault) { EXPECT_TRUE(faultsOf({}).empty()); }

TEST(BuildSetup, wrongNumbers_areAllNamedWithWhatIsAccepted) {
  SetupOptions options;
  options.where = "~";
  options.padding = -0.001;
  options.default_limits.max_shapes = 0;
  options.limits.contact_distance = -std::numeric_limits<double>::infinity();
  options.limits.hysteresis = kNaN;
  options.ahead.stop.stop_distance = kNaN;
  options.ahead.stop.stop_time = 0.0;
  const std::vector<std::string> expected = {
      "~limits/contact_distance: -inf m; accepted: a finite number",
      "~limits/hysteresis: nan m; accepted: a finite number >= 0 m",
      "~look_ahead/stop_distance: nan m; accepted: a finite number",
      "~look_ahead/stop_time: 0 s; accepted: a finite number >= 0.001 s",
      "~max_shapes_per_link: 0; accepted: at least 1 shape a link",
      "~padding: -0.001 m; accepted: a finite number >= 0 m"};
  EXPECT_EQ(faultsOf(options), expected);
}

TEST(BuildSetup, faultsOfARobotAndOfTheTextOfRules_areNamedTogether_unknownNamesAreNot) {
  SetupOptions options;
  options.shape_rules = {"shapes.yaml", "shapes: [{link: nobody, max_shapes: 0}]"};
  options.pair_rules = {"pairs.yaml", "- {a: nobody, b: base, check: maybe}"};
  std::vector<std::string> faults;
  try {
    buildSetup({test::describeText("<robot")}, test::textLoader({}), options);
  } catch (const SetupError& error) {
    for (const Problem& problem : error.problems()) {
      faults.push_back(problem.where + ": " + problem.found);
    }
  }
  ASSERT_EQ(faults.size(), 3U);
  EXPECT_EQ(faults[1], "shapes.yaml line 1, rule 1: max_shapes '0'");
  EXPECT_EQ(faults[2], "pairs.yaml line 1, rule 1: check 'maybe'");
}

TEST(CheckLimits, everyFaultIsNamed) {
  SetupReport report;
  checkLimits({0.1, 0.05, -1.0, kNaN}, "limits/", report);
  ASSERT_EQ(report.errors.size(), 3U);
  EXPECT_EQ(report.errors[0].where, "limits/warning_distance");
  EXPECT_EQ(report.errors[1].where, "limits/report_distance");
  EXPECT_EQ(report.errors[2].where, "limits/hysteresis");
}

TEST(CheckLimits, timesAreNamedWithWhatIsAccepted) {
  SetupReport report;
  Limits limits;
  limits.contact_time = 0.3;
  limits.time_hysteresis = -1.0;
  checkLimits(limits, "limits/", report);
  ASSERT_EQ(report.errors.size(), 2U);
  EXPECT_EQ(report.errors[0].where, "limits/warning_time");
  EXPECT_EQ(report.errors[0].accepted, "a finite number >= 0.3 s");
  EXPECT_EQ(report.errors[1].where, "limits/time_hysteresis");
}

}  // namespace
}  // namespace collision_monitor
