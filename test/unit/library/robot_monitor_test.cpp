// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/robot_monitor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <limits>

#include "support/robots/urdf_text.h"
#include "support/scratch_folder.h"

namespace collision_monitor::test::robot_monitor {
namespace {

const std::filesystem::path kRobots = std::filesystem::path(COLLISION_MONITOR_SOURCE_DIR) / "urdf";

MonitorOptions options() {
  MonitorOptions options;
  options.fit_cache = "none";
  options.package_roots = {COLLISION_MONITOR_SOURCE_DIR};
  return options;
}

RobotMonitor armMonitor() {
  return RobotMonitor::fromFiles({{kRobots / "arm6.urdf", kRobots / "arm6.srdf"}}, options());
}

std::vector<std::string> faultsOf(const std::vector<RobotFiles>& files,
                                  const MonitorOptions& options) {
  try {
    RobotMonitor::fromFiles(files, options);
  } catch (const SetupError& fault) {
    std::vector<std::string> texts;
    for (const Problem& problem : fault.problems()) {
      texts.push_back(toString(problem));
    }
    return texts;
  }
  return {};
}

TEST(RobotMonitor, arm_tellsItsJointsPairsAndShapes) {
  const RobotMonitor monitor = armMonitor();
  ASSERT_EQ(monitor.variables().size(), monitor.model().variable_count);
  EXPECT_EQ(monitor.defaultState().size(), monitor.variables().size());
  for (const JointVariable& variable : monitor.variables()) {
    EXPECT_EQ(variable.name, monitor.model().joint(variable.joint).name);
    EXPECT_LT(variable.lower, variable.upper);
    EXPECT_GT(variable.max_velocity, 0.0);
  }
  std::size_t checked = 0;
  for (const LinkPair& pair : monitor.allPairs()) {
    checked += isChecked(pair.reason) ? 1 : 0;
  }
  EXPECT_EQ(monitor.pairs().size(), checked);
  EXPECT_GT(checked, 0U);
  EXPECT_LT(checked, monitor.allPairs().size());
  EXPECT_FALSE(monitor.shapes().empty());
}

TEST(RobotMonitor, namesOfPlanarJoint_haveEndings) {
  const RobotMonitor monitor =
      RobotMonitor::fromFiles({{kRobots / "three_capsules.urdf"}}, options());
  std::vector<std::string> names;
  for (const JointVariable& variable : monitor.variables()) {
    names.push_back(variable.name);
  }
  for (const char* name : {"drift/x", "drift/y", "drift/theta"}) {
    EXPECT_EQ(std::count(names.begin(), names.end(), name), 1) << name;
  }
}

TEST(RobotMonitor, stateOf_movesTheNamedJointsAlone) {
  const RobotMonitor monitor = RobotMonitor::fromFiles({{kRobots / "two_boxes.urdf"}}, options());
  EXPECT_EQ(monitor.stateOf({"turn"}, {0.5}), (JointPositions{0.0, 0.5}));
  EXPECT_EQ(monitor.stateOf({}, {}), (JointPositions{0.0, 0.0}));
}

TEST(RobotMonitor, stateOfWithFaults_namesThemAll) {
  const RobotMonitor monitor = armMonitor();
  const std::string first = monitor.variables()[0].name;
  try {
    monitor.stateOf({first, first, "nonsense", "right_finger_joint", first + "x"},
                    {0.0, 0.0, 0.0, 0.0, 0.0});
    FAIL() << "accepted";
  } catch (const ArgumentError& fault) {
    EXPECT_EQ(fault.faults(),
              (std::vector<std::string>{
                  "joint '" + first + "' stands twice; give it once",
                  "there is no joint 'nonsense'; accepted: " + first +
                      ", shoulder_lift_joint, elbow_joint, wrist_1_joint, wrist_2_joint, "
                      "wrist_3_joint and left_finger_joint",
                  "joint 'right_finger_joint' follows 'left_finger_joint'; name that",
                  "there is no joint '" + first + "x', did you mean '" + first + "'?"}));
  }
  EXPECT_THROW(monitor.stateOf({first}, {}), ArgumentError);
}

TEST(RobotMonitor, twoRobots_getTheirPrefixesAndPlaces) {
  MonitorOptions apart = options();
  apart.world_from_root.resize(2);
  apart.world_from_root[1].translation.x() = 5.0;
  const RobotMonitor monitor = RobotMonitor::fromFiles(
      {{kRobots / "two_boxes.urdf", "", "left"}, {kRobots / "two_boxes.urdf", "", "right"}}, apart);
  EXPECT_TRUE(monitor.model().findLink("left/box_a"));
  EXPECT_TRUE(monitor.model().findLink("right/box_b"));
  EXPECT_EQ(monitor.model().variable_count, 4U);
}

TEST(RobotMonitor, descriptionsWithFaults_oneErrorNamesThemAll) {
  std::string elements;
  for (int i = 0; i < 9; ++i) {
    elements += linkXml("link_" + std::to_string(i), "<box size='1 -1 x'/>") + "\n";
  }
  elements += linkXml("tool", "<mesh filename='package://no_such_package/tool.stl'/>");
  MonitorOptions bad = options();
  bad.padding = -1.0;
  bad.limits.warning_distance = std::numeric_limits<double>::quiet_NaN();
  bad.world_from_root.resize(3);
  try {
    const RobotMonitor monitor({describeText(robotXml(elements))}, bad);
    FAIL() << "accepted";
  } catch (const SetupError& fault) {
    const std::string text = fault.what();
    EXPECT_GE(fault.problems().size(), 13U) << text;
    for (int i = 0; i < 9; ++i) {
      EXPECT_NE(text.find("link 'link_" + std::to_string(i) + "'"), std::string::npos) << text;
    }
    EXPECT_NE(text.find("no_such_package"), std::string::npos) << text;
    EXPECT_NE(text.find("option padding"), std::string::npos) << text;
    EXPECT_NE(text.find("option limits/warning_distance"), std::string::npos) << text;
    EXPECT_NE(text.find("option world_from_root: 3 poses"), std::string::npos) << text;
  }
}

TEST(RobotMonitor, filesThatAreMissing_areNamedBesideOtherFaults) {
  const ScratchFolder folder;
  std::ofstream(folder.path() / "bad.urdf") << robotXml("<link/>");
  MonitorOptions rules = options();
  rules.ignored_pairs = {{"box_a", "box_b"}};  // of a robot that cannot be read
  const std::vector<std::string> faults = faultsOf({{folder.path() / "none.urdf"},
                                                    {folder.path() / "bad.urdf"},
                                                    {kRobots / "arm6.urdf", "no.srdf"}},
                                                   rules);
  ASSERT_GE(faults.size(), 3U);  // the last file may have several
  EXPECT_NE(faults[0].find("none.urdf"), std::string::npos) << faults[0];
  EXPECT_NE(faults[1].find("no.srdf"), std::string::npos) << faults[1];
  EXPECT_NE(faults[2].find("bad.urdf"), std::string::npos) << faults[2];
}

TEST(RobotMonitor, whileItIsMade_isAskedOften_andEndsWhenItIsTold) {
  MonitorOptions asking = options();
  std::size_t asked = 0;
  std::size_t allowed = std::numeric_limits<std::size_t>::max();
  asking.goes_on = [&] { return ++asked <= allowed; };
  const std::vector<RobotFiles> arm{{kRobots / "arm6.urdf", kRobots / "arm6.srdf"}};
  RobotMonitor::fromFiles(arm, asking);
  const std::size_t often = asked;
  EXPECT_GT(often, 100U);
  allowed = often / 2;
  asked = 0;
  EXPECT_THROW(RobotMonitor::fromFiles(arm, asking), Interrupted);
  EXPECT_EQ(asked, allowed + 1);
}

TEST(RobotMonitor, rootThatIsNoPose_isRefused) {
  MonitorOptions bad = options();
  bad.world_from_root.resize(1);
  bad.world_from_root[0].rotation.setConstant(std::numeric_limits<double>::quiet_NaN());
  const std::vector<std::string> of_root = faultsOf({{kRobots / "two_boxes.urdf"}}, bad);
  ASSERT_EQ(of_root.size(), 1U);
  EXPECT_NE(of_root[0].find("option world_from_root[0]"), std::string::npos) << of_root[0];
  const std::vector<std::string> of_none = faultsOf({}, options());
  ASSERT_EQ(of_none.size(), 1U);
  EXPECT_NE(of_none[0].find("at least one robot"), std::string::npos) << of_none[0];
}

}  // namespace
}  // namespace collision_monitor::test::robot_monitor
