// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "support/robots/urdf_text.h"

namespace collision_monitor::test {
namespace {

std::string robotWith(const std::string& version, const std::string& origin) {
  std::string text = robotXml(linkXml("a", "<sphere radius='1'/>", origin));
  text.insert(text.find(" name"), version.empty() ? "" : " version='" + version + "'");
  return text;
}

TEST(UrdfOrigin, quaternion_sinceVersionOneOne_isTakenAndNormalised) {
  // A quarter turn about z takes x to y.
  const std::string half = std::to_string(std::sqrt(0.5));
  for (const std::string& quaternion : {"0 0 " + half + " " + half, std::string("0 0 -3 -3")}) {
    for (const char* version : {"1.1", "1.2", "1.10", "2.0", "2"}) {
      const ReadText read =
          readText(robotWith(version, "<origin xyz='1 2 3' quat_xyzw='" + quaternion + "'/>"));
      ASSERT_TRUE(read.report.errors.empty()) << toString(read.report.errors[0]);
      const Pose& pose = read.model.links[0].collisions[0].link_from_geometry;
      EXPECT_EQ(pose.translation, Eigen::Vector3d(1.0, 2.0, 3.0));
      EXPECT_LT((pose.rotation * Eigen::Vector3d::UnitX() - Eigen::Vector3d::UnitY()).norm(),
                1e-15);
    }
  }
}

std::string faultOf(const std::string& version, const std::string& attributes) {
  const ReadText read = readText(robotWith(version, "<origin " + attributes + "/>"));
  return read.report.errors.size() == 1 ? toString(read.report.errors[0])
                                        : std::to_string(read.report.errors.size()) + " errors";
}

TEST(UrdfOrigin, quaternion_beforeVersionOneOne_isAnError) {
  for (const char* version : {"", "1.0", "1", "0.9", "new", "1.x"}) {
    EXPECT_NE(
        faultOf(version, "quat_xyzw='0 0 0 1'").find("in a URDF of version 1.0; accepted: rpy"),
        std::string::npos)
        << version;
  }
}

TEST(UrdfOrigin, quaternionThatIsNone_isAnError) {
  for (const char* numbers : {"0 0 0 0", "0 0 1", "0 0 nan 1", "x"}) {
    EXPECT_NE(faultOf("1.1", std::string("quat_xyzw='") + numbers + "'")
                  .find("accepted: four finite numbers separated by spaces, not all 0: x y z w"),
              std::string::npos)
        << numbers;
  }
  EXPECT_NE(faultOf("1.1", "rpy='0 0 0' quat_xyzw='0 0 0 1'").find("both rpy and quat_xyzw"),
            std::string::npos);
}

}  // namespace
}  // namespace collision_monitor::test
