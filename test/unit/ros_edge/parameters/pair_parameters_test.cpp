// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "parameter_faults.h"
#include "unit/ros_edge/edge_scene.h"

namespace collision_monitor::test::pair_parameters {
namespace {

using XmlRpc::XmlRpcValue;

/// {a: A, b: B, warning_distance: 0.01, check: true}
XmlRpcValue ruleOf(const XmlRpcValue& a, const XmlRpcValue& b) {
  XmlRpcValue rule;
  rule["a"] = a;
  rule["b"] = b;
  rule["warning_distance"] = 0.01;
  rule["check"] = true;
  return rule;
}

TEST(PairParameters, rulesInline_areReadAsThoseOfAFile) {
  XmlRpcValue names;
  names[0] = "finger";
  names[1] = "sli*";
  XmlRpcValue values;
  values["pair_rules"][0] = ruleOf("base", "tool");
  values["pair_rules"][1] = ruleOf(names, "base");
  SetupReport report;
  const Parameters parameters = readParameters(values, "/m", report);
  ASSERT_TRUE(report.errors.empty());
  const CycleSetup setup = slidingSetup(parameters.setup)->setup;
  ASSERT_EQ(setup.pair_rules.size(), 2U);
  EXPECT_EQ(setup.pair_rules[1].where, "parameter /m/pair_rules line 2, rule 2");
  EXPECT_EQ(setup.pair_rules[0].is_checked, true);
  EXPECT_EQ(setup.pair_rules[1].limits[1], 0.01);
  EXPECT_TRUE(setup.pair_rules[1].a[index(linkNamed(setup.model, "finger"))]);
  EXPECT_TRUE(setup.pair_rules[1].a[index(linkNamed(setup.model, "slider"))]);
}

TEST(PairParameters, oddNamesInline_stayWhatTheyAre) {
  XmlRpcValue values;
  values["pair_rules"][0] = ruleOf("a\"b\\c: {d}\n", "#e");
  SetupReport report;
  const Parameters parameters = readParameters(values, "/m", report);
  try {
    slidingSetup(parameters.setup);
    FAIL() << "there are no such links";
  } catch (const SetupError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("link 'a\"b\\c: {d}\\x0a', which matches none"), std::string::npos) << text;
    EXPECT_NE(text.find("link '#e', which matches none"), std::string::npos) << text;
  }
}

TEST(PairParameters, rulesInAFile_areNamed) {
  XmlRpcValue values;
  values["pair_rules"] = "package://robot/pairs.yaml";
  SetupReport report;
  EXPECT_EQ(readParameters(values, "/m", report).pair_rules, "package://robot/pairs.yaml");
  values["pair_rules"] = 3;
  EXPECT_EQ(faults(values), std::set<std::string>{"parameter /m/pair_rules"});
}

TEST(PairParameters, paddingsAndSpheres_areRead) {
  XmlRpcValue values;
  values["link_padding"]["hand"] = 0.02;
  values["srdf_spheres"] = true;
  SetupReport report;
  const Parameters parameters = readParameters(values, "/m", report);
  ASSERT_TRUE(report.errors.empty());
  ASSERT_EQ(parameters.setup.link_paddings.size(), 1U);
  EXPECT_EQ(parameters.setup.link_paddings[0].link, "hand");
  EXPECT_EQ(parameters.setup.link_paddings[0].padding, 0.02);
  EXPECT_TRUE(parameters.setup.uses_srdf_spheres);
  values["link_padding"]["hand"] = -0.02;
  EXPECT_EQ(faults(values), std::set<std::string>{"parameter /m/link_padding/hand"});
  XmlRpcValue number;
  number["link_padding"] = 0.02;
  EXPECT_EQ(faults(number), std::set<std::string>{"parameter /m/link_padding"});
}

}  // namespace
}  // namespace collision_monitor::test::pair_parameters
