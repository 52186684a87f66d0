// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/rules/awaited_names.h"

#include <gtest/gtest.h>

#include "collision_monitor/model/pair_rules.h"
#include "collision_monitor/model/shape_rules.h"
#include "support/robots/urdf_text.h"

namespace collision_monitor::test {
namespace {

/// Faults of rules that name a link, or a group, that the robot lacks.
std::size_t faultsOfLateNames() {
  const RobotModel model = readText(robotXml(linkXml("base", "<sphere radius='1'/>"))).model;
  SetupReport report;
  findNamedPairs({{"base", "late/base"}}, "ignore_pairs", model, report);
  readShapeRules({"rules.yaml",
                  "shapes:\n  - {link: late/base, padding: 0.1}\n"
                  "  - {links: [base, 'late/*'], padding: 0.2}\n  - {group: late, padding: 0.3}\n"},
                 model, {}, report);
  return report.errors.size();
}

TEST(AwaitedNames, namesThatMatchNothing_areFaultsUnlessRobotsAreAwaited) {
  EXPECT_EQ(faultsOfLateNames(), 4U);
  {
    const AwaitedNames awaited(true);
    EXPECT_EQ(faultsOfLateNames(), 0U);
    const AwaitedNames inner(false);
    EXPECT_EQ(faultsOfLateNames(), 0U) << "what is outside still holds";
  }
  EXPECT_EQ(faultsOfLateNames(), 4U);
}

}  // namespace
}  // namespace collision_monitor::test
