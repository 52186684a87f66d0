// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/parameters/second_opinion.h"

#include <gtest/gtest.h>

#include "support/robots/urdf_text.h"

namespace collision_monitor::test {
namespace {

std::string turning(const std::string& axis) {
  return robotXml(linkXml("base", "<sphere radius='0.1'/>") +
                  linkXml("rod", "<sphere radius='0.1'/>") +
                  jointXml("turn", "continuous", "base", "rod", "<axis xyz='" + axis + "'/>"));
}

/// A set-up of one text that says it was built from another.
std::shared_ptr<MonitorSetup> setupOf(const std::string& text, const std::string& other) {
  auto setup = std::make_shared<MonitorSetup>();
  setup->setup = buildSetup({describeText(text)}, textLoader({}), SetupOptions());
  setup->descriptions = {describeText(other)};
  return setup;
}

TEST(SecondOpinion, differentReading_isALaterWarningOfItsSetup) {
  const auto alike = setupOf(turning("0 0 1"), turning("0 0 1"));
  const auto differing = setupOf(turning("0 0 1"), turning("0 1 0"));
  const std::size_t built_with = differing->setup.report.warnings.size();
  LogThread log;
  SecondOpinion opinion(log);
  opinion.askFor(differing);
  opinion.askFor(alike);
  opinion.wait();
  EXPECT_TRUE(alike->later_warnings->all().empty());
  const std::vector<Problem> warnings = differing->later_warnings->all();
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings[0].where, "test.urdf, joint 'turn'");
  EXPECT_EQ(warnings[0].found, "axis 0 0 1 as it is read here, axis 0 1 0 as urdfdom reads it");
  EXPECT_EQ(differing->setup.report.warnings.size(), built_with)
      << "the set-up stays as it was built";
}

}  // namespace
}  // namespace collision_monitor::test
