// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/states/check_states.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "pipeline/states/states_block.h"
#include "support/instruction_sets.h"
#include "support/robots/ruled_setup.h"
#include "support/robots/urdf_text.h"

namespace collision_monitor::test {
namespace {

std::string slider(const std::string& name, const std::string& link, const std::string& origin,
                   const std::string& axis) {
  return jointXml(name, "prismatic", "rail", link,
                  "<origin xyz='" + origin + "'/><axis xyz='" + axis +
                      "'/><limit lower='-9' upper='9' velocity='1' effort='1'/>");
}

/// A rail far below, on which whatever is to meet slides, for neighbours are not checked.
std::string rail() { return linkXml("rail", "<sphere radius='0.1'/>", "<origin xyz='0 0 -50'/>"); }

/// Balls of 0.1, 0.1 and 0.2 m on x at push, 1 + slide and 4 + reach.
CycleSetup threeBalls() {
  const std::string small = "<sphere radius='0.1'/>";
  return buildSetup(
      {describeText(robotXml(rail() + linkXml("base", small) + linkXml("slider", small) +
                             linkXml("tool", "<sphere radius='0.2'/>") +
                             slider("push", "base", "0 0 0", "1 0 0") +
                             slider("slide", "slider", "1 0 0", "1 0 0") +
                             slider("reach", "tool", "4 0 0", "1 0 0")))},
      textLoader({}), SetupOptions());
}

class CheckStatesTest : public testing::TestWithParam<std::int64_t> {
 protected:
  std::vector<StateCheck> check(const JointPositions& positions, StateQuestion question) {
    std::vector<StateCheck> checks;
    checkStates(setup_, positions, question, work_, checks);
    return checks;
  }
  std::string tableLink(PairId pair, bool is_b) const {
    const BodyPair& bodies = setup_.table[pair];
    return setup_.model.link(setup_.bodies[index(is_b ? bodies.b : bodies.a)].link).name;
  }

  CycleSetup setup_ = threeBalls();
  StatesWork work_ = makeStatesWork(setup_, standingAt(setup_.model, {Pose{}}));

 private:
  OnlyInstructionSet only_{GetParam()};
};

TEST_P(CheckStatesTest, linkPairsInEveryState_asFarAsIsAsked) {
  // Balls at 0, 1 and 4; 0, 0.1 and 4; 0.5, 1 and 1.4; and one that nobody knows.
  const double nan = std::numeric_limits<double>::quiet_NaN();
  fillVariables({0, 0, 0, 0, -0.9, 0, 0.5, 0, -2.6, 0, nan, 0}, 0, work_);
  placeStates(setup_, work_);
  std::vector<StateNumber> nearest(setup_.checked.size());
  const auto of = [&](const char* a, const char* b) -> StateNumber& {
    for (std::size_t i = 0; i < setup_.checked.size(); ++i) {
      if (setup_.model.link(setup_.checked[i].a).name == a &&
          setup_.model.link(setup_.checked[i].b).name == b) {
        return nearest[i];
      }
    }
    throw std::out_of_range(std::string(a) + " and " + b);
  };
  for (StateNumber& distances : nearest) {
    std::fill(std::begin(distances.of), std::end(distances.of), 1.0);
  }
  StateNumber& left_out = of("base", "tool");
  std::fill(std::begin(left_out.of), std::end(left_out.of), kNotAsked);
  measureLinkPairs(setup_, work_, nearest);
  EXPECT_NEAR(of("base", "slider").of[0], 0.8, 1e-12);
  EXPECT_NEAR(of("base", "slider").of[1], -0.1, 1e-12);
  EXPECT_NEAR(of("base", "slider").of[2], 0.3, 1e-12);
  EXPECT_TRUE(std::isnan(of("base", "slider").of[3]));
  EXPECT_EQ(of("slider", "tool").of[0], 1.0) << "2.7 m are farther than is asked";
  EXPECT_NEAR(of("slider", "tool").of[2], 0.1, 1e-12);
  EXPECT_TRUE(std::isnan(of("slider", "tool").of[3]));
  for (const double distance : left_out.of) {
    EXPECT_EQ(distance, kNotAsked);
  }
}

TEST_P(CheckStatesTest, nearestPairOfEveryState) {
  ASSERT_EQ(setup_.table.size(), 3U) << "all three pairs are checked";
  const auto checks =
      check({0, 0, 0, 0, -0.77, 0, 0, -0.9, 0, 0, 0, -2.75, 0, 0, -3.9}, StateQuestion::nearest);
  ASSERT_EQ(checks.size(), 5U);
  EXPECT_NEAR(checks[0].distance, 0.8, 1e-12);
  EXPECT_EQ(checks[0].verdict, Verdict::clear);
  EXPECT_NEAR(checks[1].distance, 0.03, 1e-12);
  EXPECT_EQ(checks[1].verdict, Verdict::warning);
  EXPECT_EQ(tableLink(checks[1].pair, false), "base");
  EXPECT_EQ(tableLink(checks[1].pair, true), "slider");
  EXPECT_NEAR(checks[2].distance, -0.1, 1e-12);
  EXPECT_EQ(checks[2].verdict, Verdict::contact);
  EXPECT_EQ(checks[2].quality, Quality::exact);
  EXPECT_NEAR(checks[3].distance, -0.05, 1e-12);
  EXPECT_EQ(tableLink(checks[3].pair, false), "slider");
  EXPECT_NEAR(checks[4].distance, -0.2, 1e-12);
  EXPECT_EQ(tableLink(checks[4].pair, false), "base");
}

TEST_P(CheckStatesTest, contactQuestion_answersThatAlone) {
  const auto checks = check({0, 0, 0, 0, -0.77, 0, 0, -0.9, 0}, StateQuestion::contact);
  EXPECT_EQ(checks[0].verdict, Verdict::clear);
  EXPECT_FALSE(checks[0].has_pair);
  EXPECT_EQ(checks[1].verdict, Verdict::clear) << "near is no contact";
  EXPECT_EQ(checks[2].verdict, Verdict::contact);
  EXPECT_TRUE(checks[2].has_pair);
  EXPECT_EQ(tableLink(checks[2].pair, true), "slider");
}

TEST_P(CheckStatesTest, variableThatIsNotFinite_stateIsUnknownAndItsNeighboursAreNot) {
  JointPositions positions;
  for (int state = 0; state < 19; ++state) {
    positions.push_back(state % 3 == 0 ? std::nan("") : 0.0);
    positions.push_back(state % 5 == 4 ? INFINITY : 0.0);
    positions.push_back(0.0);
  }
  for (const StateQuestion question : {StateQuestion::contact, StateQuestion::nearest}) {
    const auto checks = check(positions, question);
    ASSERT_EQ(checks.size(), 19U);
    for (std::size_t state = 0; state < 19; ++state) {
      const bool is_unknown = state % 3 == 0 || state % 5 == 4;
      EXPECT_EQ(checks[state].verdict, is_unknown ? Verdict::unknown : Verdict::clear) << state;
    }
  }
}

TEST_P(CheckStatesTest, unknownHeldJoint_pairsBehindItAreUnknown) {
  StandingPoses standing = standingAt(setup_.model, {Pose{}});
  Pose lost;
  lost.translation.setConstant(std::numeric_limits<double>::quiet_NaN());
  standing.held[2] = lost;
  work_ = makeStatesWork(setup_, standing);
  EXPECT_EQ(check({0, 0, 0}, StateQuestion::nearest)[0].verdict, Verdict::unknown);
  EXPECT_EQ(check({0, -0.9, 0}, StateQuestion::nearest)[0].verdict, Verdict::contact)
      << "base and slider are known and touch";
}

TEST_P(CheckStatesTest, parallelBoxes_areLeftToThePlainTwin) {
  const std::string cube = "<box size='0.2 0.2 0.2'/>";
  const CycleSetup setup =
      buildSetup({describeText(robotXml(rail() + linkXml("a", cube) + linkXml("b", cube) +
                                        slider("move_a", "a", "0 0 0", "1 0 0") +
                                        slider("move_b", "b", "1 0 0", "1 0 0")))},
                 textLoader({}), SetupOptions());
  StatesWork work = makeStatesWork(setup, standingAt(setup.model, {Pose{}}));
  std::vector<StateCheck> checks;
  checkStates(setup, {0, 0, 0, -0.9}, StateQuestion::nearest, work, checks);
  EXPECT_NEAR(checks[0].distance, 0.8, 1e-12);
  EXPECT_EQ(checks[0].verdict, Verdict::clear);
  EXPECT_NEAR(checks[1].distance, -0.1, 1e-12);
  EXPECT_EQ(checks[1].verdict, Verdict::contact);
}

TEST_P(CheckStatesTest, noStates_noAnswers) {
  EXPECT_TRUE(check({}, StateQuestion::nearest).empty());
}

TEST_P(CheckStatesTest, modelWithoutVariables_hasOneState) {
  const auto ball = [](const std::string& robot) {
    return describeText("<robot name='" + robot + "'>" + linkXml(robot, "<sphere radius='0.1'/>") +
                        "</robot>");
  };
  const CycleSetup setup =
      buildSetup({ball("left"), ball("right")}, textLoader({}), SetupOptions());
  const Pose beside{Eigen::Matrix3d::Identity(), {0.15, 0, 0}};
  StatesWork work = makeStatesWork(setup, standingAt(setup.model, {Pose{}, beside}));
  std::vector<StateCheck> checks;
  for (const StateQuestion question : {StateQuestion::contact, StateQuestion::nearest}) {
    checkStates(setup, {}, question, work, checks);
    ASSERT_EQ(checks.size(), 1U);
    EXPECT_EQ(checks[0].verdict, Verdict::contact);
    EXPECT_NEAR(checks[0].distance, -0.05, 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(EveryInstructionSet, CheckStatesTest, testing::ValuesIn(instructionSets()),
                         [](const auto& target) { return hwy::TargetName(target.param); });

/// Two balls are in contact by a limit of their own; two others, which are not, are nearer.
TEST(CheckStatesExactly, contactByALimitOfItsOwn_isNotAlwaysTheNearest) {
  const auto ball = [](const std::string& name, const std::string& x) {
    return linkXml(name, "<sphere radius='0.1'/>") +
           slider("move_" + name, name, x + " 0 0", "1 0 0");
  };
  CycleSetup setup = buildSetup(
      {describeText(robotXml(rail() + ball("a", "0") + ball("b", "0.23") + ball("c", "0.45")))},
      textLoader({}), SetupOptions());
  Limits limits = setup.limits;
  limits.contact_distance = 0.05;
  limits.warning_distance = 0.06;
  PairRule rule = ruleForAll(limits, setup);
  for (std::size_t i = 0; i < setup.model.links.size(); ++i) {
    rule.a[i] = setup.model.links[i].name == "a";
    rule.b[i] = setup.model.links[i].name == "b";
  }
  giveRules({rule}, setup);
  StatesWork work = makeStatesWork(setup, standingAt(setup.model, {Pose{}}));
  std::vector<StateCheck> checks;
  checkStatesExactly(setup, {0, 0, 0}, StateQuestion::nearest, work, checks);
  EXPECT_EQ(checks[0].verdict, Verdict::contact);
  EXPECT_NEAR(checks[0].distance, 0.02, 1e-12) << "of b and c";
}

/// A can 0.4 m high and 0.1 m in radius, enclosed by more than itself, and a ball of 0.1 m above.
TEST(CheckStatesExactly, geometriesDecideWhereEnclosingShapesAreNear) {
  SetupOptions options;
  options.default_limits = {1, 0.0, {}};
  options.limits.warning_distance = 0.01;
  const CycleSetup setup = buildSetup(
      {describeText(robotXml(rail() + linkXml("can", "<cylinder radius='0.1' length='0.4'/>") +
                             linkXml("ball", "<sphere radius='0.1'/>") +
                             slider("hold", "can", "0 0 0", "0 0 1") +
                             slider("lift", "ball", "0 0 1.305", "0 0 1")))},
      textLoader({}), options);
  ASSERT_EQ(setup.table.size(), 1U);
  StatesWork work = makeStatesWork(setup, standingAt(setup.model, {Pose{}}));
  const JointPositions positions = {0, -1, 0, -1.02, 0, 0, 0, std::nan("")};
  std::vector<StateCheck> shapes;
  std::vector<StateCheck> exact;
  checkStates(setup, positions, StateQuestion::nearest, work, shapes);
  checkStatesExactly(setup, positions, StateQuestion::nearest, work, exact);
  EXPECT_NEAR(exact[0].distance, 0.005, 1e-9);
  EXPECT_EQ(exact[0].verdict, Verdict::warning);
  EXPECT_EQ(exact[0].quality, Quality::exact);
  EXPECT_LT(shapes[0].distance, exact[0].distance) << "a bound";
  EXPECT_NEAR(exact[1].distance, -0.015, 1e-7);
  EXPECT_EQ(exact[1].verdict, Verdict::contact);
  EXPECT_EQ(exact[2].verdict, Verdict::clear);
  EXPECT_EQ(exact[2].quality, Quality::lower_bound);
  EXPECT_EQ(exact[3].verdict, Verdict::unknown);
  checkStatesExactly(setup, positions, StateQuestion::contact, work, exact);
  EXPECT_EQ(exact[0].verdict, Verdict::clear);
  EXPECT_FALSE(exact[0].has_pair) << "near is no contact, so there is no pair in contact";
  EXPECT_EQ(exact[1].verdict, Verdict::contact);
  EXPECT_TRUE(exact[1].has_pair);
}

/// Answers of a geometry that leaves another of its kind along a diagonal in steps of 1 mm. Their
/// frames are 0.424 m apart at position 0.
struct Leaving {
  Leaving(const std::string& geometry, double first, std::size_t count,
          const SetupOptions& options = {}) {
    const CycleSetup setup =
        buildSetup({describeText(robotXml(rail() + linkXml("a", geometry) + linkXml("b", geometry) +
                                          slider("hold", "a", "0 0 0", "1 1 0") +
                                          slider("lift", "b", "0.3 0.3 0", "1 1 0")))},
                   textLoader({}), options);
    StatesWork work = makeStatesWork(setup, standingAt(setup.model, {Pose{}}));
    JointPositions positions;
    for (std::size_t i = 0; i < count; ++i) {
      const double position = first + 0.001 * static_cast<double>(i);
      positions.insert(positions.end(), {0.0, position});
      apart.push_back(0.3 * std::sqrt(2.0) + position);
    }
    checkStatesExactly(setup, positions, StateQuestion::nearest, work, checks);
  }

  std::vector<StateCheck> checks;
  std::vector<double> apart;  ///< [m] their frames
};

TEST(CheckStatesExactly, limitsBelowZero_areAnswered) {
  SetupOptions options;
  options.limits.contact_distance = -0.02;
  options.limits.warning_distance = -0.01;
  const Leaving cans("<cylinder radius='0.1' length='0.4'/>", -0.3, 150, options);
  for (std::size_t i = 0; i < cans.checks.size(); ++i) {
    EXPECT_TRUE(cans.checks[i].has_pair) << cans.apart[i];
    EXPECT_LE(cans.checks[i].distance, cans.apart[i] - 0.2 + 1e-7);
  }
}

/// The corners of a box around a disc stick out of the ball around it.
TEST(CheckStatesExactly, geometriesBeyondTheWarningDistance_tellTheirNearestPair) {
  const Leaving discs("<cylinder radius='0.06' length='0.01'/>", -0.3, 200);
  for (std::size_t i = 0; i < discs.checks.size(); ++i) {
    ASSERT_TRUE(discs.checks[i].has_pair) << discs.apart[i];
    ASSERT_LE(discs.checks[i].distance, discs.apart[i] - 0.12 + 1e-9);
  }
}

}  // namespace
}  // namespace collision_monitor::test
