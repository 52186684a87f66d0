// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/parameters/fit_options.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <string>

namespace collision_monitor::test {
namespace {

/// Sets environment variables and puts them back.
class Environment {
 public:
  Environment(const char* home, const char* ros_home) {
    set("HOME", home, old_home_);
    set("ROS_HOME", ros_home, old_ros_home_);
  }
  ~Environment() {
    restore("HOME", old_home_);
    restore("ROS_HOME", old_ros_home_);
  }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

 private:
  static void set(const char* name, const char* value, std::optional<std::string>& old) {
    if (const char* before = std::getenv(name)) {
      old = before;
    }
    restore(name, value == nullptr ? std::nullopt : std::optional<std::string>(value));
  }
  static void restore(const char* name, const std::optional<std::string>& value) {
    if (value) {
      setenv(name, value->c_str(), 1);
    } else {
      unsetenv(name);
    }
  }
  std::optional<std::string> old_home_;
  std::optional<std::string> old_ros_home_;
};

std::string folderWith(const char* home, const char* ros_home, const std::string& parameter) {
  const Environment environment(home, ros_home);
  return fitCacheFolder(parameter).string();
}

TEST(FitCacheFolder, usualOne_isBelowRosHomeOrHome) {
  EXPECT_EQ(folderWith("/home/a", "/ros", ""), "/ros/collision_monitor/fits");
  EXPECT_EQ(folderWith("/home/a", nullptr, ""), "/home/a/.ros/collision_monitor/fits");
  EXPECT_EQ(folderWith("/home/a", "", ""), "/home/a/.ros/collision_monitor/fits");
  EXPECT_EQ(folderWith(nullptr, nullptr, ""), "");
}

TEST(FitCacheFolder, namedOne_isTaken_noneIsNone) {
  EXPECT_EQ(folderWith("/home/a", "/ros", "/var/fits"), "/var/fits");
  EXPECT_EQ(folderWith("/home/a", "/ros", "~/fits"), "/home/a/fits");
  EXPECT_EQ(folderWith("/home/a", "/ros", "none"), "");
}

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
  EXPECT_EQ(options.shape_rules.yaml, "package://robot/rules.yaml 2");
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
