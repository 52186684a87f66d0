// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause

// check_states called a state a warning although a pair was in contact by a limit of its own. All
// shapes were their own geometry, and another pair, which was nearer, had a smaller limit: the
// search for the nearest pair passed over all others once it knew a warning.
#include <gtest/gtest.h>

#include "pipeline/cycle/run_cycle.h"
#include "pipeline/states/check_states.h"
#include "support/robots/hand_made_setup.h"
#include "support/robots/ruled_setup.h"

namespace collision_monitor::test {
namespace {

Joint fixedJoint(LinkId child, const Pose& parent_from_joint) {
  Joint joint;
  joint.type = JointType::fixed;
  joint.child = child;
  joint.parent_from_joint = parent_from_joint;
  return joint;
}

/// Three balls on one body: the second 1 mm from the first, and the third 3 mm, which is a contact
/// for these two alone.
class OwnLimitsOfBodies : public testing::Test {
 protected:
  OwnLimitsOfBodies() {
    Limits own = setup_.limits;
    own.contact_distance = 0.004;
    giveRules({ruleForAll(own, setup_)}, setup_);
    setup_.is_continuous = false;
    for (CheckedLinkPair& pair : setup_.checked) {
      pair.limits = pair.b == LinkId{2} && pair.a == LinkId{0} ? pair.limits : 0;
    }
    poses_.world_from_link[1].translation.x() = 0.201;
    poses_.world_from_link[2].translation.x() = -0.203;
    for (std::size_t link = 1; link < 3; ++link) {
      setup_.model.joints.push_back(fixedJoint(idAt<LinkId>(link), poses_.world_from_link[link]));
      setup_.model.links[link].parent_joint = idAt<JointId>(link - 1);
    }
    setup_.model.robots[0].joint_count = 2;
  }

  CycleSetup setup_ = handMadeSetup({{0, Sphere{0.1}}, {1, Sphere{0.1}}, {2, Sphere{0.1}}});
  LinkPoses poses_ = knownPoses(setup_);
};

TEST_F(OwnLimitsOfBodies, aFartherPairInContact_isAContactForAllQuestions) {
  CycleBuffers buffers = makeBuffers(setup_, BroadPhaseKind::brute_force);
  runCycle(setup_, poses_, buffers);
  ASSERT_EQ(buffers.events.overall, Verdict::contact);
  StatesWork work = makeStatesWork(setup_, standingAt(setup_.model, {Pose()}));
  std::vector<StateCheck> checks;
  for (const StateQuestion question : {StateQuestion::contact, StateQuestion::nearest}) {
    checkStatesExactly(setup_, {}, question, work, checks);
    EXPECT_EQ(checks.at(0).verdict, Verdict::contact);
  }
}

}  // namespace
}  // namespace collision_monitor::test
