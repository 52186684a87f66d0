// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/pipeline/pair_blocks.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "pipeline/blocks/contact_of_pairs.h"
#include "pipeline/cycle/place_bodies.h"
#include "support/instruction_sets.h"
#include "support/robots/hand_made_setup.h"

namespace collision_monitor::test {
namespace {

BodyPoses placed(const CycleSetup& setup, const LinkPoses& poses) {
  BodyPoses body_poses = makeBodyPoses(setup);
  placeBodies(setup, poses, body_poses);
  return body_poses;
}

TEST(MakeBlocks, onePairStandsInOneLane_neighboursShareABlock) {
  std::vector<ShapeOnLink> shapes;
  for (std::size_t link = 0; link < 12; ++link) {
    shapes.push_back({link, Sphere{0.1}});
  }
  const CycleSetup setup = handMadeSetup(shapes);
  std::vector<int> times(setup.table.size(), 0);
  for (const PairBlock& block : setup.blocks.blocks) {
    std::size_t id = block.first_pair;
    for (std::uint32_t lane = 0; lane < kBlockLanes; ++lane) {
      if ((block.is_pair >> lane & 1U) != 0) {
        const BodyPair& pair = setup.table.pairs()[id];
        EXPECT_EQ(setup.blocks.slot_of[index(pair.a)], block.one);
        EXPECT_EQ(setup.blocks.slot_of[index(pair.b)], block.first + lane);
        ++times[id];
        ++id;
      }
    }
  }
  EXPECT_EQ(times, std::vector<int>(66, 1));
  // Body 0 has 11 partners, body 1 ten, body 2 nine: two blocks each; the other eight have one.
  EXPECT_EQ(setup.blocks.blocks.size(), 14U);
  EXPECT_EQ(setup.blocks.ranges.size(), 1U);
}

TEST(MakeBlocks, beginAtGroupsOfSlotsUnlessThatTakesMoreOfThem) {
  std::vector<ShapeOnLink> shapes;
  for (std::size_t link = 0; link < 12; ++link) {
    shapes.push_back({link, Sphere{0.1}});
  }
  const PairBlocks blocks = handMadeSetup(shapes).blocks;
  // Body 0 meets bodies 1 to 7 of the first group, then 8 to 11 of the second.
  EXPECT_EQ(blocks.blocks[0].first, 0U);
  EXPECT_EQ(blocks.blocks[0].is_pair, 0b11111110U);
  EXPECT_EQ(blocks.blocks[1].first, 8U);
  EXPECT_EQ(blocks.blocks[1].is_pair, 0b00001111U);
  // Body 3 meets 4 to 11, which one block can hold.
  EXPECT_EQ(blocks.blocks[6].one, 3U);
  EXPECT_EQ(blocks.blocks[6].first, 4U);
  EXPECT_EQ(blocks.blocks[6].is_pair, 0b11111111U);
}

/// A ball at the origin, a capsule along z from (3, 0, -1) to (3, 0, 1), a cube about (0, 5, 0).
class BlocksTest : public testing::TestWithParam<std::int64_t> {
 protected:
  CycleSetup setup_ =
      handMadeSetup({{0, Box{{0.5, 0.5, 0.5}}}, {1, Sphere{0.5}}, {2, Capsule{1.0, 0.25}}});
  LinkPoses poses_ = [this] {
    LinkPoses poses = knownPoses(setup_);
    poses.world_from_link[0].translation = {0, 5, 0};
    poses.world_from_link[2].translation = {3, 0, 0};
    return poses;
  }();
  std::vector<unsigned char> passed_ = std::vector<unsigned char>(3, 0);
  std::vector<std::uint32_t> groups_ = {0, 1, 2};

  std::vector<double> distances() const {
    return allDistances(setup_, placed(setup_, poses_).rows);
  }
  NearestPair nearest(NearestPair best = {}) const {
    searchBlocks(setup_.blocks, placed(setup_, poses_).rows, {groups_, passed_}, best);
    return best;
  }
  FoundContact contact(double contact_distance) {
    ContactDistances limits = contactDistancesOf(setup_);
    limits.of_pair[2] = contact_distance;
    limits.largest = std::max(limits.largest, contact_distance);
    FoundContact found;
    findContact(setup_.blocks, placed(setup_, poses_).rows, limits, found);
    return found;
  }

 private:
  OnlyInstructionSet only_{GetParam()};
};

TEST_P(BlocksTest, everyDistance) {
  // By kind: ball and capsule, ball and cube, capsule and cube.
  const std::vector<double> found = distances();
  ASSERT_EQ(found.size(), 3U);
  EXPECT_NEAR(found[0], 3.0 - 0.5 - 0.25, 1e-12);
  EXPECT_NEAR(found[1], 4.5 - 0.5, 1e-12);
  EXPECT_NEAR(found[2], std::hypot(2.5, 4.5) - 0.25, 1e-12);
}

TEST_P(BlocksTest, pairsFartherThanAsked_areLeftOut) {
  std::vector<NearestPair> near;
  near.reserve(setup_.table.size());
  findNear(setup_.blocks, placed(setup_, poses_).rows, 4.5, near);
  ASSERT_EQ(near.size(), 2U);
  EXPECT_EQ(near[0].pair, PairId{0});
  EXPECT_NEAR(near[0].distance, 2.25, 1e-12);
  EXPECT_EQ(near[1].pair, PairId{1});
  EXPECT_NEAR(near[1].distance, 4.0, 1e-12);
}

TEST_P(BlocksTest, nearestPair) {
  const NearestPair found = nearest();
  EXPECT_EQ(found.pair, PairId{0});
  EXPECT_NEAR(found.distance, 2.25, 1e-12);
}

TEST_P(BlocksTest, pairThatIsPassedOver_isNotFound) {
  passed_[0] = 1;
  EXPECT_EQ(nearest().pair, PairId{1});
}

TEST_P(BlocksTest, nothingNearerThanTheBest_bestStays) {
  const NearestPair found = nearest({PairId{2}, 2.0});
  EXPECT_EQ(found.pair, PairId{2});
  EXPECT_EQ(found.distance, 2.0);
}

TEST_P(BlocksTest, unknownBody_itsDistancesAreNotNumbersAndItIsNeverNearest) {
  poses_.status[1] = LinkStatus::stale;
  const std::vector<double> found = distances();
  EXPECT_TRUE(std::isnan(found[0]));
  EXPECT_TRUE(std::isnan(found[1]));
  EXPECT_EQ(nearest().pair, PairId{2});
}

TEST_P(BlocksTest, contact_byTheLimitOfThePair) {
  // Capsule and cube are 4.9 m apart, ball and capsule, whose limit is 0, only 2.25 m.
  EXPECT_EQ(contact(4.8).contact.distance, std::numeric_limits<double>::infinity());
  const FoundContact found = contact(5.0);
  EXPECT_EQ(found.contact.pair, PairId{2});
  EXPECT_NEAR(found.contact.distance, std::hypot(2.5, 4.5) - 0.25, 1e-12);
  EXPECT_FALSE(found.has_unknown);
}

TEST_P(BlocksTest, contactOfKnownBodies_isFoundBesideAnUnknownOne) {
  poses_.status[1] = LinkStatus::stale;
  EXPECT_TRUE(contact(0.0).has_unknown);
  EXPECT_EQ(contact(0.0).contact.distance, std::numeric_limits<double>::infinity());
  EXPECT_EQ(contact(5.0).contact.pair, PairId{2});
}

TEST_P(BlocksTest, parallelCubes_areLeftToThePlainTwin) {
  setup_ = handMadeSetup({{0, Box{{1, 1, 1}}}, {1, Box{{1, 1, 1}}}, {2, Box{{1, 1, 1}}}});
  poses_ = knownPoses(setup_);
  poses_.world_from_link[1].translation = {3.0, 0, 0};
  poses_.world_from_link[2].translation = {1.5, 0, 9};
  const std::vector<double> found = distances();
  EXPECT_NEAR(found[0], 1.0, 1e-12);
  EXPECT_NEAR(found[1], 7.0, 1e-12);
  EXPECT_NEAR(found[2], 7.0, 1e-12);
  EXPECT_EQ(nearest().pair, PairId{0});
  EXPECT_EQ(contact(7.5).contact.pair, PairId{2}) << "the others have limits of 0";
  EXPECT_FALSE(contact(0.0).has_unknown);
}

TEST_P(BlocksTest, skewCubes_deepByTheFaceThatIsNearest) {
  setup_ = handMadeSetup({{0, Box{{1, 1, 1}}}, {1, Box{{0.1, 0.1, 0.1}}}, {2, Box{{1, 1, 1}}}});
  poses_ = knownPoses(setup_);
  const Eigen::Matrix3d skew =
      Eigen::AngleAxisd(1.0, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  poses_.world_from_link[1] = {skew, {0.95, 0.1, 0.2}};
  poses_.world_from_link[2] = {skew, {9.0, 0, 0}};
  // It has to go out along x by what of it is within x = 1.
  const double depth = 0.05 + 0.1 * skew.row(0).cwiseAbs().sum();
  EXPECT_NEAR(distances()[0], -depth, 1e-12);
  EXPECT_NEAR(nearest().distance, -depth, 1e-12);
  EXPECT_NEAR(contact(0.0).contact.distance, -depth, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(EveryInstructionSet, BlocksTest, testing::ValuesIn(instructionSets()),
                         [](const auto& target) { return hwy::TargetName(target.param); });

}  // namespace
}  // namespace collision_monitor::test
