// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "broad_phase/broad_phase.h"
#include "geometry/constants.h"
#include "support/allocation_guard.h"
#include "support/fixed_seed.h"
#include "support/random_poses.h"

namespace collision_monitor {
namespace {

using test::Random;
using Pairs = std::vector<std::pair<BodyId, BodyId>>;

constexpr BroadPhaseKind kKinds[] = {
    BroadPhaseKind::automatic,   BroadPhaseKind::brute_force, BroadPhaseKind::sweep_and_prune,
    BroadPhaseKind::hashed_bins, BroadPhaseKind::aabb_tree,   BroadPhaseKind::neighbour_list,
    BroadPhaseKind::combination};

enum class Scene { even, crowd, lattice, huge_and_tiny, points, line };

struct Motion {
  double step;          ///< [m] a coordinate in one frame
  double jump_chance;   ///< of a body to be anywhere else
  double doubt_chance;  ///< of a body to be unknown in a frame
};

Aabb boxAround(const Eigen::Vector3d& center, const Eigen::Vector3d& half_size) {
  return {center - half_size, center + half_size};
}

Aabb randomBox(Scene scene, Random& random) {
  const Eigen::Vector3d unit = test::randomPoint(random, 1.0);
  const Eigen::Vector3d size = test::randomPoint(random, 1.0).cwiseAbs();
  switch (scene) {
    case Scene::even:
      return boxAround(4.0 * unit, size);
    case Scene::crowd:  // most in a small place, some far away
      return boxAround((random() % 8 == 0 ? 1e4 : 0.1) * unit, 0.1 * size);
    case Scene::lattice:  // boxes often touch or share ends
      return boxAround((6.0 * unit).array().round(), (2.0 * size).array().round());
    case Scene::huge_and_tiny:
      return boxAround(10.0 * unit, (random() % 10 == 0 ? 1e5 : 1e-3) * size);
    case Scene::points:
      return boxAround((3.0 * unit).array().round(), Eigen::Vector3d::Zero());
    case Scene::line:
      return boxAround({0.0, 0.0, 30.0 * unit.z()}, size);
  }
  return {};
}

/// What is no proper box, now and then.
void damage(Random& random, BodyBounds& bounds) {
  const double values[] = {std::numeric_limits<double>::quiet_NaN(), kInfinity, -kInfinity, 1e300,
                           -1e300};
  for (Aabb& box : bounds.boxes) {
    if (random() % 100 == 0) {
      Eigen::Vector3d& corner = random() % 2 == 0 ? box.min : box.max;
      corner[static_cast<Eigen::Index>(random() % 3)] = values[random() % std::size(values)];
    }
  }
}

void advance(Scene scene, const Motion& motion, Random& random, BodyBounds& bounds) {
  for (std::size_t i = 0; i < bounds.boxes.size(); ++i) {
    const Eigen::Vector3d step = test::randomPoint(random, motion.step);
    bounds.boxes[i].min += step;
    bounds.boxes[i].max += step;
    if (test::uniform(random, 0.0, 1.0) < motion.jump_chance) {
      bounds.boxes[i] = randomBox(scene, random);
    }
    bounds.known[i] = test::uniform(random, 0.0, 1.0) < motion.doubt_chance ? 0 : 1;
  }
}

/// Every pair tested, one by one, in the order in which they are to come.
Pairs pairsThatMeet(const BodyBounds& bounds) {
  std::vector<SmallBox> boxes(bounds.boxes.size());
  fillSmallBoxes(bounds, boxes);
  const auto meet = [&](std::size_t a, std::size_t b) {
    bool all = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      all = all && boxes[a].min[axis] <= boxes[b].max[axis] &&
            boxes[b].min[axis] <= boxes[a].max[axis];
    }
    return all;
  };
  Pairs pairs;
  for (std::size_t a = 0; a < boxes.size(); ++a) {
    for (std::size_t b = a + 1; b < boxes.size(); ++b) {
      if (meet(a, b)) {
        pairs.emplace_back(idAt<BodyId>(a), idAt<BodyId>(b));
      }
    }
  }
  return pairs;
}

Pairs pairsOf(const std::vector<BodyPair>& meetings) {
  Pairs pairs;
  for (const BodyPair& pair : meetings) {
    pairs.emplace_back(pair.a, pair.b);
  }
  return pairs;
}

std::vector<BroadPhase> allBroadPhases(std::size_t bodies) {
  std::vector<BroadPhase> all;
  for (const BroadPhaseKind kind : kKinds) {
    all.push_back(makeBroadPhase(kind, bodies));
  }
  return all;
}

RC_GTEST_PROP(BroadPhaseLaws, everyKindFindsWhatTestingEveryPairFinds, ()) {
  const Scene scene = *rc::gen::element(Scene::even, Scene::crowd, Scene::lattice,
                                        Scene::huge_and_tiny, Scene::points, Scene::line);
  const Motion motion{*rc::gen::element(0.0, 1e-4, 0.01, 1.0), *rc::gen::element(0.0, 0.02, 1.0),
                      *rc::gen::element(0.0, 0.05, 0.5)};
  const bool is_damaged = *rc::gen::arbitrary<bool>();
  Random random(*rc::gen::arbitrary<std::uint32_t>());
  const auto bodies = *rc::gen::element<std::size_t>(1, 2, 7, 40, 400);
  std::vector<BroadPhase> all = allBroadPhases(bodies);
  BodyBounds bounds{std::vector<Aabb>(bodies), std::vector<unsigned char>(bodies)};
  advance(scene, {0.0, 1.0, 0.0}, random, bounds);
  std::vector<BodyPair> meetings;
  for (int frame = 0; frame < 12; ++frame) {  // what is kept from call to call is put to use
    advance(scene, motion, random, bounds);
    BodyBounds shown = bounds;
    if (is_damaged) {
      damage(random, shown);
    }
    const Pairs expected = pairsThatMeet(shown);
    for (std::size_t kind = 0; kind < all.size(); ++kind) {
      findMeetings(all[kind], shown, meetings);
      RC_LOG() << "kind " << kind << ", frame " << frame;
      RC_ASSERT(pairsOf(meetings) == expected);
    }
  }
}

RC_GTEST_PROP(BroadPhaseLaws, boxesThatMeetAreNeverMissed, ()) {
  Random random(*rc::gen::arbitrary<std::uint32_t>());
  const Aabb a = randomBox(Scene::even, random);
  Aabb b = randomBox(Scene::even, random);
  const auto axis = static_cast<Eigen::Index>(random() % 3);
  b.min = b.min.cwiseMin(a.max);
  b.max = b.max.cwiseMax(a.min);
  b.min[axis] = a.max[axis];  // touch to the last bit, where rounding could part them
  b.max[axis] = std::max(b.max[axis], b.min[axis]);
  BroadPhase brute_force = makeBroadPhase(BroadPhaseKind::brute_force, 2);
  std::vector<BodyPair> meetings;
  findMeetings(brute_force, {{a, b}, {1, 1}}, meetings);
  RC_ASSERT(meets(a, b));
  RC_ASSERT(meetings.size() == 1U);
}

/// As many bodies as a cell of robots has, all in one place now and then.
TEST(BroadPhaseLaws, aThousandBodiesNeverAllocate) {
  constexpr std::size_t kBodies = 1000;
  Random random(20260101);
  BodyBounds bounds{std::vector<Aabb>(kBodies), std::vector<unsigned char>(kBodies, 1)};
  std::vector<BroadPhase> all = allBroadPhases(kBodies);
  std::vector<BodyPair> meetings;
  meetings.reserve(kBodies * (kBodies - 1) / 2);
  std::size_t allocations = 0;
  for (int frame = 0; frame < 12; ++frame) {
    const Scene scene = frame % 3 == 0 ? Scene::huge_and_tiny : Scene::crowd;
    advance(scene, {0.01, frame % 4 == 0 ? 1.0 : 0.01, 0.02}, random, bounds);
    if (frame == 7) {
      std::fill(bounds.boxes.begin(), bounds.boxes.end(), Aabb{});
    }
    for (BroadPhase& broad_phase : all) {
      const test::AllocationGuard guard;
      findMeetings(broad_phase, bounds, meetings);
      allocations += guard.count();
    }
  }
  EXPECT_EQ(allocations, 0U);
}

PairTable randomTable(Random& random, std::uint32_t bodies) {
  std::vector<BodyPair> pairs;
  for (std::uint32_t a = 0; a < bodies; ++a) {
    for (std::uint32_t b = a + 1; b < bodies; ++b) {
      if (random() % 4 != 0) {
        pairs.push_back({BodyId{a}, BodyId{b}});
      }
    }
  }
  std::shuffle(pairs.begin(), pairs.end(), random);
  return PairTable(pairs, bodies);
}

RC_GTEST_PROP(BroadPhaseLaws, candidatesAreTheMeetingsOfTheTableInItsOrder, ()) {
  Random random(*rc::gen::arbitrary<std::uint32_t>());
  const auto bodies = static_cast<std::uint32_t>(*rc::gen::inRange(0, 60));
  const PairTable table = randomTable(random, bodies);
  BodyBounds bounds{std::vector<Aabb>(bodies), std::vector<unsigned char>(bodies)};
  advance(Scene::even, {0.0, 1.0, 0.1}, random, bounds);
  const Pairs meetings = pairsThatMeet(bounds);
  std::vector<PairId> expected;
  for (std::size_t i = 0; i < table.size(); ++i) {
    const BodyPair& pair = table.pairs()[i];
    if (std::binary_search(meetings.begin(), meetings.end(), std::make_pair(pair.a, pair.b))) {
      expected.push_back(idAt<PairId>(i));
    }
  }
  for (const BroadPhaseKind kind : kKinds) {
    BroadPhase broad_phase = makeBroadPhase(kind, bodies, table.size());
    std::vector<PairId> candidates;
    findCandidates(broad_phase, bounds, table, candidates);
    RC_ASSERT(candidates == expected);
  }
}

}  // namespace
}  // namespace collision_monitor
