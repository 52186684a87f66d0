// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/unknowns.h"

#include <gtest/gtest.h>

#include "pipeline/cycle/run_cycle.h"
#include "unit/ros_edge/edge_scene.h"

namespace collision_monitor::test {
namespace {

class UnknownsTest : public EdgeScene {
 protected:
  LinkId link(const char* name) const { return linkNamed(setup_->setup.model, name); }
};

TEST_F(UnknownsTest, whileNothingChanges_areNotSoughtAgain) {
  const auto watch = watchAt(0.5);
  floatFrom(index(link("tool")), LinkStatus::stale, watch->poses);
  runCycle(watch->setup(), watch->poses, watch->buffers);
  EXPECT_EQ(watch->unknown().links(), std::vector<LinkId>{link("tool")});
  EXPECT_EQ(watch->unknown().between(0, 0).count, 2U);
  // Without another judgement the verdicts are not looked at.
  watch->buffers.events.verdicts.assign(watch->setup().checked.size(), Verdict::clear);
  EXPECT_EQ(watch->unknown().between(0, 0).count, 2U);
}

TEST_F(UnknownsTest, followEachJudgement) {
  const auto watch = watchAt(0.5);
  EXPECT_TRUE(watch->unknown().links().empty());
  floatFrom(index(link("tool")), LinkStatus::stale, watch->poses);
  runCycle(watch->setup(), watch->poses, watch->buffers);
  EXPECT_EQ(watch->unknown().links(), std::vector<LinkId>{link("tool")});
  EXPECT_EQ(watch->unknown().loneLinks(), std::vector<LinkId>{link("tool")});
  watch->poses = slidingPoses(setup_->setup.model, 0.0, 0.5);
  floatSlider(setup_->setup.model, watch->poses);
  runCycle(watch->setup(), watch->poses, watch->buffers);
  EXPECT_EQ(watch->unknown().links(), (std::vector<LinkId>{link("tool"), link("finger")}));
  EXPECT_EQ(watch->unknown().parts().size(), 1U);
  EXPECT_TRUE(watch->unknown().loneLinks().empty());
  watch->poses = slidingPoses(setup_->setup.model, 0.0, 0.5);
  runCycle(watch->setup(), watch->poses, watch->buffers);
  EXPECT_TRUE(watch->unknown().links().empty());
  EXPECT_EQ(watch->unknown().between(0, 0).count, 0U);
}

}  // namespace
}  // namespace collision_monitor::test
