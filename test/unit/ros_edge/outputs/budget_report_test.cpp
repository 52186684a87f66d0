// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/outputs/budget_report.h"

#include <gtest/gtest.h>

#include <string>

#include "status_values.h"
#include "support/robots/geometry_setup.h"
#include "support/sample_meshes.h"

namespace collision_monitor::test {
namespace {

using diagnostic_msgs::DiagnosticStatus;

/// A mesh of 20 triangles, one of 32, and a cylinder, on three links.
MonitorSetup meshesAndACylinder(RefineGeometry geometry = RefineGeometry::mesh) {
  SetupOptions options;
  options.refine.geometry = geometry;
  options.refine.limits.tolerance = 1e-4;
  const TriangleMesh fine = joined(angleMesh(), boxMesh({0.05, 0.05, 0.2}));
  MonitorSetup setup;
  setup.setup = geometrySetup({angleMesh(), fine, Cylinder{0.1, 0.05}}, options);
  return setup;
}

/// Pairs of links: 0 of the meshes, 1 and 2 of the cylinder with either.
BudgetUse shortUse(const MonitorSetup& setup) {
  BudgetUse use;
  use.setup = &setup.setup;
  use.cycles = 100;
  use.short_cycles = 40;
  use.work = 300000;
  use.worst = 9500;
  use.short_work = 200000;
  use.short_time = 0.08;
  use.most = {{{0, 150000}, {2, 40000}, {1, 10000}}};
  return use;
}

DiagnosticStatus statusOf(const MonitorSetup& setup, const BudgetUse& use) {
  diagnostic_updater::DiagnosticStatusWrapper status;
  describeBudget(setup, use, status);
  return status;
}

/// All of it, a line each.
std::string adviceOf(const DiagnosticStatus& status) {
  std::string advice;
  for (const diagnostic_msgs::KeyValue& value : status.values) {
    advice += value.key.rfind("advice", 0) == 0 ? value.value + "\n" : "";
  }
  return advice;
}

TEST(BudgetReport, budgetThatDoesNotSuffice_isAWarningThatNamesThePairs) {
  const MonitorSetup setup = meshesAndACylinder();
  const DiagnosticStatus status = statusOf(setup, shortUse(setup));
  EXPECT_EQ(status.level, DiagnosticStatus::WARN);
  EXPECT_EQ(status.message,
            "refine_budget did not suffice in 40 of the 100 cycles since the last report; these "
            "pairs took most of its work: link_0 and link_1 (75 %), link_1 and link_2 (20 %), "
            "link_0 and link_2 (5 %)");
  const auto values = valuesOf(status);
  EXPECT_EQ(values.at("refine_budget"), "8000");
  EXPECT_EQ(values.at("cycles since the last report"), "100");
  EXPECT_EQ(values.at("cycles in which it did not suffice"), "40");
  EXPECT_EQ(values.at("work of a cycle, mean"), "3000");
  EXPECT_EQ(values.at("work of a cycle, worst"), "9500");
  EXPECT_EQ(values.at("most work 1"), "link_0 and link_1: 75 %");
  EXPECT_EQ(values.at("most work 3"), "link_0 and link_2: 5 %");
}

TEST(BudgetReport, advice_fitsThePairs) {
  const MonitorSetup setup = meshesAndACylinder();
  EXPECT_EQ(adviceOf(statusOf(setup, shortUse(setup))),
            "raise refine_budget (8000 now): cycles that ran out of it took 2.0 ms on average; a "
            "period is 10.0 ms\n"
            "raise distance_tolerance (0.0001 m now, at most 0.05 m): distances of meshes may then "
            "be up to that much too small; verdicts by distance do not change\n"
            "if the hull of link_1 may stand for its 32 triangles, write shapes: [{link: "
            "link_1, refine: hull}] into a file and set shape_rules to its path\n"
            "if link_0 and link_1 never touch (rosrun collision_monitor pairs finds out), or are "
            "allowed to, leave them out by ignore_pairs: [[link_0, link_1]] or in the SRDF\n"
            "if link_1 and link_2 never touch (rosrun collision_monitor pairs finds out), or are "
            "allowed to, leave them out by ignore_pairs: [[link_1, link_2]] or in the SRDF\n");
}

TEST(BudgetReport, linkOfManyPairsThatTakeLittleEach_isStillDense) {
  const MonitorSetup setup = meshesAndACylinder();
  BudgetUse use = shortUse(setup);
  use.most = {{{0, 14000}, {2, 12000}, {1, 10000}}};
  const std::string advice = adviceOf(statusOf(setup, use));
  EXPECT_NE(advice.find("{link: link_1, refine: hull}"), std::string::npos) << advice;
  EXPECT_EQ(advice.find("{link: link_0, refine: hull}"), std::string::npos) << advice;
  EXPECT_EQ(advice.find("ignore_pairs"), std::string::npos) << advice;
}

TEST(BudgetReport, budgetThatSuffices_isOkAndGivesNoAdvice) {
  const MonitorSetup setup = meshesAndACylinder();
  BudgetUse use = shortUse(setup);
  use.short_cycles = use.short_work = 0;
  use.most = {};
  const DiagnosticStatus status = statusOf(setup, use);
  EXPECT_EQ(status.level, DiagnosticStatus::OK);
  EXPECT_EQ(status.message, "refine_budget sufficed in all cycles");
  EXPECT_EQ(valuesOf(status).at("work of a cycle, worst"), "9500");
  EXPECT_EQ(adviceOf(status), "");
}

TEST(BudgetReport, noCycle_isOk) {
  const MonitorSetup setup = meshesAndACylinder();
  BudgetUse use;
  use.setup = &setup.setup;
  const DiagnosticStatus status = statusOf(setup, use);
  EXPECT_EQ(status.level, DiagnosticStatus::OK);
  EXPECT_EQ(status.message, "no cycle since the last report");
  EXPECT_EQ(valuesOf(status).at("work of a cycle, mean"), "0");
}

TEST(BudgetReport, useOfAnotherSetup_namesNoLinksOfThisOne) {
  const MonitorSetup former = meshesAndACylinder();
  const DiagnosticStatus status = statusOf(meshesAndACylinder(), shortUse(former));
  EXPECT_EQ(status.message, "no cycle since the last report");
}

TEST(BudgetReport, noBudgetAtAll_noPairIsBlamed) {
  const MonitorSetup setup = meshesAndACylinder();
  BudgetUse use = shortUse(setup);
  use.work = use.worst = use.short_work = 0;
  use.most = {};
  const DiagnosticStatus status = statusOf(setup, use);
  EXPECT_EQ(status.message,
            "refine_budget did not suffice in 40 of the 100 cycles since the last report");
  EXPECT_EQ(adviceOf(status),
            "raise refine_budget (8000 now): cycles that ran out of it took 2.0 ms on average; a "
            "period is 10.0 ms\n");
}

TEST(BudgetReport, cyclesThatFillTheirPeriod_needALowerRateToo) {
  const MonitorSetup setup = meshesAndACylinder();
  BudgetUse use = shortUse(setup);
  use.short_time = 0.36;
  const std::string advice = adviceOf(statusOf(setup, use));
  EXPECT_EQ(advice.find("raise refine_budget (8000 now) and lower rate (100 Hz now): cycles that "
                        "ran out of it took 9.0 ms on average; a period is 10.0 ms\n"),
            0U)
      << advice;
}

TEST(BudgetReport, hulls_areNotAdvisedAgainNorWhatHelpsMeshesAlone) {
  const MonitorSetup setup = meshesAndACylinder(RefineGeometry::hull);
  const std::string advice = adviceOf(statusOf(setup, shortUse(setup)));
  EXPECT_EQ(advice.find("distance_tolerance"), std::string::npos) << advice;
  EXPECT_EQ(advice.find("refine: hull"), std::string::npos) << advice;
  EXPECT_NE(advice.find("ignore_pairs"), std::string::npos) << advice;
}

TEST(BudgetReport, toleranceThatCannotBeRaised_isNotAdvised) {
  MonitorSetup setup = meshesAndACylinder();
  setup.setup.refine.tolerance = setup.setup.limits.warning_distance;
  const std::string advice = adviceOf(statusOf(setup, shortUse(setup)));
  EXPECT_EQ(advice.find("distance_tolerance"), std::string::npos) << advice;
}

TEST(BudgetReport, fileOfRules_isNamed) {
  MonitorSetup setup = meshesAndACylinder();
  setup.parameters.shape_rules = "package://cell/rules.yaml";
  const std::string advice = adviceOf(statusOf(setup, shortUse(setup)));
  EXPECT_NE(advice.find("add the rule {link: link_1, refine: hull} to package://cell/rules.yaml\n"),
            std::string::npos);
}

TEST(BudgetReport, linksOfTwoRobots_haveNoSrdf) {
  MonitorSetup setup = meshesAndACylinder();
  setup.setup.model.robots.push_back(setup.setup.model.robots.front());
  setup.setup.model.links[1].robot = RobotId{1};
  const std::string advice = adviceOf(statusOf(setup, shortUse(setup)));
  EXPECT_NE(advice.find("if link_0 and link_1 never touch, or are allowed to, leave them out by "
                        "ignore_pairs: [[link_0, link_1]]\n"),
            std::string::npos)
      << advice;
}

}  // namespace
}  // namespace collision_monitor::test
