// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/pipeline/search_pairs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "pipeline/pair_search/pair_proof.h"
#include "support/robots/urdf_text.h"

namespace collision_monitor::test {
namespace {

const char* const kBall = "<sphere radius='0.1'/>";
const char* const kOneOut = "<origin xyz='1 0 0'/>";

std::string fixedTo(const std::string& parent, const std::string& link, const std::string& place) {
  return linkXml(link, kBall) +
         jointXml(link + "_joint", "fixed", parent, link, "<origin xyz='" + place + "'/>");
}

std::string turning(const std::string& parent, const std::string& link, const std::string& more) {
  return jointXml(link + "_joint", "revolute", parent, link, "<axis xyz='0 0 1'/>" + more);
}

std::string limits(const std::string& lower, const std::string& upper) {
  return "<limit lower='" + lower + "' upper='" + upper + "' velocity='1' effort='1'/>";
}

/// Balls of 0.1 m. The arm, 1 m out, turns about the base by up to 1 rad to both sides; what else
/// there is stands fixed on the base, but for a finger that turns with the arm, twice as far and
/// the other way, and a hand behind four joints.
CycleSetup robot(const std::string& more = "") {
  const std::string little = limits("-0.01", "0.01");
  const std::string xml =
      linkXml("base", kBall) + linkXml("arm", kBall, kOneOut) +
      turning("base", "arm", limits("-1", "1")) + fixedTo("base", "plate", "0 0 0.15") +
      fixedTo("base", "post", "1 1 0") +
      fixedTo("base", "wall",
              std::to_string(std::cos(0.9)) + " " + std::to_string(std::sin(0.9)) + " 0") +
      more;
  SetupOptions options;
  options.ignore_default_overlap = false;
  return buildSetup({describeText(robotXml(xml))}, textLoader({}), options);
}

PairFound of(const CycleSetup& setup, const std::vector<PairFound>& pairs, const std::string& a,
             const std::string& b) {
  for (const PairFound& pair : pairs) {
    if (setup.model.link(pair.a).name == a && setup.model.link(pair.b).name == b) {
      return pair;
    }
  }
  throw std::out_of_range(a + " and " + b);
}

double armOf(const CycleSetup& setup, const JointPositions& state) {
  return state.at(setup.model.joint(*setup.model.findJoint("arm_joint")).first_variable);
}

PairSearchOptions few(std::size_t states) {
  PairSearchOptions options;
  options.states = states;
  return options;
}

TEST(SearchPairs, everyKindOfPair) {
  const CycleSetup setup = robot();
  const std::vector<PairFound> pairs = searchPairs(setup, few(500));
  ASSERT_EQ(pairs.size(), 10U) << "of five links";
  EXPECT_EQ(of(setup, pairs, "base", "arm").finding, PairFinding::adjacent);
  const PairFound plate = of(setup, pairs, "base", "plate");
  EXPECT_EQ(plate.finding, PairFinding::always);
  EXPECT_TRUE(plate.is_proven) << "nothing moves them";
  EXPECT_TRUE(plate.joints.empty());
  const PairFound fixed = of(setup, pairs, "base", "post");
  EXPECT_EQ(fixed.finding, PairFinding::never);
  EXPECT_TRUE(fixed.is_proven);
  EXPECT_NEAR(fixed.nearest, std::sqrt(2.0) - 0.2, 1e-12);
  const PairFound post = of(setup, pairs, "arm", "post");
  EXPECT_EQ(post.finding, PairFinding::never);
  EXPECT_TRUE(post.is_proven) << "0.21 m apart where they are nearest, by one joint";
  EXPECT_EQ(post.joints, std::vector<JointId>{*setup.model.findJoint("arm_joint")});
  EXPECT_GE(post.nearest, std::sqrt(2.0) - 1.2 - 1e-12);
  const PairFound wall = of(setup, pairs, "arm", "wall");
  EXPECT_EQ(wall.finding, PairFinding::sometimes);
  EXPECT_FALSE(wall.is_proven);
  EXPECT_LE(std::abs(armOf(setup, wall.touching) - 0.9), 2.0 * std::asin(0.1) + 1e-5);
}

TEST(SearchPairs, whatStatesDoNotShow_aProofFinds) {
  const CycleSetup setup = robot();
  // The default state alone.
  const PairFound wall = of(setup, searchPairs(setup, few(1)), "arm", "wall");
  EXPECT_EQ(wall.finding, PairFinding::sometimes);
  EXPECT_LE(std::abs(armOf(setup, wall.touching) - 0.9), 2.0 * std::asin(0.1) + 1e-5);
}

TEST(SearchPairs, tooFewCells_orNoTime_noProof) {
  // 0.1 m from the arm at its limit: one cell does not suffice.
  const CycleSetup setup = robot(fixedTo(
      "base", "gate", std::to_string(std::cos(1.3)) + " " + std::to_string(std::sin(1.3)) + " 0"));
  PairSearchOptions options = few(100);
  EXPECT_TRUE(of(setup, searchPairs(setup, options), "arm", "gate").is_proven);
  options.most_cells = 1;
  const PairFound gate = of(setup, searchPairs(setup, options), "arm", "gate");
  EXPECT_EQ(gate.finding, PairFinding::never);
  EXPECT_FALSE(gate.is_proven);
  options = few(100);
  options.time_limit = 0.0;
  EXPECT_FALSE(of(setup, searchPairs(setup, options), "arm", "gate").is_proven);
}

TEST(SearchPairs, jointThatFollows_goesAsFarAsItsFactor) {
  // The arm does not reach 1.8 rad, a finger that turns twice as far does.
  const std::string gate = fixedTo(
      "base", "gate", std::to_string(std::cos(1.8)) + " " + std::to_string(std::sin(1.8)) + " 0.5");
  const auto finger = [&](const std::string& factor) {
    return gate + linkXml("finger", kBall, "<origin xyz='1 0 0.5'/>") +
           turning("base", "finger",
                   limits("-4", "4") + "<mimic joint='arm_joint' multiplier='" + factor + "'/>");
  };
  const CycleSetup setup = robot(finger("-2"));
  const PairFound found = of(setup, searchPairs(setup, few(1)), "gate", "finger");
  EXPECT_EQ(found.finding, PairFinding::sometimes);
  EXPECT_LE(std::abs(-2.0 * armOf(setup, found.touching) - 1.8), 2.0 * std::asin(0.1) + 1e-5);
  const CycleSetup slower = robot(finger("1.5"));
  EXPECT_TRUE(of(slower, searchPairs(slower, few(1)), "gate", "finger").is_proven);
}

TEST(SearchPairs, manyJoints_areProven_whereBoundsFollowTheChain) {
  // Six joints in the middle of the hand, each with a full turn: none moves it.
  std::string hand = "<link name='w0'/>" + turning("arm", "w0", limits("-3", "3"));
  for (int i = 1; i < 6; ++i) {
    const std::string name = "w" + std::to_string(i);
    hand += i < 5 ? "<link name='" + name + "'/>" : linkXml(name, kBall);
    hand += jointXml(
        name + "_joint", "revolute", "w" + std::to_string(i - 1), name,
        "<axis xyz='" + std::string(i % 2 == 0 ? "0 0 1" : "1 0 0") + "'/>" + limits("-3", "3"));
  }
  const CycleSetup setup = robot(hand);
  PairSearchOptions options = few(200);
  options.most_cells = 100;
  const PairFound found = of(setup, searchPairs(setup, options), "w5", "post");
  EXPECT_EQ(found.joints.size(), 7U);
  EXPECT_EQ(found.finding, PairFinding::never);
  EXPECT_TRUE(found.is_proven);
}

TEST(SearchPairs, whatTouchesInEveryState_isProven_whereDepthsExceedMotion) {
  // Balls about one point, and one that comes out of the base only beyond 0.2 m.
  const std::string slide = "<axis xyz='1 0 0'/>";
  const std::string parts =
      "<link name='hip'/>" + turning("base", "hip", limits("-3", "3")) + linkXml("ball", kBall) +
      turning("hip", "ball", limits("-3", "3")) + "<link name='rail'/>" +
      jointXml("rail_joint", "prismatic", "base", "rail", slide + limits("-0.01", "0.01"));
  const auto cart = [&](const std::string& far) {
    return parts + linkXml("cart", kBall) +
           jointXml("cart_joint", "prismatic", "rail", "cart", slide + limits("0", far));
  };
  const CycleSetup setup = robot(cart("0.18"));
  const std::vector<PairFound> pairs = searchPairs(setup, few(1));
  const PairFound cart_found = of(setup, pairs, "plate", "cart");
  EXPECT_EQ(of(setup, pairs, "plate", "ball").finding, PairFinding::always);
  EXPECT_TRUE(of(setup, pairs, "plate", "ball").is_proven);
  EXPECT_FALSE(of(setup, pairs, "plate", "ball").joints.empty());
  EXPECT_EQ(cart_found.finding, PairFinding::sometimes)
      << "0.15 m above, it is apart from 0.13 m on: no state drawn, but a cell shows that";
}

TEST(SearchPairs, aJointOfSeveralTurns_isProvenByOne) {
  const CycleSetup setup = robot(linkXml("wheel", kBall, "<origin xyz='3 0 0'/>") +
                                 turning("base", "wheel", limits("-1000", "1000")));
  PairSearchOptions options = few(20);
  options.most_cells = 3000;
  EXPECT_TRUE(of(setup, searchPairs(setup, options), "post", "wheel").is_proven);
}

TEST(SearchPairs, twoRobots_standWhereTheyArePlaced) {
  const std::string arm = robotXml(linkXml("base", kBall) + linkXml("arm", kBall, kOneOut) +
                                   turning("base", "arm", limits("-1", "1")));
  RobotDescription left = describeText(arm);
  RobotDescription right = left;
  left.tf_prefix = "left";
  right.tf_prefix = "right";
  SetupOptions setup_options;
  setup_options.ignore_default_overlap = false;
  const CycleSetup setup = buildSetup({left, right}, textLoader({}), setup_options);
  PairSearchOptions options = few(200);
  EXPECT_EQ(of(setup, searchPairs(setup, options), "left/base", "right/base").finding,
            PairFinding::always);
  options.world_from_root.resize(2);
  options.world_from_root[1].translation.x() = 2.0;
  std::vector<PairFound> pairs = searchPairs(setup, options);
  EXPECT_TRUE(of(setup, pairs, "left/base", "right/base").is_proven);
  EXPECT_TRUE(of(setup, pairs, "left/arm", "right/arm").is_proven) << "both reach in +x";
  EXPECT_TRUE(of(setup, pairs, "left/arm", "right/base").is_proven);
  options.world_from_root[1].translation.x() = 1.1;
  pairs = searchPairs(setup, options);
  EXPECT_EQ(of(setup, pairs, "left/arm", "right/base").finding, PairFinding::sometimes);
}

TEST(PairProof, comesToTheSameEnd_inOneGoAndInParts) {
  const CycleSetup setup =
      robot(linkXml("hand", kBall, kOneOut) +
            jointXml("hand_joint", "revolute", "arm", "hand",
                     "<origin xyz='1 0 0.3'/><axis xyz='0 1 0'/>" + limits("-1", "1")));
  const std::vector<JointRange> ranges = jointRanges(setup.model);
  const std::vector<ElementCover> covers = coverElements(setup);
  for (LinkPairIndex pair = 0; pair < setup.checked.size(); ++pair) {
    const CheckedLinkPair& links = setup.checked[pair];
    const auto begin = [&] {
      return beginProof(setup, pair, makePairMotion(setup.model, ranges, links.a, links.b),
                        std::vector<Pose>(1));
    };
    ProofTools tools(setup, covers);
    PairProof at_once = begin();
    advance(tools, 5000, Deadline::max(), at_once);
    PairProof in_parts = begin();
    for (std::size_t cells = 7; cells <= 5000 && isUnderWay(in_parts); cells += 7) {
      ProofTools others(setup, covers);
      advance(others, cells, Deadline::max(), in_parts);
    }
    EXPECT_EQ(in_parts.state, at_once.state);
    EXPECT_EQ(in_parts.cells, at_once.cells);
    EXPECT_EQ(in_parts.at, at_once.at);
  }
}

TEST(SearchPairs, continuousJoint_isProvenForAllTurns_notWhereAnotherFollowsItAtHalfTheRate) {
  const std::string wheel =
      linkXml("wheel", kBall, "<origin xyz='3 0 0'/>") +
      jointXml("wheel_joint", "continuous", "base", "wheel", "<axis xyz='0 0 1'/>") +
      linkXml("slow", kBall, "<origin xyz='4 0 0'/>") +
      turning("base", "slow", limits("-9", "9") + "<mimic joint='wheel_joint' multiplier='0.5'/>");
  const CycleSetup setup = robot(wheel);
  const std::vector<PairFound> pairs = searchPairs(setup, few(50));
  EXPECT_TRUE(of(setup, pairs, "plate", "wheel").is_proven);
  EXPECT_FALSE(of(setup, pairs, "plate", "slow").is_proven);
}

TEST(SearchPairs, slideThatFollowsAContinuousJoint_hasNoEnd_andNoProof) {
  // After one turn and a half the nut is at the end.
  const CycleSetup setup =
      robot(linkXml("screw", kBall, "<origin xyz='0 0 3'/>") +
            jointXml("screw_joint", "continuous", "base", "screw", "<axis xyz='0 0 1'/>") +
            linkXml("nut", kBall) +
            jointXml("nut_joint", "prismatic", "base", "nut",
                     "<origin xyz='0 0 6'/><axis xyz='0 0 1'/>" + limits("-99", "99") +
                         "<mimic joint='screw_joint'/>") +
            fixedTo("base", "end", "0 0 15.4"));
  const PairFound nut = of(setup, searchPairs(setup, few(50)), "nut", "end");
  EXPECT_EQ(nut.finding, PairFinding::never);
  EXPECT_FALSE(nut.is_proven);
}

TEST(SearchPairs, floatingJoint_provesNothing) {
  const CycleSetup setup =
      robot(linkXml("drone", kBall) +
            jointXml("air", "floating", "base", "drone", "<origin xyz='9 0 0'/>"));
  const PairFound drone = of(setup, searchPairs(setup, few(50)), "arm", "drone");
  EXPECT_EQ(drone.finding, PairFinding::never);
  EXPECT_FALSE(drone.is_proven);
}

TEST(SearchPairs, sameSeed_sameStates) {
  const CycleSetup setup = robot();
  PairSearchOptions options = few(100);
  const PairFound one = of(setup, searchPairs(setup, options), "arm", "wall");
  EXPECT_EQ(of(setup, searchPairs(setup, options), "arm", "wall").touching, one.touching);
  options.seed = 2;
  EXPECT_NE(of(setup, searchPairs(setup, options), "arm", "wall").touching, one.touching);
}

TEST(SearchPairs, progress_goesToTheEnd) {
  PairSearchOptions options = few(21);
  std::vector<std::size_t> states;
  std::vector<std::size_t> pairs;
  options.state_progress = [&](std::size_t done, std::size_t total) {
    EXPECT_EQ(total, 21U);
    states.push_back(done);
  };
  options.proof_progress = [&](std::size_t done, std::size_t total) {
    EXPECT_TRUE(pairs.empty() || done >= pairs.back());
    EXPECT_EQ(total, 10U);
    pairs.push_back(done);
  };
  EXPECT_EQ(searchPairs(robot(), options).size(), 10U);
  EXPECT_EQ(states, (std::vector<std::size_t>{8, 16, 21}));
  EXPECT_GT(pairs.size(), 2U) << "some pairs need a proof";
  EXPECT_EQ(pairs.back(), 10U);
}

}  // namespace
}  // namespace collision_monitor::test
