// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstring>

#include "model/kinematics/state_kinematics.h"
#include "support/fixed_seed.h"
#include "support/instruction_sets.h"
#include "support/robots/random_model.h"

namespace collision_monitor::test {
namespace {

std::vector<StatePose> placedBy(std::int64_t target, const KinematicsPlan& plan,
                                const std::vector<StateNumber>& variables) {
  const OnlyInstructionSet only(target);
  std::vector<StatePose> frames(plan.frames.size());
  placeFrames(plan, variables, frames);
  return frames;
}

TEST(StateKinematicsLaws, everyModelInEveryStateIsPlacedAsByThePlainTwin) {
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  Random random(kSeed);
  for (int round = 0; round < 300; ++round) {
    const RobotModel model = randomModel(2 + random() % 12, random);
    const std::vector<Pose> roots{randomPose(random, 2.0)};
    const KinematicsPlan plan = planKinematics(model, standingAt(model, roots));
    std::vector<StateNumber> variables(plan.variable_count);
    std::vector<JointPositions> states(kStateCount);
    for (StateNumber& variable : variables) {
      for (std::size_t state = 0; state < kStateCount; ++state) {
        variable.of[state] = uniform(random, -7.0, 7.0);
        states[state].push_back(variable.of[state]);
      }
    }
    std::vector<StatePose> first;
    for (const std::int64_t target : instructionSets()) {
      const std::vector<StatePose> frames = placedBy(target, plan, variables);
      if (!first.empty()) {
        ASSERT_EQ(std::memcmp(first.data(), frames.data(), frames.size() * sizeof(StatePose)), 0)
            << hwy::TargetName(target);
      }
      first = frames;
    }
    for (std::size_t state = 0; state < kStateCount; ++state) {
      std::vector<Pose> links;
      placeLinks(model, states[state], roots, links);
      for (std::size_t link = 0; link < links.size(); ++link) {
        const LinkPlace& place = plan.links[link];
        Pose found = place.frame_from_link;
        if (place.frame != MovingFrame::kWorld) {
          found = poseOf(first[place.frame], state) * found;
        }
        ASSERT_LE((found.rotation - links[link].rotation).cwiseAbs().maxCoeff(), 1e-13);
        ASSERT_LE((found.translation - links[link].translation).norm(), 1e-12);
      }
    }
  }
}

}  // namespace
}  // namespace collision_monitor::test
