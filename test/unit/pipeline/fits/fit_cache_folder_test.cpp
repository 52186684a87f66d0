// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/fits/fit_cache_folder.h"

#include <gtest/gtest.h>

#include "support/environment.h"

namespace collision_monitor::test {
namespace {

std::string folderWith(const char* home, const char* ros_home, const std::string& parameter) {
  const EnvironmentVariable own_home("HOME", home);
  const EnvironmentVariable own_ros_home("ROS_HOME", ros_home);
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

}  // namespace
}  // namespace collision_monitor::test
