// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "collision_monitor/ros_edge/parameters.h"

namespace collision_monitor::test {
namespace {

using XmlRpc::XmlRpcValue;

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
