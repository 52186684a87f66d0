// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "collision_monitor/geometry/ids.h"
#include "collision_monitor/robot_query.h"
#include "support/scratch_folder.h"

// Objects beside urdf/two_boxes.urdf: box_a stands in the origin and box_b at x = 0.25 m + slide,
// with half extents of 0.1 m and 0.05 m. States are {slide, turn}.
namespace collision_monitor::test::library_world {
namespace {

constexpr const char* kPost = "- {name: post, kind: sphere, radius: 0.1, xyz: [0.25, 0.5, 0]}";
constexpr const char* kTool =
    "- {name: tool, attach: box_b, kind: sphere, radius: 0.05, xyz: [0, 0, 0.3]}";

DocumentText documentOf(const std::string& source, const std::string& text) {
  return text.empty() ? DocumentText() : DocumentText{source, text};
}

std::filesystem::path twoBoxes() {
  return std::filesystem::path(COLLISION_MONITOR_SOURCE_DIR) / "urdf/two_boxes.urdf";
}

RobotMonitor monitorOf(const std::string& world, const std::string& rules = "") {
  MonitorOptions options;
  options.fit_cache = "none";
  options.world = documentOf("cell.yaml", world);
  options.pair_rules = documentOf("rules.yaml", rules);
  return RobotMonitor::fromFiles({{twoBoxes()}}, options);
}

/// NaN if the pair is not checked.
double distanceOf(const RobotMonitor& monitor, const std::string& a, const std::string& b,
                  double slide = 0.0) {
  RobotQuery query(monitor);
  const std::vector<double> state =
      monitor.variables().empty() ? std::vector<double>() : std::vector<double>{slide, 0.0};
  for (const MeasuredPair& pair : query.distances(state).pairs) {
    const CheckedLinkPair& links = monitor.pairs()[pair.pair];
    if (monitor.model().link(links.a).name == a && monitor.model().link(links.b).name == b) {
      return pair.measured.distance;
    }
  }
  return std::nan("");
}

std::string faultsOf(const std::string& world, const std::string& rules = "") {
  try {
    monitorOf(world, rules);
  } catch (const SetupError& fault) {
    return fault.what();
  }
  return "";
}

TEST(LibraryWorld, objects_areMeasuredWhereTheyStand) {
  const RobotMonitor monitor = monitorOf(kPost);
  EXPECT_NEAR(distanceOf(monitor, "box_b", "post"), 0.35, 1e-12);
  EXPECT_NEAR(distanceOf(monitor, "box_a", "post"), std::hypot(0.15, 0.4) - 0.1, 1e-12);
  EXPECT_EQ(monitor.variables().size(), 2U);
}

TEST(LibraryWorld, attachedObject_movesWithItsLinkAndHasGradients) {
  const RobotMonitor monitor = monitorOf(kTool);
  EXPECT_NEAR(distanceOf(monitor, "box_a", "tool"), 0.2, 1e-12);
  EXPECT_NEAR(distanceOf(monitor, "box_a", "tool", 0.1), std::hypot(0.25, 0.2) - 0.05, 1e-12);
  EXPECT_TRUE(std::isnan(distanceOf(monitor, "box_b", "tool")));
}

TEST(LibraryWorld, objectOnAPath_isHitByTheLinkThatMoves) {
  const RobotMonitor monitor = monitorOf(
      "- {name: wall, kind: plane, xyz: [0.5, 0, 0], normal: [-1, 0, 0], touch_links: [rail]}");
  RobotQuery query(monitor);
  const std::vector<double> path{0.0, 0.0, 0.4, 0.0};
  const PathAnswer answer = query.checkPath({path});
  ASSERT_NE(answer.first_contact, kNone);
  EXPECT_NEAR(answer.pairs[answer.first_contact].time, 0.5, 1e-4);
  const std::vector<StateAnswer> checks = query.check(path);
  EXPECT_EQ(checks[0].verdict, Verdict::clear);
  EXPECT_EQ(checks[1].verdict, Verdict::contact);
}

/// A ball of 0.1 m in the origin and a plane whose normal has this tilt from -z, `depth` above it.
void expectPlane(double tilt, double depth, double padding) {
  SCOPED_TRACE(testing::Message() << "tilt " << tilt << ", depth " << depth << ", padding "
                                  << padding);
  RobotDescription ball;
  ball.urdf_xml =
      "<robot name='b'><link name='ball'><collision><geometry><sphere radius='0.1'/></geometry>"
      "</collision></link></robot>";
  MonitorOptions options;
  options.fit_cache = "none";
  std::ostringstream text;
  text.precision(17);
  text << "- {name: plane, kind: plane, padding: " << padding << ", normal: ["
       << std::sin(tilt) * std::cos(1.0) << ", " << std::sin(tilt) * std::sin(1.0) << ", "
       << -std::cos(tilt) << "], offset: " << depth - 0.1 << "}";
  options.world = {"plane.yaml", text.str(), ""};
  RobotQuery query(RobotMonitor({ball}, options));
  const double expected = -depth - padding;
  EXPECT_NEAR(query.distances({}).pairs.at(0).measured.distance, expected, 1e-9);
  EXPECT_NEAR(query.nearest({}).measured.distance, expected, 1e-9);
  const Verdict verdict = expected <= 0.0    ? Verdict::contact
                          : expected <= 0.05 ? Verdict::warning
                                             : Verdict::clear;
  EXPECT_EQ(query.verdict({}), verdict);
  EXPECT_EQ(query.contacts({}).size(), expected <= 0.0 ? 1U : 0U);
}

TEST(LibraryWorld, planes_areMeasuredWhateverTheirNormal) {
  for (const double tilt : {0.0, 1e-9, 2.65e-6, 1e-5, 3e-4, 9e-4, 3e-3, 0.05, 0.5, 1.6, 3.1,
                            3.14159, 3.141592653589793}) {
    for (const double depth : {-1.0, -0.04, 0.005, 0.3, 2.0}) {
      expectPlane(tilt, depth, 0.0);
      expectPlane(tilt, depth, 0.03);
    }
  }
}

TEST(LibraryWorld, linkThatIsCalledWorld_doesNotCarryObjectsWithoutFrame) {
  RobotDescription robot;
  robot.urdf_xml =
      "<robot name='b'><link name='world'><collision><geometry><sphere radius='0.1'/></geometry>"
      "</collision></link></robot>";
  MonitorOptions options;
  options.fit_cache = "none";
  options.world_from_root = {{Eigen::Matrix3d::Identity(), {1.0, 0.0, 0.0}}};
  const std::string shape = "kind: sphere, radius: 0.1, xyz: [0, 0, 5]}";
  options.world = {"w", "[{name: g, " + shape + ", {name: h, frame: world, " + shape + "]", ""};
  const RobotMonitor monitor({robot}, options);
  EXPECT_NEAR(distanceOf(monitor, "world", "g"), std::hypot(1.0, 5.0) - 0.2, 1e-12);
  EXPECT_NEAR(distanceOf(monitor, "world", "h"), 4.8, 1e-12) << "in the frame of the link";
  const RobotMonitor boxes = monitorOf("[{name: h, frame: world, " + shape + "]");
  EXPECT_NEAR(distanceOf(boxes, "box_a", "h"), 4.8, 1e-12) << "no link has that name";
}

TEST(LibraryWorld, shapeThatCannotBeMade_isAFaultOfItsObject) {
  const std::string faults = faultsOf("- {name: silo, kind: cylinder, radius: 1e6, length: 1}");
  EXPECT_NE(faults.find("silo"), std::string::npos) << faults;
  EXPECT_NE(faults.find("cell.yaml"), std::string::npos) << faults;
}

TEST(LibraryWorld, rules_nameObjectsToo) {
  const RobotMonitor monitor = monitorOf(kPost, "- {a: post, b: box_a, check: false}");
  EXPECT_TRUE(std::isnan(distanceOf(monitor, "box_a", "post")));
  EXPECT_NEAR(distanceOf(monitor, "box_b", "post"), 0.35, 1e-12);
}

TEST(LibraryWorld, withWorld_isAsMadeWithThatWorld) {
  const RobotMonitor robots = monitorOf("", "- {a: 'box_*', b: rail, check: false}");
  const RobotMonitor first = robots.withWorld({"cell.yaml", kPost, ""});
  const RobotMonitor second = first.withWorld({"cell.yaml", kTool, ""});
  const RobotMonitor none = second.withWorld({});
  EXPECT_NEAR(distanceOf(first, "box_b", "post"), 0.35, 1e-12);
  EXPECT_NEAR(distanceOf(second, "box_a", "tool"), 0.2, 1e-12);
  EXPECT_TRUE(std::isnan(distanceOf(second, "box_b", "post")));
  for (const RobotMonitor& each : {first, second, none}) {
    EXPECT_TRUE(std::isnan(distanceOf(each, "rail", "box_a")));
    EXPECT_NEAR(distanceOf(each, "box_a", "box_b"), 0.1, 1e-12);
  }
  EXPECT_EQ(none.pairs().size(), robots.pairs().size());
  EXPECT_EQ(first.pairs().size(), robots.pairs().size() + 3);
}

TEST(LibraryWorld, documentsWithoutText_areReadFromTheirFile) {
  const ScratchFolder folder;
  std::ofstream(folder.path() / "four.obj")
      << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
  std::ofstream(folder.path() / "cell.yaml")
      << "- {name: part, kind: mesh, file: four.obj, xyz: [1, 0, 0]}";
  std::ofstream(folder.path() / "rules.yaml") << "- {a: part, b: box_a, check: false}";
  MonitorOptions options;
  options.fit_cache = "none";
  options.world = {folder.path() / "cell.yaml"};
  options.pair_rules = {folder.path() / "rules.yaml"};
  const RobotMonitor monitor = RobotMonitor::fromFiles({{twoBoxes()}}, options);
  EXPECT_NEAR(distanceOf(monitor, "box_b", "part"), 0.7, 1e-12);
  EXPECT_TRUE(std::isnan(distanceOf(monitor, "box_a", "part")));
  EXPECT_NEAR(distanceOf(monitorOf("").withWorld(options.world), "box_a", "part"), 0.9, 1e-12);
}

TEST(LibraryWorld, filesThatCannotBeRead_areToldWithAllOtherFaults) {
  MonitorOptions options;
  options.shape_rules = {"/no/shapes.yaml"};
  options.pair_rules = {"/no/rules.yaml"};
  options.world = {"/no/cell.yaml"};
  options.padding = -1.0;
  try {
    RobotMonitor::fromFiles({{twoBoxes()}, {"/no/robot.urdf"}}, options);
    ADD_FAILURE() << "no fault";
  } catch (const SetupError& fault) {
    for (const char* part : {"shapes.yaml", "rules.yaml", "cell.yaml", "robot.urdf", "padding"}) {
      EXPECT_NE(std::string(fault.what()).find(part), std::string::npos) << fault.what();
    }
  }
  EXPECT_THROW(monitorOf("").withWorld({"/no/cell.yaml"}), SetupError);
}

TEST(LibraryWorld, texts_areLookedAtBesideOtherFaults) {
  MonitorOptions options;
  options.limits.warning_distance = -5.0;
  options.shape_rules = {"shapes.yaml", "shapes: [{links: [box_a], shpe: 1}]"};
  options.pair_rules = {"rules.yaml", "- {a: box_a, b: post, chek: false}"};
  options.world = {"cell.yaml", "- {name: x, kind: sphere}"};
  try {
    RobotMonitor::fromFiles({{twoBoxes()}}, options);
    ADD_FAILURE() << "no fault";
  } catch (const SetupError& fault) {
    const std::string text = fault.what();
    for (const char* part : {"warning_distance", "shpe", "chek", "cell.yaml"}) {
      EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
    }
    EXPECT_EQ(text.find("chek"), text.rfind("chek")) << "told once";
  }
}

TEST(LibraryWorld, whatNobodyWouldRead_isRefused) {
  const std::string second = faultsOf(std::string(kPost) + "\n---\n- {name: z, kind: plane}");
  EXPECT_NE(second.find("cell.yaml line 3"), std::string::npos) << second;
  EXPECT_NE(second.find("a second document"), std::string::npos) << second;
  const std::string latin = faultsOf("# caf\xC3\xA9\n- {name: \xE9, kind: plane}");
  EXPECT_NE(latin.find("cell.yaml line 2"), std::string::npos) << latin;
  EXPECT_NE(latin.find("UTF-8"), std::string::npos) << latin;
  const std::string plane = "- {name: p, kind: plane}";
  EXPECT_EQ(faultsOf("---\n" + plane + "\n...\n"), "");
  std::string utf16 = "\xFF\xFE";
  for (const char c : plane) {
    utf16 += {c, '\0'};
  }
  EXPECT_EQ(faultsOf(utf16), "") << "YAML may be UTF-16";
  EXPECT_NE(faultsOf("- {name: /world, kind: plane}").find("frame"), std::string::npos);
  EXPECT_NE(faultsOf("", "- {a: box_a, b: box_b, check: false}\n---\n- x").find("second"),
            std::string::npos);
}

TEST(LibraryWorld, badObjects_areRefusedWithEveryFault) {
  const std::string faults = faultsOf(std::string(kPost) +
                                      "\n- {name: post, kind: sphere, radius: 0.1}\n"
                                      "- {name: x, kind: sphere, radius: 0.1, frame: camera}\n"
                                      "- {name: y, kind: sphere, radius: 0.1, attach: hand}");
  for (const char* part : {"'post'", "'camera'", "'world'", "'hand'", "cell.yaml"}) {
    EXPECT_NE(faults.find(part), std::string::npos) << part << " in:\n" << faults;
  }
  EXPECT_NE(faultsOf("- {name: [").find("cell.yaml"), std::string::npos);
  EXPECT_NE(faultsOf(kPost, "- {a: pots, b: box_a, check: false}").find("pots"), std::string::npos);
  EXPECT_NE(faultsOf("", "- {a: post, b: box_a, check: false}").find("post"), std::string::npos);
  EXPECT_EQ(faultsOf("[]"), "");
}

}  // namespace
}  // namespace collision_monitor::test::library_world
