// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sphere_overlaps.h"

#include <gtest/gtest.h>

#include "outputs/exports.h"
#include "support/robots/urdf_text.h"

namespace collision_monitor::fit_tool {
namespace {

/// Two cubes of 0.2 m with their centers 0.3 m apart, and a ball 1 m above that both turn against.
FittedRobot cubes() {
  const std::string cube = "<box size='0.2 0.2 0.2'/>";
  return fitRobot(
      test::describeText(test::robotXml(
          test::linkXml("base", cube) + test::linkXml("arm", "<sphere radius='0.01'/>") +
          test::linkXml("tip", cube) +
          test::jointXml("shoulder", "continuous", "base", "arm", "<origin xyz='0 0 1'/>") +
          test::jointXml("wrist", "continuous", "arm", "tip", "<origin xyz='0.3 0 -1'/>"))),
      test::textLoader({}), FitRequest(), {});
}

std::vector<Problem> overlapsWith(std::size_t leaves) {
  const FittedRobot robot = cubes();
  return sphereOverlaps(robot.model, buildSpheres(robot, leaves));
}

TEST(SphereOverlaps, oneSphereACube_namesThePairAndByHowMuch) {
  const std::vector<Problem> overlaps = overlapsWith(1);
  ASSERT_EQ(overlaps.size(), 1U);
  EXPECT_EQ(overlaps[0].where, "spheres of 'base' and 'tip'");
  // Twice sqrt(3) 0.1 m less 0.3 m.
  EXPECT_EQ(overlaps[0].found, "the finest overlap by 46.4 mm in the default pose");
}

TEST(SphereOverlaps, manySpheresACube_areApartAsTheCubesAre) {
  EXPECT_TRUE(overlapsWith(64).empty());
}

}  // namespace
}  // namespace collision_monitor::fit_tool
