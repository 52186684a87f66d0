// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/parameters/fit_options.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace collision_monitor::test {
namespace {

TEST(LoadSetupOptions, rulesFile_isReadAnewEachTime) {
  Parameters parameters;
  parameters.shape_rules = "package://robot/rules.yaml";
  parameters.fit_cache = "none";
  int reads = 0;
  const ResourceLoader loader = [&](const std::string& uri) {
    ++reads;
    return uri + " " + std::to_string(reads);
  };
  SetupReport report;
  loadSetupOptions(parameters, loader, report);
  const SetupOptions options = loadSetupOptions(parameters, loader, report);
  EXPECT_EQ(options.shape_rules.source, "package://robot/rules.yaml");
  EXPECT_EQ(options.shape_rules.text, "package://robot/rules.yaml 2");
  EXPECT_TRUE(options.fit_cache.empty());
  EXPECT_TRUE(report.errors.empty());
}

TEST(LoadSetupOptions, rulesFileThatCannotBeRead_isAnError) {
  Parameters parameters;
  parameters.setup.where = "parameter /m/";
  parameters.shape_rules = "/nowhere.yaml";
  const ResourceLoader loader = [](const std::string&) -> std::string {
    throw std::runtime_error("no such file");
  };
  SetupReport report;
  loadSetupOptions(parameters, loader, report);
  ASSERT_EQ(report.errors.size(), 1U);
  EXPECT_EQ(toString(report.errors[0]),
            "parameter /m/shape_rules '/nowhere.yaml': no such file; accepted: a readable file or "
            "package:// URI");
}

TEST(LoadSetupOptions, noRulesFile_loadsNothing) {
  SetupReport report;
  const SetupOptions options = loadSetupOptions(Parameters(), {}, report);
  EXPECT_TRUE(options.shape_rules.source.empty());
}

}  // namespace
}  // namespace collision_monitor::test
