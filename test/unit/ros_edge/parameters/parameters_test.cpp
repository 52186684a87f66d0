// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/parameters/parameters.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "parameter_faults.h"
#include "unit/ros_edge/edge_scene.h"

namespace collision_monitor::test {
namespace {

using XmlRpc::XmlRpcValue;

TEST(Parameters, nothingSet_defaultsAreLegal) {
  SetupReport report;
  const Parameters parameters = readParameters(XmlRpcValue(), "/m", report);
  EXPECT_TRUE(report.errors.empty());
  EXPECT_EQ(parameters.rate, 100.0);
  EXPECT_EQ(parameters.trigger, Trigger::timer);
  EXPECT_EQ(parameters.broad_phase, BroadPhaseKind::automatic);
}

TEST(Parameters, valuesAreRead_integersAreNumbers) {
  XmlRpcValue values;
  values["rate"] = 250;
  values["real_time_priority"] = 40;
  values["trigger"] = "pose";
  values["limits"]["warning_distance"] = 0.1;
  values["broad_phase"] = "combination";
  values["ignore_default_overlap"] = false;
  SetupReport report;
  const Parameters parameters = readParameters(values, "/m", report);
  EXPECT_TRUE(report.errors.empty());
  EXPECT_EQ(parameters.rate, 250.0);
  EXPECT_EQ(parameters.real_time_priority, 40);
  EXPECT_EQ(parameters.trigger, Trigger::pose);
  EXPECT_EQ(parameters.setup.limits.warning_distance, 0.1);
  EXPECT_EQ(parameters.broad_phase, BroadPhaseKind::combination);
  EXPECT_FALSE(parameters.setup.ignore_default_overlap);
}

TEST(Parameters, ignoredPairs_areReadAndChecked) {
  XmlRpcValue values;
  values["ignore_pairs"][0][0] = "cell/table";
  values["ignore_pairs"][0][1] = "left/base";
  SetupReport report;
  const Parameters parameters = readParameters(values, "/m", report);
  EXPECT_TRUE(report.errors.empty());
  ASSERT_EQ(parameters.setup.ignored_pairs.size(), 1u);
  EXPECT_EQ(parameters.setup.ignored_pairs[0].a, "cell/table");
  EXPECT_EQ(parameters.setup.ignored_pairs[0].b, "left/base");
  values["ignore_pairs"][1][0] = "alone";
  values["ignore_pairs"][2][0] = "table";
  values["ignore_pairs"][2][1] = 7;
  EXPECT_EQ(faults(values), (std::set<std::string>{"parameter /m/ignore_pairs[1]",
                                                   "parameter /m/ignore_pairs[2][1]"}));
  XmlRpcValue no_list;
  no_list["ignore_pairs"] = "table";
  EXPECT_EQ(faults(no_list), (std::set<std::string>{"parameter /m/ignore_pairs"}));
}

TEST(Parameters, robotThatIsNoStruct_isOneFault) {
  XmlRpcValue values;
  values["robots"][0] = 5;
  SetupReport report;
  readParameters(values, "/m", report);
  ASSERT_EQ(report.errors.size(), 1u);
  EXPECT_EQ(toString(report.errors.front()),
            "parameter /m/robots[0]: 5; accepted: a struct of named parameters");
}

TEST(Parameters, lookAhead_isReadAndChecked) {
  XmlRpcValue values;
  values["limits"]["warning_time"] = 0.3;
  values["limits"]["contact_time"] = 0.05;
  values["look_ahead"]["horizon"] = 2;
  values["look_ahead"]["stop_distance"] = 0.02;
  values["look_ahead"]["creep_scale"] = 0.1;
  values["joint_states"] = "/arm/joint_states";
  values["pose_source"] = "joint_states";
  SetupReport report;
  const Parameters parameters = readParameters(values, "/m", report);
  EXPECT_TRUE(report.errors.empty());
  EXPECT_EQ(parameters.setup.limits.warning_time, 0.3);
  EXPECT_EQ(parameters.setup.limits.contact_time, 0.05);
  EXPECT_EQ(parameters.setup.ahead.horizon, 2.0);
  EXPECT_EQ(parameters.setup.ahead.stop.stop_distance, 0.02);
  EXPECT_EQ(parameters.setup.ahead.stop.creep_scale, 0.1);
  EXPECT_EQ(parameters.joint_states, "/arm/joint_states");
  EXPECT_EQ(parameters.pose_source, PoseSource::joint_states);

  values["look_ahead"]["stop_time"] = 0.0;
  values["look_ahead"]["creep_scale"] = 1.5;
  values["look_ahead"]["stop_speed"] = 1.0;
  values["joint_states"] = "no topic";
  values["velocity_filter"] = -0.1;
  EXPECT_EQ(faults(values),
            (std::set<std::string>{"parameter /m/look_ahead/stop_time",
                                   "parameter /m/look_ahead/creep_scale",
                                   "parameter /m/look_ahead/stop_speed",
                                   "parameter /m/joint_states", "parameter /m/velocity_filter"}));
}

/// ROS would throw where they are resolved, and name no parameter.
TEST(Parameters, namesThatRosDoesNotResolve_areRefused) {
  XmlRpcValue values;
  values["joint_states"] = "~joint_states";
  values["robots"][0]["description"] = "~robot_description";
  values["robots"][1]["description"] = "/arm/robot_description";
  values["robots"][1]["semantic"] = "no name";
  values["robots"][1]["joint_states"] = "~joint_states";
  EXPECT_EQ(faults(values),
            (std::set<std::string>{
                "parameter /m/joint_states", "parameter /m/robots[0]/description",
                "parameter /m/robots[1]/semantic", "parameter /m/robots[1]/joint_states"}));
}

/// To YAML and roslaunch 1e3 is a text.
TEST(Parameters, numberThatIsAText_isRefusedWithAnAdvice) {
  const auto fault = [](const char* text) {
    XmlRpcValue values;
    values["rate"] = text;
    SetupReport report;
    readParameters(values, "/m", report);
    return report.errors.empty() ? "" : toString(report.errors.front());
  };
  EXPECT_EQ(fault("1e3"),
            "parameter /m/rate: '1e3', a text to YAML; accepted: a number > 0 and <= 10000, "
            "without quotes, and without exponent or as 1.0e+3");
  EXPECT_EQ(fault("fast"), "parameter /m/rate: 'fast'; accepted: a number > 0 and <= 10000");
}

TEST(Parameters, strictAndMemoryLimit_areRead) {
  XmlRpcValue values;
  SetupReport report;
  EXPECT_FALSE(readParameters(values, "/m", report).is_strict);
  EXPECT_EQ(readParameters(values, "/m", report).setup.memory_limit, 0U);
  values["strict"] = true;
  values["memory_limit"] = 500;
  EXPECT_TRUE(readParameters(values, "/m", report).is_strict);
  EXPECT_EQ(readParameters(values, "/m", report).setup.memory_limit, 500'000'000U);
  EXPECT_TRUE(report.errors.empty());
  values["strict"] = 1;
  values["memory_limit"] = -1;
  EXPECT_EQ(faults(values),
            (std::set<std::string>{"parameter /m/strict", "parameter /m/memory_limit"}));
}

TEST(Parameters, manyUnknownNames_areAFewAndHowManyMore) {
  XmlRpcValue values;
  for (int i = 0; i < 10'000; ++i) {
    values["unknown" + std::to_string(i)] = i;
  }
  SetupReport report;
  readParameters(values, "/m", report);
  ASSERT_EQ(report.errors.size(), 6U);
  EXPECT_EQ(report.errors.back().found, "9995 more unknown parameters");
}

TEST(Parameters, misspeltName_isNamedWithTheNearest) {
  XmlRpcValue values;
  values["max_agee"] = 0.2;
  SetupReport report;
  readParameters(values, "/m", report);
  ASSERT_EQ(report.errors.size(), 1U);
  EXPECT_EQ(report.errors[0].where, "parameter /m/max_agee");
  EXPECT_EQ(report.errors[0].accepted, "perhaps 'max_age'");
}

TEST(Parameters, allProblemsAreReported) {
  XmlRpcValue values;
  values["rate"] = -1.0;
  values["trigger"] = "often";
  values["max_age"] = "old";
  values["ignore_default_overlap"] = 1;
  values["limits"]["hysteresis"] = -0.1;
  values["look_ahead"] = "{horizon: 1}";
  values["nonsense"] = 3;
  EXPECT_EQ(faults(values),
            (std::set<std::string>{"parameter /m/rate", "parameter /m/trigger",
                                   "parameter /m/max_age", "parameter /m/ignore_default_overlap",
                                   "parameter /m/limits/hysteresis", "parameter /m/look_ahead",
                                   "parameter /m/nonsense"}));
}

TEST(Parameters, endsOfRanges) {
  XmlRpcValue values = emptyStruct();
  for (const double rate : {0.0, -5.0, 10000.5, std::numeric_limits<double>::quiet_NaN(),
                            std::numeric_limits<double>::infinity()}) {
    values["rate"] = rate;
    EXPECT_EQ(faults(values).size(), 1U) << rate;
  }
  for (const double rate : {1e-3, 10000.0}) {
    values["rate"] = rate;
    EXPECT_TRUE(faults(values).empty()) << rate;
  }
  values["heartbeat_rate"] = 0.5;
  EXPECT_EQ(faults(values).size(), 1U) << "slower than once a second";
}

TEST(Parameters, limitsOutOfOrder) {
  XmlRpcValue values;
  values["limits"]["contact_distance"] = 0.1;
  values["limits"]["warning_distance"] = 0.05;
  EXPECT_EQ(faults(values), (std::set<std::string>{"parameter /m/limits/warning_distance"}));
}

/// Where the problems of a set-up for the sliding robot are.
std::set<std::string> setupFaults(const SetupOptions& options) {
  std::set<std::string> places;
  try {
    slidingSetup(options);
  } catch (const SetupError& error) {
    for (const Problem& problem : error.problems()) {
      places.insert(problem.where);
    }
  }
  return places;
}

TEST(Parameters, faultsThatTheRobotShows_haveTheFullPath) {
  XmlRpcValue values;
  values["ignore_pairs"][0][0] = "no_such_link";
  values["ignore_pairs"][0][1] = "base";
  SetupReport report;
  SetupOptions options = readParameters(values, "/m", report).setup;
  ASSERT_TRUE(report.errors.empty());
  EXPECT_EQ(setupFaults(options), (std::set<std::string>{"parameter /m/ignore_pairs[0]"}));
  options.padding = -1.0;
  options.ahead.stop.creep_scale = -1.0;
  EXPECT_EQ(setupFaults(options),
            (std::set<std::string>{"parameter /m/ignore_pairs[0]", "parameter /m/padding",
                                   "parameter /m/look_ahead/creep_scale"}));
}

TEST(Parameters, robotsNeedExactlyOneSource_andUniqueNames) {
  XmlRpcValue values;
  values["robots"].setSize(3);
  values["robots"][0]["name"] = "left";
  values["robots"][0]["description"] = "/left/robot_description";
  values["robots"][1]["name"] = "left";
  values["robots"][1]["file"] = "a.urdf";
  values["robots"][1]["description"] = "/b";
  values["robots"][2]["nam"] = "c";
  EXPECT_EQ(faults(values),
            (std::set<std::string>{"parameter /m/robots[1]", "parameter /m/robots[1]/name",
                                   "parameter /m/robots[2]", "parameter /m/robots[2]/nam"}));
}

TEST(Parameters, robotsThatAreNoList) {
  XmlRpcValue values;
  values["robots"] = "left";
  EXPECT_EQ(faults(values), (std::set<std::string>{"parameter /m/robots"}));
}

TEST(Parameters, namesOfRobots_areNamesOfTopics) {
  XmlRpcValue values;
  for (const char* name : {"left", "cell_1/arm2", "left arm", "2nd", "a//b", "a/", "übung"}) {
    const int i = values.valid() ? values["robots"].size() : 0;
    values["robots"][i]["name"] = name;
    values["robots"][i]["file"] = "robot.urdf";
  }
  EXPECT_EQ(faults(values),
            (std::set<std::string>{"parameter /m/robots[2]/name", "parameter /m/robots[3]/name",
                                   "parameter /m/robots[4]/name", "parameter /m/robots[5]/name",
                                   "parameter /m/robots[6]/name"}));
}

TEST(Parameters, robotsThatMayBeAbsent_areRead) {
  XmlRpcValue values;
  values["robots"][0]["file"] = "robot.urdf";
  values["robots"][0]["may_be_absent"] = false;
  values["robots"][1]["file"] = "robot.urdf";
  SetupReport report;
  const Parameters parameters = readParameters(values, "/m", report);
  EXPECT_TRUE(report.errors.empty());
  EXPECT_FALSE(parameters.robots.at(0).may_be_absent);
  EXPECT_TRUE(parameters.robots.at(1).may_be_absent);
  values["robots"][0]["may_be_absent"] = "often";
  EXPECT_EQ(faults(values), std::set<std::string>{"parameter /m/robots[0]/may_be_absent"});
}

TEST(Parameters, labelsOfMarkers_areCounted) {
  XmlRpcValue values;
  values["marker_labels"] = 3;
  SetupReport report;
  EXPECT_EQ(readParameters(values, "/m", report).marker_labels, 3U);
  values["marker_labels"] = 2.5;
  EXPECT_EQ(faults(values), std::set<std::string>{"parameter /m/marker_labels"});
  values["marker_labels"] = 51;  // finding free places takes the cube of their number
  EXPECT_EQ(faults(values), std::set<std::string>{"parameter /m/marker_labels"});
}

}  // namespace
}  // namespace collision_monitor::test
