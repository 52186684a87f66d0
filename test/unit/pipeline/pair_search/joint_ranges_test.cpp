// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/pair_search/joint_ranges.h"

#include <gtest/gtest.h>

#include <cmath>

#include "collision_monitor/pipeline/setup.h"
#include "support/robots/urdf_text.h"

namespace collision_monitor::test {
namespace {

std::string limitXml(const std::string& lower, const std::string& upper) {
  return "<limit lower='" + lower + "' upper='" + upper + "' velocity='1' effort='1'/>";
}

CycleSetup robotOn(const std::string& more) {
  const std::string xml = linkXml("base", "<sphere radius='0.1'/>") + more;
  return buildSetup({describeText(robotXml(xml))}, textLoader({}), SetupOptions());
}

TEST(JointRanges, limitsAndWhatHasNone) {
  const std::string slide = "<axis xyz='1 0 0'/>";
  const CycleSetup setup =
      robotOn("<link name='a'/><link name='b'/><link name='c'/>" +
              jointXml("slide", "prismatic", "base", "a", slide + limitXml("-0.2", "0.5")) +
              jointXml("roll", "continuous", "base", "b", slide) +
              jointXml("air", "floating", "base", "c"));
  const std::vector<JointRange> ranges = jointRanges(setup.model);
  ASSERT_EQ(ranges.size(), 2U);
  std::mt19937_64 random(1);
  for (int i = 0; i < 100; ++i) {
    const JointPositions state = drawState(setup.model, ranges, random);
    for (const JointRange& range : ranges) {
      const Joint& joint = setup.model.joint(range.joint);
      const double half_turn = std::acos(-1.0);
      const double lower = joint.name == "slide" ? -0.2 : joint.name == "roll" ? -half_turn : -1.0;
      const double upper = joint.name == "slide" ? 0.5 : joint.name == "roll" ? half_turn : 1.0;
      EXPECT_NEAR(range.lower, lower, 1e-12);
      EXPECT_NEAR(range.upper, upper, 1e-12);
      EXPECT_TRUE(range.is_whole);
      EXPECT_GE(state[joint.first_variable], lower - 1e-12);
      EXPECT_LE(state[joint.first_variable], upper + 1e-12);
    }
    const double* air =
        state.data() + setup.model.joint(*setup.model.findJoint("air")).first_variable;
    EXPECT_NEAR(air[3] * air[3] + air[4] * air[4] + air[5] * air[5] + air[6] * air[6], 1.0, 1e-12);
    EXPECT_LE(std::abs(air[2]), 1.0);
  }
}

TEST(JointRanges, limitOnOneSide_isKept) {
  const std::string slide = "<axis xyz='1 0 0'/>";
  const CycleSetup setup =
      robotOn("<link name='a'/><link name='b'/>" +
              jointXml("out", "prismatic", "base", "a", slide + limitXml("3", "1e16")) +
              jointXml("in", "prismatic", "base", "b", slide + limitXml("-1e16", "0.2")));
  std::size_t found = 0;
  for (const JointRange& range : jointRanges(setup.model)) {
    const std::string& name = setup.model.joint(range.joint).name;
    if (name == "out" || name == "in") {
      ++found;
      EXPECT_EQ(range.lower, name == "out" ? 3.0 : -1.0);
      EXPECT_EQ(range.upper, name == "out" ? 4.0 : 0.2);
      EXPECT_FALSE(range.is_whole) << "it may do more";
    }
  }
  EXPECT_EQ(found, 2U);
}

}  // namespace
}  // namespace collision_monitor::test
