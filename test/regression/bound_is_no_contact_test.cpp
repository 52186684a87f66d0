// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause

// A search for the nearest pair ends at a lower bound where another pair is nearer. check_states
// judged that bound as if it were the distance: a pair with a larger contact distance of its own
// was called a contact, though it was clear of it.
#include <gtest/gtest.h>

#include "pipeline/states/check_states.h"
#include "support/robots/file_loader.h"
#include "support/robots/robot_moves.h"
#include "support/robots/ruled_setup.h"

namespace collision_monitor::test {
namespace {

TEST(BoundIsNoContact, bothQuestions_findTheSameContacts) {
  if (!sharedDataDir()) {
    GTEST_SKIP() << kNoSharedData;
  }
  const std::optional<RobotFile> file = findRobot("ur5_robotiq/");
  ASSERT_TRUE(file);
  CycleSetup setup = buildSetup({describe(*file)}, fileLoader(file->package_root), {});
  Random random(1);
  for (int round = 0; round < 30; ++round) {
    giveRules({ruleForSome(randomLimits(random), setup, random),
               ruleForSome(randomLimits(random), setup, random)},
              setup);
    StatesWork work = makeStatesWork(setup, standingAt(setup.model, {Pose()}));
    JointPositions positions;
    for (int i = 0; i < 100; ++i) {
      const JointPositions one = drawPositions(setup.model, random);
      positions.insert(positions.end(), one.begin(), one.end());
    }
    std::vector<StateCheck> contact;
    std::vector<StateCheck> nearest;
    checkStatesExactly(setup, positions, StateQuestion::contact, work, contact);
    checkStatesExactly(setup, positions, StateQuestion::nearest, work, nearest);
    for (std::size_t i = 0; i < contact.size(); ++i) {
      ASSERT_EQ(nearest[i].verdict == Verdict::contact, contact[i].verdict == Verdict::contact)
          << "round " << round << ", state " << i;
    }
  }
}

}  // namespace
}  // namespace collision_monitor::test
