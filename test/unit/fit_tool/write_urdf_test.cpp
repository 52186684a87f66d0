// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "outputs/write_urdf.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "collision_monitor/model/urdf_reader.h"
#include "fit_robot.h"
#include "fitting/proofs/covering.h"
#include "geometry/bvh/visit_held.h"
#include "outputs/exports.h"
#include "support/random_poses.h"
#include "support/robots/file_loader.h"

namespace collision_monitor::fit_tool {
namespace {

RobotModel readModel(const std::string& urdf_xml) {
  RobotDescription description;
  description.source = "test.urdf";
  description.urdf_xml = urdf_xml;
  SetupReport report;
  RobotModel model = readRobots({description}, test::fileLoader("."), report);
  throwIfErrors(report);
  return model;
}

bool isInside(const UrdfPiece& piece, const Eigen::Vector3d& point_in_link) {
  const Eigen::Vector3d p = inverse(piece.link_from_geometry) * point_in_link;
  if (const auto* box = std::get_if<Box>(&piece.geometry)) {
    return (p.cwiseAbs().array() <= box->half_extents.array()).all();
  }
  if (const auto* cylinder = std::get_if<Cylinder>(&piece.geometry)) {
    return std::abs(p.z()) <= cylinder->half_length && p.head<2>().norm() <= cylinder->radius;
  }
  return p.norm() <= std::get<Sphere>(piece.geometry).radius;
}

std::size_t countOf(const std::vector<UrdfPiece>& pieces, std::size_t alternative) {
  return static_cast<std::size_t>(
      std::count_if(pieces.begin(), pieces.end(),
                    [&](const UrdfPiece& piece) { return piece.geometry.index() == alternative; }));
}

const std::size_t kSphere = Geometry(Sphere()).index();
const std::size_t kBox = Geometry(Box()).index();
const std::size_t kCylinder = Geometry(Cylinder()).index();

TEST(Pieces, kindsAndNumbers) {
  const auto capsule = piecesOf({Capsule{0.3, 0.1}, Pose()});
  EXPECT_EQ(countOf(capsule, kCylinder), 1U);
  EXPECT_EQ(countOf(capsule, kSphere), 2U);
  EXPECT_EQ(piecesOf({Capsule{0.0, 0.1}, Pose()}).size(), 1U);
  EXPECT_EQ(piecesOf({Sphere{0.1}, Pose()}).size(), 1U);
  const auto rounded = piecesOf({RoundedBox{{0.1, 0.2, 0.3}, 0.05}, Pose()});
  EXPECT_EQ(countOf(rounded, kBox), 3U);
  EXPECT_EQ(countOf(rounded, kCylinder), 12U);
  EXPECT_EQ(countOf(rounded, kSphere), 8U);
  const auto plate = piecesOf({RoundedBox{{0.1, 0.2, 0.0}, 0.05}, Pose()});
  EXPECT_EQ(countOf(plate, kBox), 1U);
  EXPECT_EQ(countOf(plate, kCylinder), 4U);
  EXPECT_EQ(countOf(plate, kSphere), 4U);
}

TEST(Pieces, unionIsTheShape) {
  test::Random random(11);
  std::uniform_real_distribution<double> coordinate(-0.6, 0.6);
  for (const Shape& shape :
       {Shape(Sphere{0.3}), Shape(Capsule{0.3, 0.2}), Shape(Box{{0.4, 0.3, 0.2}}),
        Shape(RoundedBox{{0.3, 0.2, 0.1}, 0.15}), Shape(RoundedBox{{0.3, 0.0, 0.2}, 0.2}),
        Shape(RoundedBox{{0.0, 0.3, 0.0}, 0.2}), Shape(RoundedBox{{0.0, 0.0, 0.0}, 0.3})}) {
    const PosedShape posed{shape, test::randomPose(random, 0.5)};
    const std::vector<UrdfPiece> pieces = piecesOf(posed);
    int inside = 0;
    for (int i = 0; i < 4000; ++i) {
      const Eigen::Vector3d in_body(coordinate(random), coordinate(random), coordinate(random));
      const double distance = signedDistanceTo(shape, in_body);
      if (std::abs(distance) < 1e-9) {
        continue;
      }
      const Eigen::Vector3d in_link = posed.geometry_from_body * in_body;
      EXPECT_EQ(std::any_of(pieces.begin(), pieces.end(),
                            [&](const UrdfPiece& piece) { return isInside(piece, in_link); }),
                distance < 0.0)
          << shape.index() << " at " << in_body.transpose();
      inside += distance < 0.0 ? 1 : 0;
    }
    EXPECT_GT(inside, 100);
  }
}

TEST(WriteUrdf, capsulesAndBoxesComeBackAsTheyWere) {
  test::Random random(3);
  const Pose pose = test::randomPose(random, 0.5);
  const std::string urdf = writeUrdf(
      "<robot name='r'><link name='a'><collision><geometry><sphere radius='9'/></geometry>"
      "</collision></link></robot>",
      {{"a", {{Capsule{0.3, 0.1}, pose}, {Box{{0.1, 0.2, 0.3}}, pose}}}});
  const RobotModel model = readModel(urdf);
  const std::vector<CollisionElement>& collisions = model.links[0].collisions;
  ASSERT_EQ(collisions.size(), 2U);
  const auto& capsule = std::get<Capsule>(collisions[0].geometry);
  EXPECT_NEAR(capsule.half_length, 0.3, 1e-12);
  EXPECT_NEAR(capsule.radius, 0.1, 3e-9);
  EXPECT_GT(capsule.radius, 0.1);
  for (const CollisionElement& collision : collisions) {
    EXPECT_TRUE(collision.link_from_geometry.rotation.isApprox(pose.rotation, 1e-12));
    EXPECT_TRUE(collision.link_from_geometry.translation.isApprox(pose.translation, 1e-12));
  }
  EXPECT_NE(urdf.find("<visual name=\"capsule_1_part_1\">"), std::string::npos);
}

TEST(WriteUrdf, otherLinksJointsAndInertiasStay) {
  const std::string urdf = writeUrdf(
      "<robot name='r'><link name='/a'><inertial><mass value='3'/></inertial><visual><geometry>"
      "<sphere radius='9'/></geometry></visual></link><link name='b'><collision><geometry>"
      "<sphere radius='7'/></geometry></collision></link><joint name='j' type='fixed'>"
      "<parent link='/a'/><child link='b'/></joint></robot>",
      {{"a", {{Sphere{0.1}, Pose()}}}});
  EXPECT_NE(urdf.find("<mass value=\"3\"/>"), std::string::npos);
  EXPECT_NE(urdf.find("<joint name=\"j\""), std::string::npos);
  EXPECT_NE(urdf.find("radius=\"7\""), std::string::npos);
  EXPECT_EQ(urdf.find("radius=\"9\""), std::string::npos);
  EXPECT_EQ(readModel(urdf).links[0].collisions.size(), 1U);
}

/// What is read again encloses what was fitted, proven, for every link of a whole robot.
TEST(WriteUrdf, ofARobot_readAgain_enclosesIt) {
  RobotDescription arm;
  arm.source = "arm6.urdf";
  arm.urdf_xml = test::readFile(std::string(COLLISION_MONITOR_SOURCE_DIR) + "/urdf/arm6.urdf");
  FitRequest request;
  request.limits = {4, 0.005, {}};
  const FittedRobot robot = fitRobot(arm, test::fileLoader("."), request, {});
  const RobotModel again = readModel(writeShapeUrdf(robot, arm.urdf_xml));
  ASSERT_EQ(robot.links.size(), 10U);
  for (const FittedLink& fitted : robot.links) {
    const Link& link = robot.model.link(fitted.link);
    std::vector<PlacedGeometry> geometries;
    for (const CollisionElement& element : link.collisions) {
      geometries.push_back({element.link_from_geometry, &element.geometry});
    }
    std::vector<PosedShape> shapes;
    for (const CollisionElement& element : again.links[index(fitted.link)].collisions) {
      PosedShape shape{Sphere(), element.link_from_geometry};
      if (const auto* capsule = std::get_if<Capsule>(&element.geometry)) {
        shape.shape = *capsule;
      } else if (const auto* box = std::get_if<Box>(&element.geometry)) {
        shape.shape = *box;
      } else {
        shape.shape = std::get<Sphere>(element.geometry);
      }
      shapes.push_back(shape);
    }
    const Covering covering = proveCovering(geometries, shapes, 1e-8);
    EXPECT_TRUE(covering.is_proven) << link.name << ", short by " << covering.excess;
  }
}

}  // namespace
}  // namespace collision_monitor::fit_tool
