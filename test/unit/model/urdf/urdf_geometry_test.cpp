// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <sstream>

#include "support/robots/urdf_text.h"

namespace collision_monitor {
namespace {

using test::linkXml;
using test::readText;
using test::ReadText;
using test::robotXml;

/// A triangle that has x = 1, y = 2 and z = 3 as its only extents.
const char* const kTriangleObj = "v 0 0 0\nv 1 2 0\nv 0 2 3\nf 1 2 3\n";

const CollisionElement& only(const ReadText& read) {
  EXPECT_EQ(read.errors(), std::vector<std::string>());
  return read.model.links.at(0).collisions.at(0);
}

TEST(UrdfGeometry, box_hasHalfItsSize) {
  const ReadText read = readText(robotXml(linkXml("a", "<box size='0.2 0.4 0.6'/>")));
  EXPECT_EQ(std::get<Box>(only(read).geometry).half_extents, Eigen::Vector3d(0.1, 0.2, 0.3));
}

TEST(UrdfGeometry, cylinder_hasHalfItsLength) {
  const ReadText read = readText(robotXml(linkXml("a", "<cylinder radius='0.1' length='0.5'/>")));
  EXPECT_EQ(std::get<Cylinder>(only(read).geometry).half_length, 0.25);
  EXPECT_EQ(std::get<Cylinder>(only(read).geometry).radius, 0.1);
}

TEST(UrdfGeometry, capsule_lengthIsBetweenCapCenters) {
  const ReadText read = readText(robotXml(linkXml("a", "<capsule radius='0.1' length='0.5'/>")));
  EXPECT_EQ(std::get<Capsule>(only(read).geometry).half_length, 0.25);
  EXPECT_EQ(std::get<Capsule>(only(read).geometry).radius, 0.1);
}

TEST(UrdfGeometry, sphereOfRadiusZero_isAPointAndAWarning) {
  const ReadText read = readText(robotXml(linkXml("a", "<sphere radius='0.0'/>")));
  EXPECT_EQ(std::get<Sphere>(only(read).geometry).radius, 0.0);
  EXPECT_EQ(read.warnings(),
            std::vector<std::string>{
                "test.urdf: a size of 0: link 'a', collision 1; they are taken as the points, "
                "lines or faces that they are"});
}

TEST(UrdfGeometry, boxOfSizeZero_isAPointOrAFaceAndAWarning) {
  for (const Eigen::Vector3d& size :
       {Eigen::Vector3d(0.0, 0.0, 0.0), Eigen::Vector3d(1.0, 2.0, 0.0)}) {
    std::ostringstream text;
    text << "<box size='" << size.transpose() << "'/>";
    const ReadText read = readText(robotXml(linkXml("a", text.str())));
    EXPECT_EQ(std::get<Box>(only(read).geometry).half_extents, 0.5 * size);
    EXPECT_EQ(read.warnings(),
              std::vector<std::string>{
                  "test.urdf: a size of 0: link 'a', collision 1; they are taken as the points, "
                  "lines or faces that they are"});
  }
}

TEST(UrdfGeometry, origin_missing_isIdentity) {
  const ReadText read = readText(robotXml(linkXml("a", "<sphere radius='1'/>")));
  EXPECT_EQ(only(read).link_from_geometry.rotation, Eigen::Matrix3d::Identity());
  EXPECT_EQ(only(read).link_from_geometry.translation, Eigen::Vector3d::Zero());
}

TEST(UrdfGeometry, origin_turnsRollThenPitchThenYawAboutFixedAxes) {
  // Roll by 90 deg takes y to z; pitch by 90 deg takes that z to x; yaw by 90 deg takes that x to
  // y.
  const ReadText read = readText(robotXml(linkXml(
      "a", "<sphere radius='1'/>",
      "<origin xyz='1 2 3' rpy='1.5707963267948966 1.5707963267948966 1.5707963267948966'/>")));
  const Pose& pose = only(read).link_from_geometry;
  EXPECT_TRUE(pose.translation.isApprox(Eigen::Vector3d(1.0, 2.0, 3.0)));
  EXPECT_LT((pose.rotation * Eigen::Vector3d::UnitY() - Eigen::Vector3d::UnitY()).norm(), 1e-15);
  // x is left by roll, goes to -z by pitch and stays there.
  EXPECT_LT((pose.rotation * Eigen::Vector3d::UnitX() + Eigen::Vector3d::UnitZ()).norm(), 1e-15);
}

TEST(UrdfGeometry, extensionBesideAShape_isIgnored) {
  const ReadText read =
      readText(robotXml(linkXml("a", "<sphere radius='1'/><drake:declare_convex/>")));
  EXPECT_EQ(std::get<Sphere>(only(read).geometry).radius, 1.0);
}

TEST(UrdfGeometry, mesh_isScaledAxisByAxis) {
  const ReadText read =
      readText(robotXml(linkXml("a", "<mesh filename='package://p/t.obj' scale='0.5 1 2'/>")),
               {{"package://p/t.obj", kTriangleObj}});
  const auto& mesh = std::get<TriangleMesh>(only(read).geometry);
  ASSERT_EQ(mesh.vertices.size(), 3u);
  EXPECT_EQ(mesh.vertices[1], Eigen::Vector3d(0.5, 2.0, 0.0));
  EXPECT_EQ(mesh.vertices[2], Eigen::Vector3d(0.0, 2.0, 6.0));
}

TEST(UrdfGeometry, meshScaledBeyondSense_isRefused) {
  const std::map<std::string, std::string> files{{"/t.obj", kTriangleObj}};
  const auto read = [&](const std::string& scale) {
    return readText(robotXml(linkXml("a", "<mesh filename='/t.obj' scale='" + scale + "'/>")),
                    files);
  };
  EXPECT_TRUE(read("1 1 3e8").errors().empty()) << "no vertex has a z above 3";
  for (const char* scale : {"1 1 4e8", "1 1 1e308"}) {
    EXPECT_EQ(read(scale).errors(),
              std::vector<std::string>{"test.urdf line 2, link 'a', collision 1: mesh '/t.obj' "
                                       "with scale '" +
                                       std::string(scale) +
                                       "': a vertex beyond 1e9 m; accepted: vertices whose "
                                       "coordinates are within 1e9 m of 0"});
  }
}

TEST(UrdfGeometry, meshMirroredByItsScale_keepsItsOutside) {
  const std::map<std::string, std::string> files{{"/t.obj", kTriangleObj}};
  const auto normalOf = [&](const std::string& scale) -> Eigen::Vector3d {
    const ReadText read =
        readText(robotXml(linkXml("a", "<mesh filename='/t.obj' scale='" + scale + "'/>")), files);
    const auto& mesh = std::get<TriangleMesh>(only(read).geometry);
    const auto& t = mesh.triangles.at(0);
    return (mesh.vertices[t[1]] - mesh.vertices[t[0]])
        .cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]);
  };
  // The normal (1,2,0) x (0,2,3) = (6,-3,2) mirrored at the plane x = 0.
  EXPECT_EQ(normalOf("1 1 1"), Eigen::Vector3d(6.0, -3.0, 2.0));
  EXPECT_EQ(normalOf("-1 1 1"), Eigen::Vector3d(-6.0, -3.0, 2.0));
  EXPECT_EQ(normalOf("-1 -1 1"), Eigen::Vector3d(-6.0, 3.0, 2.0));
}

TEST(UrdfGeometry, meshWithoutArea_isAWarning) {
  const ReadText read = readText(robotXml(linkXml("a", "<mesh filename='/line.obj'/>")),
                                 {{"/line.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n"}});
  EXPECT_EQ(std::get<TriangleMesh>(only(read).geometry).vertices.size(), 3u);
  EXPECT_EQ(
      read.warnings(),
      std::vector<std::string>{
          "test.urdf: meshes without area: link 'a', collision 1; they are taken as the lines and "
          "points that they are"});
}

TEST(UrdfGeometry, collisionNames_areUniqueWithinTheLink) {
  const std::string sphere = "<geometry><sphere radius='1'/></geometry></collision>";
  const ReadText read = readText(robotXml(
      "<link name='a'><collision name='palm'>" + sphere + "<collision>" + sphere +
      "<collision name='palm'>" + sphere + "<collision name='collision_1'>" + sphere + "</link>"));
  std::vector<std::string> names;
  for (const CollisionElement& collision : read.model.links.at(0).collisions) {
    names.push_back(collision.name);
  }
  EXPECT_EQ(names, (std::vector<std::string>{"palm", "collision_1", "palm_2", "collision_1_2"}));
}

}  // namespace
}  // namespace collision_monitor
