// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "pipeline/pair_search/descend.h"
#include "support/fixed_seed.h"
#include "support/robots/urdf_text.h"
#include "support/sanitizer.h"

// Proofs and bounds about pairs of links, held to states that try to break them. Robots are small
// and random: chains of two arms with all kinds of joints and shapes.
namespace collision_monitor::test::pair_proof_laws {
namespace {

using Random = std::mt19937_64;

double draw(Random& random, double lower, double upper) {
  return lower + (upper - lower) * std::ldexp(static_cast<double>(random() >> 11), -53);
}

std::string vectorText(Random& random, double size) {
  std::string text;
  for (int i = 0; i < 3; ++i) {
    text += std::to_string(draw(random, -size, size)) + " ";
  }
  return text;
}

std::string geometryXml(Random& random) {
  const auto length = [&] { return std::to_string(draw(random, 0.03, 0.15)); };
  switch (random() % 3) {
    case 0:
      return "<sphere radius='" + length() + "'/>";
    case 1:
      return "<box size='" + length() + " " + length() + " " + length() + "'/>";
    default:
      return "<cylinder radius='" + length() + "' length='" + length() + "'/>";
  }
}

std::string poseXml(Random& random, double size) {
  return "<origin xyz='" + vectorText(random, size) + "' rpy='" + vectorText(random, 3.0) + "'/>";
}

/// Every third joint may slide, every fourth follows the one before it.
std::string movingXml(Random& random, const std::string& parent, const std::string& child,
                      const std::string& followed) {
  const bool slides = random() % 3 == 0;
  const double reach = slides ? 0.2 : draw(random, 0.1, 3.2);
  const double lower = draw(random, -reach, 0.0);
  std::string rest = poseXml(random, 0.25) + "<axis xyz='" + vectorText(random, 1.0) +
                     "'/><limit lower='" + std::to_string(lower) + "' upper='" +
                     std::to_string(lower + reach) + "' velocity='1' effort='1'/>";
  if (!followed.empty() && random() % 4 == 0) {
    rest += "<mimic joint='" + followed + "' multiplier='" +
            std::to_string(draw(random, -1.5, 1.5)) + "' offset='0.1'/>";
  }
  return jointXml(child + "_joint", slides ? "prismatic" : "revolute", parent, child, rest);
}

/// A base with two arms of one to three joints.
CycleSetup randomRobot(Random& random) {
  std::string xml = linkXml("base", geometryXml(random), poseXml(random, 0.05));
  for (const char* side : {"l", "r"}) {
    std::string parent = "base";
    std::string followed;
    const std::size_t count = 1 + random() % 3;
    for (std::size_t i = 0; i < count; ++i) {
      const std::string link = side + std::to_string(i);
      xml += linkXml(link, geometryXml(random), poseXml(random, 0.1));
      xml += movingXml(random, parent, link, followed);
      followed = followed.empty() ? link + "_joint" : followed;
      parent = link;
    }
  }
  SetupOptions options;
  options.ignore_default_overlap = false;
  return buildSetup({describeText(robotXml(xml))}, textLoader({}), options);
}

/// A random cell of a motion, and states within it.
struct RandomCell {
  JointCell cell;

  RandomCell(const PairMotion& motion, Random& random) : cell(wholeCell(motion)) {
    for (std::size_t i = 0; i < cell.half.size(); ++i) {
      const double share = std::pow(0.5, draw(random, 0.0, 6.0));
      cell.middle[i] += (1.0 - share) * cell.half[i] * draw(random, -1.0, 1.0);
      cell.half[i] *= share;
    }
  }
  /// Corners as often as states within: bounds are mostly broken at corners.
  JointCell stateIn(Random& random) const {
    JointCell state = cell;
    const bool is_corner = random() % 2 == 0;
    for (std::size_t i = 0; i < cell.half.size(); ++i) {
      const double share = draw(random, -1.0, 1.0);
      state.middle[i] += cell.half[i] * (is_corner ? (share < 0.0 ? -1.0 : 1.0) : share);
      state.half[i] = 0.0;
    }
    return state;
  }
};

/// What the three bounds say of one pair of elements in a cell.
struct Bounds {
  bool are_balls_apart{false};
  double by_levers{0.0};
  double by_normal{-kInfinity};
};

PairDistance distanceIn(ProofTools& tools, LinkPairIndex pair, const JointCell& cell,
                        PlacedCell& placed) {
  place(tools.measures.setup.model, cell, placed);
  return elementDistance(tools.measures, pair, placed.world_from_link);
}

Bounds boundsOf(ProofTools& tools, LinkPairIndex pair, const JointCell& cell, PlacedCell& placed) {
  const PairDistance middle = distanceIn(tools, pair, cell, placed);
  const ElementPair& elements =
      tools.measures.setup.element_pairs[tools.measures.first_element_pair[pair]];
  const ElementCover& a = tools.covers[index(elements.a)];
  const ElementCover& b = tools.covers[index(elements.b)];
  const auto in_world = [&](const Ball& ball, LinkId link) {
    return Ball{placed.world_from_link[index(link)] * ball.center, ball.radius};
  };
  findLevers(placed, in_world(a.ball, placed.motion.a), in_world(b.ball, placed.motion.b),
             tools.levers);
  Bounds bounds;
  bounds.are_balls_apart = areBallsApart(placed, a.balls, b.balls, 0.0, tools.sweep);
  bounds.by_levers = middle.measured.distance - tools.levers.travel;
  bounds.by_normal = gapAlong(placed, middle.measured.normal_a_to_b,
                              curvatureOf(placed, tools.levers), a.hull, b.hull, tools.first_order);
  return bounds;
}

TEST(PairProofLaws, boundsOfACell_areBelowDistancesInIt) {
  Random random(kSeed);
  std::size_t with_balls = 0;
  std::size_t with_normal = 0;
  std::size_t only_normal = 0;
  for (int robot = 0; robot < test::caseCount(60); ++robot) {
    const CycleSetup setup = randomRobot(random);
    const std::vector<JointRange> ranges = jointRanges(setup.model);
    const std::vector<ElementCover> covers = coverElements(setup);
    ProofTools tools(setup, covers);
    for (LinkPairIndex pair = 0; pair < setup.checked.size(); ++pair) {
      const CheckedLinkPair& links = setup.checked[pair];
      const PairMotion motion = makePairMotion(setup.model, ranges, links.a, links.b);
      PlacedCell placed = makePlacedCell(setup.model, motion, std::vector<Pose>(1));
      for (int i = 0; i < 20; ++i) {
        const RandomCell cell(motion, random);
        const Bounds bounds = boundsOf(tools, pair, cell.cell, placed);
        with_balls += bounds.are_balls_apart ? 1U : 0U;
        with_normal += bounds.by_normal > 0.0 ? 1U : 0U;
        only_normal += bounds.by_normal > 0.0 && bounds.by_levers < 0.0 ? 1U : 0U;
        for (int state = 0; state < 10; ++state) {
          const double distance =
              distanceIn(tools, pair, cell.stateIn(random), placed).measured.distance;
          ASSERT_GE(distance, bounds.by_levers - 1e-7);
          ASSERT_GE(distance, bounds.by_normal - 1e-7);
          ASSERT_TRUE(distance > 0.0 || !bounds.are_balls_apart);
        }
      }
    }
  }
  EXPECT_GT(with_balls, test::caseCount(std::size_t{500}));
  EXPECT_GT(with_normal, test::caseCount(std::size_t{500}));
  EXPECT_GT(only_normal, test::caseCount(std::size_t{100}))
      << "the normal proves what levers do not";
}

/// Random states, and the way down from the nearest of them.
void tryToTouch(ProofTools& tools, const PairProof& proof, const CycleSetup& setup,
                Random& random) {
  const std::vector<JointRange> ranges = jointRanges(setup.model);
  std::vector<Pose> links;
  JointPositions nearest_state;
  double nearest = kInfinity;
  for (int i = 0; i < 300; ++i) {
    const JointPositions state = drawState(setup.model, ranges, random);
    placeLinks(setup.model, state, std::vector<Pose>(1), links);
    const PairDistance found = elementDistance(tools.measures, proof.pair, links);
    ASSERT_EQ(touchOf(found), Touch::apart);
    if (found.measured.distance < nearest) {
      nearest = found.measured.distance;
      nearest_state = state;
    }
  }
  ASSERT_EQ(descend(tools, proof.pair, proof.motion, std::vector<Pose>(1), nearest_state),
            Touch::apart);
}

void tryToPart(ProofTools& tools, const PairProof& proof, const CycleSetup& setup, Random& random) {
  const std::vector<JointRange> ranges = jointRanges(setup.model);
  std::vector<Pose> links;
  for (int i = 0; i < 1000; ++i) {
    placeLinks(setup.model, drawState(setup.model, ranges, random), std::vector<Pose>(1), links);
    ASSERT_EQ(touchOf(elementDistance(tools.measures, proof.pair, links)), Touch::touching);
  }
}

TEST(PairProofLaws, noStateSpeaksAgainstAProof) {
  Random random(kSeed);
  std::size_t apart = 0;
  std::size_t touching = 0;
  std::size_t refuted = 0;
  for (int robot = 0; robot < test::caseCount(100); ++robot) {
    const CycleSetup setup = randomRobot(random);
    const std::vector<JointRange> ranges = jointRanges(setup.model);
    const std::vector<ElementCover> covers = coverElements(setup);
    ProofTools tools(setup, covers);
    for (LinkPairIndex pair = 0; pair < setup.checked.size(); ++pair) {
      const CheckedLinkPair& links = setup.checked[pair];
      for (const bool of_touching : {false, true}) {
        PairProof proof =
            beginProof(setup, pair, makePairMotion(setup.model, ranges, links.a, links.b),
                       std::vector<Pose>(1));
        proof.of_touching = of_touching;
        advance(tools, 300, Deadline::max(), proof);
        refuted += proof.state == ProofState::refuted ? 1U : 0U;
        if (proof.state == ProofState::proven) {
          ++(of_touching ? touching : apart);
          (of_touching ? tryToPart : tryToTouch)(tools, proof, setup, random);
          ASSERT_FALSE(HasFatalFailure());
        }
      }
    }
  }
  EXPECT_GT(apart, test::caseCount(std::size_t{100}));
  EXPECT_GE(touching, test::caseCount(std::size_t{3}));
  EXPECT_GT(refuted, test::caseCount(std::size_t{100}));
}

}  // namespace
}  // namespace collision_monitor::test::pair_proof_laws
