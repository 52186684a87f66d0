// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "outputs/exports.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "collision_monitor/geometry/bounds.h"
#include "collision_monitor/model/srdf_reader.h"
#include "support/robots/file_loader.h"

namespace collision_monitor::fit_tool {
namespace {

const std::string kPackage = COLLISION_MONITOR_SOURCE_DIR;

RobotDescription arm() {
  RobotDescription description;
  description.source = "arm6.urdf";
  description.urdf_xml = test::readFile(kPackage + "/urdf/arm6.urdf");
  return description;
}

FittedRobot fitArm(const FitRequest& request) {
  return fitRobot(arm(), test::fileLoader("."), request, {});
}

TEST(FitRobot, isProven_andMeasuresWhatIsThere) {
  FitRequest request;
  request.limits = {2, 0.0, {}};
  std::vector<std::string> fitted;
  const FittedRobot robot =
      fitRobot(arm(), test::fileLoader("."), request,
               [&](const std::string& link, std::size_t, std::size_t) { fitted.push_back(link); });
  ASSERT_EQ(robot.links.size(), 10U);
  EXPECT_EQ(fitted.size(), 11U);  // once more at the end
  for (const FittedLink& link : robot.links) {
    for (const FittedPart& part : link.parts) {
      EXPECT_TRUE(part.figures.is_proven);
      EXPECT_TRUE(part.inner.sphere && part.inner.capsule);
      EXPECT_GT(part.figures.shape_volume, 0.9 * part.figures.hull_volume);
      EXPECT_LE(part.figures.overshoot.mean, part.figures.overshoot.max);
    }
  }
  EXPECT_EQ(robot.links[0].parts.size(), 2U);  // foot and collar
  EXPECT_EQ(robot.links[0].parts[1].name, "collar");
}

TEST(FitRobot, onlyTheLinksThatAreAskedFor) {
  FitRequest request;
  request.link_pattern = "*_finger";
  request.rules = {"r.yaml", "shapes: [{link: tool0, shapes: [{kind: sphere, radius: 0.1}]}]"};
  const FittedRobot robot = fitArm(request);
  ASSERT_EQ(robot.links.size(), 2U);
  EXPECT_EQ(robot.model.link(robot.links[0].link).name, "left_finger");
  EXPECT_EQ(robot.links[1].source, FitSource::repeated);
  request.link_pattern = "finger";
  try {
    fitArm(request);
    FAIL() << "no link is called finger";
  } catch (const SetupError& error) {
    ASSERT_EQ(error.problems().size(), 1U);
    EXPECT_EQ(error.problems()[0].where, "option --link");
    EXPECT_NE(error.problems()[0].accepted.find("left_finger"), std::string::npos);
  }
}

TEST(WriteRules, givenBack_makeTheSameSetup) {
  FitRequest request;
  request.limits = {3, 0.002, {}};
  request.rules = {"r.yaml",
                   "shapes:\n"
                   "- {link: forearm_link, padding: 0.0125}\n"
                   "- {link: gripper_palm, unproven: true, shapes: [{kind: sphere, radius: 0.001}]}"
                   "\n- {link: tool0, shapes: [{kind: sphere, radius: 0.1}]}\n"};
  const FittedRobot first = fitArm(request);
  request.rules = {"again.yaml", writeRules(first)};
  const FittedRobot second = fitArm(request);
  ASSERT_EQ(second.links.size(), first.links.size());
  for (std::size_t i = 0; i < first.links.size(); ++i) {
    const std::string& name = first.model.link(first.links[i].link).name;
    EXPECT_EQ(second.links[i].source, FitSource::given) << name;
    EXPECT_EQ(second.links[i].padding, first.links[i].padding) << name;
    EXPECT_EQ(second.links[i].parts[0].figures.is_proven, name != "gripper_palm") << name;
    const std::vector<PosedShape> before = paddedShapesOf(first.links[i]);
    const std::vector<PosedShape> after = paddedShapesOf(second.links[i]);
    ASSERT_EQ(after.size(), before.size()) << name;
    for (std::size_t k = 0; k < before.size(); ++k) {
      EXPECT_EQ(after[k].shape.index(), before[k].shape.index());
      EXPECT_NEAR(boundingRadius(after[k].shape), boundingRadius(before[k].shape), 1.1e-5);
    }
  }
  const Overshoot given = second.links[8].parts[0].figures.overshoot;
  const Overshoot fitted = first.links[8].parts[0].figures.overshoot;
  EXPECT_NEAR(given.max, fitted.max, 0.1 * fitted.max) << "measured for given shapes too";
}

TEST(PaddedShapes, areLargerByThePadding) {
  FitRequest request;
  request.link_pattern = "upper_arm_link";
  request.padding = 0.02;
  const FittedRobot robot = fitArm(request);
  EXPECT_NEAR(radiusOf(robot.links[0].parts[0].shapes[0].shape), 0.054, 1e-6);
  EXPECT_NEAR(radiusOf(paddedShapesOf(robot.links[0])[0].shape), 0.074, 1e-6);
}

TEST(Spheres, encloseAndAreReadByAnSrdfReader) {
  FitRequest request;
  request.link_pattern = "left_finger";
  const FittedRobot robot = fitArm(request);
  const std::vector<LinkSpheres> spheres = buildSpheres(robot, 16);
  ASSERT_EQ(spheres.size(), 1U);
  const std::vector<SphereNode> leaves = spheresOfLevel(spheres[0].trees[0], 1000);
  EXPECT_EQ(leaves.size(), 16U);
  const CollisionElement& element = robot.model.link(robot.links[0].link).collisions[0];
  for (const Eigen::Vector3d& vertex : std::get<TriangleMesh>(element.geometry).vertices) {
    const Eigen::Vector3d point = element.link_from_geometry * vertex;
    EXPECT_TRUE(std::any_of(leaves.begin(), leaves.end(), [&](const SphereNode& sphere) {
      return (point - sphere.center).norm() <= sphere.radius;
    }));
  }
  RobotDescription description = arm();
  description.srdf_xml = writeSphereSrdf(robot, spheres, 0);
  SetupReport report;
  readSrdf(description, RobotId{0}, robot.model, report);
  EXPECT_TRUE(report.errors.empty());
  EXPECT_NE(description.srdf_xml.find("<sphere center="), std::string::npos);
  EXPECT_EQ(description.srdf_xml.find("<sphere center="),
            description.srdf_xml.rfind("<sphere center="));  // level 0: one sphere
}

}  // namespace
}  // namespace collision_monitor::fit_tool
