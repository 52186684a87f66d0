// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/world/world_parameters.h"

#include <gtest/gtest.h>

#include "support/robots/world_objects.h"

namespace collision_monitor::test {
namespace {

std::vector<std::string> faultsOf(const ListedRobot& first, const std::string& world_frame) {
  SetupReport report;
  const WorldObject table = objectOf("table", Sphere{0.1});
  WorldObject shelf = table;
  shelf.name = "shelf";
  shelf.frame = "cell";
  checkFrames({table, shelf, attached(named("tool"), "hand")}, first, world_frame, report);
  return textsOf(report.errors);
}

TEST(ObjectsWithoutFrame, whileTheFirstRobotIsMissing_areRefused) {
  const ListedRobot missing{"left", std::nullopt, "no URDF in parameter /left", false};
  EXPECT_EQ(faultsOf(missing, ""),
            (std::vector<std::string>{
                "world, object 'table': no frame, while the root link of robot 'left' is not "
                "known: no URDF in parameter /left; accepted: the name of a frame, or one in the "
                "parameter world_frame"}));
  EXPECT_TRUE(faultsOf(missing, "cell").empty());
  EXPECT_TRUE(faultsOf({"left", RobotId{0}, "", false}, "").empty());
}

TEST(WorldFile, withoutObjects_isWarnedOf) {
  Parameters parameters;
  parameters.world_file = "cell.yaml";
  const auto warningsOf = [&](const std::string& text) {
    SetupReport report;
    EXPECT_TRUE(loadObjects(
                    parameters, [&](const std::string&) { return text; }, report)
                    .empty());
    EXPECT_TRUE(report.errors.empty());
    return textsOf(report.warnings);
  };
  const std::vector<std::string> warning{
      "cell.yaml: no object; nothing is watched beside the robots"};
  for (const char* text : {"", "# nothing yet\n", "world: []\n"}) {
    EXPECT_EQ(warningsOf(text), warning) << text;
  }
}

}  // namespace
}  // namespace collision_monitor::test
