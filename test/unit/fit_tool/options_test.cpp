// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "options.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "support/parse_arguments.h"

namespace collision_monitor::fit_tool {
namespace {

Parsed parse(const std::vector<const char*>& arguments, std::string* said = nullptr) {
  return test::parseArguments(parseOptions, arguments, said);
}

TEST(Options, byDefault_areTheMonitors) {
  const Parsed parsed = parse({"robot.urdf"});
  ASSERT_TRUE(parsed.is_to_run);
  const FitLimits monitors = SetupOptions().default_limits;
  EXPECT_EQ(parsed.options.source.urdf, "robot.urdf");
  EXPECT_EQ(parsed.options.limits.max_shapes, monitors.max_shapes);
  EXPECT_EQ(parsed.options.limits.target_overshoot, monitors.target_overshoot);
  EXPECT_TRUE(parsed.options.limits.kinds.sphere && parsed.options.limits.kinds.rounded_box);
  EXPECT_EQ(parsed.options.cache, "");
  EXPECT_FALSE(parsed.options.may_replace);
  EXPECT_TRUE(parse({"robot.urdf", "--force"}).options.may_replace);
}

TEST(Options, kindsAndLimits) {
  const Options options = parse({"--kinds", "box,capsule", "--max-shapes", "7", "--padding", "0.01",
                                 "--target-overshoot", "0", "robot.urdf", "--no-cache"})
                              .options;
  EXPECT_EQ(options.source.urdf, "robot.urdf");
  EXPECT_TRUE(options.limits.kinds.box && options.limits.kinds.capsule);
  EXPECT_FALSE(options.limits.kinds.sphere || options.limits.kinds.rounded_box);
  EXPECT_EQ(options.limits.max_shapes, 7U);
  EXPECT_EQ(options.padding, 0.01);
  EXPECT_EQ(options.limits.target_overshoot, 0.0);
  EXPECT_EQ(options.cache, "none");
}

TEST(Options, help_endsWell_andNamesEveryOutput) {
  std::string said;
  const Parsed parsed = parse({"--help"}, &said);
  EXPECT_FALSE(parsed.is_to_run);
  EXPECT_EQ(parsed.exit_code, 0);
  for (const char* option : {"--yaml", "--urdf", "--html", "--spheres-yaml", "--spheres-srdf"}) {
    EXPECT_NE(said.find(option), std::string::npos) << option;
  }
}

TEST(Options, faults_endWithTwo_andNameTheFault) {
  const std::vector<std::pair<std::vector<const char*>, const char*>> cases{
      {{}, "give one robot"},
      {{"a.urdf", "--param", "/robot_description"}, kHasRos ? "give one robot" : "--param"},
      {{"a.urdf", "--frobnicate"}, "--frobnicate"},
      {{"a.urdf", "b.urdf"}, "b.urdf"},
      {{"a.urdf", "--kinds", "cone"}, "cone"},
      {{"a.urdf", "--max-shapes", "0"}, "--max-shapes"},
      {{"a.urdf", "--max-shapes", "many"}, "--max-shapes"},
      {{"a.urdf", "--padding", "-0.1"}, "'-0.1' is no length"},
      {{"a.urdf", "--padding", "inf"}, "'inf' is no length"},
      {{"a.urdf", "--target-overshoot", "nan"}, "'nan' is no length"},
      {{"a.urdf", "--cache", "x", "--no-cache"}, "--no-cache"},
      {{"a.urdf", "--yaml", "x", "--html", "x"}, "two options write 'x'"},
      {{"a.urdf", "--yaml", "x", "--html", "./x"}, "two options write './x'"},
      {{"a.urdf", "--urdf", "a.urdf"}, "--urdf would replace the robot"},
      {{"a.urdf", "--html", "a.urdf"}, "--html would replace the robot"},
      {{"a.urdf", "--srdf", "b", "--spheres-srdf", "b"}, "would replace the SRDF"},
      {{"a.urdf", "--rules", "b", "--yaml", "b"}, "would replace the file of rules"},
  };
  for (const auto& [arguments, expected] : cases) {
    std::string said;
    const Parsed parsed = parse(arguments, &said);
    EXPECT_FALSE(parsed.is_to_run) << expected;
    EXPECT_EQ(parsed.exit_code, 2) << expected;
    EXPECT_NE(said.find(expected), std::string::npos) << said;
  }
}

TEST(Options, robotUnderAnotherName_isNotReplacedEither) {
  const std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) / "robot_is_not_replaced";
  std::filesystem::create_directories(folder);
  const std::string robot = folder / "a.urdf";
  std::ofstream(robot) << "<robot/>";
  const std::string same = folder / "." / "a.urdf";
  std::string said;
  EXPECT_FALSE(parse({robot.c_str(), "--yaml", same.c_str()}, &said).is_to_run);
  EXPECT_NE(said.find("--yaml would replace the robot"), std::string::npos) << said;
}

}  // namespace
}  // namespace collision_monitor::fit_tool
