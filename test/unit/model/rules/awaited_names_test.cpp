// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "collision_monitor/model/pair_rules.h"
#include "collision_monitor/model/shape_rules.h"
#include "support/robots/urdf_text.h"

namespace collision_monitor::test {
namespace {

/// Faults of rules that name a link, or a group, that the robot lacks.
std::size_t faultsOfLateNames(bool awaits_names) {
  const RobotModel model = readText(robotXml(linkXml("base", "<sphere radius='1'/>"))).model;
  SetupReport report;
  report.awaits_names = awaits_names;
  findNamedPairs({{"base", "late/base"}}, "ignore_pairs", model, report);
  readShapeRules({"rules.yaml",
                  "shapes:\n  - {link: late/base, padding: 0.1}\n"
                  "  - {links: [base, 'late/*'], padding: 0.2}\n  - {group: late, padding: 0.3}\n"},
                 model, {}, report);
  return report.errors.size();
}

TEST(AwaitedNames, namesThatMatchNothing_areFaultsUnlessRobotsAreAwaited) {
  EXPECT_EQ(faultsOfLateNames(false), 4U);
  EXPECT_EQ(faultsOfLateNames(true), 0U);
}

}  // namespace
}  // namespace collision_monitor::test
