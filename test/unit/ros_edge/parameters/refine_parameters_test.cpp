// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "parameter_faults.h"

namespace collision_monitor::test {
namespace {

using XmlRpc::XmlRpcValue;

TEST(Parameters, fitting_isRead) {
  XmlRpcValue values;
  values["max_shapes_per_link"] = 7;
  values["target_overshoot"] = 0.02;
  values["refine_geometry"] = "hull";
  values["refine_distance"] = 0.03;
  values["refine_budget"] = 500;
  values["distance_tolerance"] = 0.002;
  values["continuous"] = false;
  values["shape_rules"] = "package://robot/rules.yaml";
  values["fit_cache"] = "none";
  SetupReport report;
  const Parameters parameters = readParameters(values, "/m", report);
  EXPECT_TRUE(report.errors.empty());
  EXPECT_EQ(parameters.setup.default_limits.max_shapes, 7U);
  EXPECT_EQ(parameters.setup.refine.limits.tolerance, 0.002);
  EXPECT_EQ(parameters.setup.default_limits.target_overshoot, 0.02);
  EXPECT_EQ(parameters.setup.refine.geometry, RefineGeometry::hull);
  EXPECT_EQ(parameters.setup.refine.limits.distance, 0.03);
  EXPECT_EQ(parameters.setup.refine.limits.budget, 500U);
  EXPECT_FALSE(parameters.setup.is_continuous);
  EXPECT_EQ(parameters.shape_rules, "package://robot/rules.yaml");
  EXPECT_EQ(parameters.fit_cache, "none");
  const Parameters defaults = readParameters(emptyStruct(), "/m", report);
  EXPECT_EQ(defaults.setup.default_limits.max_shapes, 4U);
  EXPECT_EQ(defaults.setup.default_limits.target_overshoot, 0.01);
  EXPECT_EQ(defaults.setup.refine.geometry, RefineGeometry::mesh);
  EXPECT_TRUE(defaults.setup.is_continuous);
}

TEST(Parameters, timer_leavesACycleItsPeriod) {
  XmlRpcValue values;
  values["rate"] = 200.0;
  SetupReport report;
  EXPECT_EQ(readParameters(values, "/m", report).setup.refine.limits.period, 0.005);
  values["trigger"] = "pose";
  EXPECT_TRUE(std::isinf(readParameters(values, "/m", report).setup.refine.limits.period))
      << "cycles come as poses do";
}

TEST(Parameters, fittingOutOfRange) {
  for (const double count : {0.0, -1.0, 1001.0, 2.5}) {
    XmlRpcValue values;
    values["max_shapes_per_link"] = count;
    EXPECT_EQ(faults(values), (std::set<std::string>{"parameter /m/max_shapes_per_link"})) << count;
  }
  XmlRpcValue values;
  values["target_overshoot"] = -0.01;
  values["shape_rules"] = 3;
  values["fit_cache"] = false;
  EXPECT_EQ(faults(values),
            (std::set<std::string>{"parameter /m/target_overshoot", "parameter /m/shape_rules",
                                   "parameter /m/fit_cache"}));
}

TEST(Parameters, distanceTolerance_isATenthOfAMillimetreUnlessWarningsAreNearer) {
  SetupReport report;
  EXPECT_EQ(readParameters(XmlRpcValue(), "/m", report).setup.refine.limits.tolerance, 1e-4);
  XmlRpcValue values;
  values["limits"]["warning_distance"] = 0.0;
  EXPECT_EQ(readParameters(values, "/m", report).setup.refine.limits.tolerance, 0.0);
  EXPECT_TRUE(report.errors.empty());
}

TEST(Parameters, distanceToleranceThatIsNone_isRefused) {
  for (const double bad : {-1e-9, 0.051, std::nan("")}) {
    XmlRpcValue values;
    values["distance_tolerance"] = bad;
    SetupReport report;
    readParameters(values, "/m", report);
    ASSERT_EQ(report.errors.size(), 1U) << bad;
    EXPECT_NE(report.errors[0].where.find("distance_tolerance"), std::string::npos);
    EXPECT_NE(report.errors[0].accepted.find("0.05"), std::string::npos);
  }
}

}  // namespace
}  // namespace collision_monitor::test
