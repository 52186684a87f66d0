// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "pipeline/setup/setup_parts.h"
#include "support/robots/hand_made_setup.h"

namespace collision_monitor::test {
namespace {

TEST(ListPairs, tableIsOrderedByKindOfCore) {
  const CycleSetup setup = handMadeSetup(
      {{0, Box{{1, 1, 1}}}, {1, Sphere{1}}, {2, Capsule{1, 1}}, {3, Sphere{1}}, {4, RoundedBox{}}});
  ASSERT_EQ(setup.ranges.size(),
            5U);  // point-point, point-segment, point-box, segment-box, box-box
  std::size_t next = 0;
  for (const PairRange& range : setup.ranges) {
    EXPECT_EQ(range.first, next);
    for (std::size_t i = range.first; i < range.last; ++i) {
      const BodyPair& pair = setup.table.pairs()[i];
      const CoreKind a = coreKindOf(setup.bodies[index(pair.a)].shape);
      const CoreKind b = coreKindOf(setup.bodies[index(pair.b)].shape);
      EXPECT_EQ(std::min(a, b), range.a);
      EXPECT_EQ(std::max(a, b), range.b);
    }
    next = range.last;
  }
  EXPECT_EQ(next, setup.table.size());
  EXPECT_EQ(next, 10U);
}

/// Links of several bodies and elements, and so many that the table has no dense look-up.
CycleSetup manyBodies() {
  std::vector<ShapeOnLink> shapes;
  for (std::size_t link = 0; link < 120; ++link) {
    for (std::size_t i = 0; i < 1 + link % 17; ++i) {
      const std::size_t kind = (link + i) % 3;
      shapes.push_back({link, kind == 0   ? Shape(Sphere{1})
                              : kind == 1 ? Shape(Box{{1, 1, 1}})
                                          : Shape(Capsule{1, 1})});
    }
  }
  return handMadeSetup(shapes);
}

TEST(ListPairs, eachPairStandsOnceInOrder_andBelongsToItsLinksAndElements) {
  const CycleSetup setup = manyBodies();
  ASSERT_EQ(setup.table.idsOfAll(), nullptr);
  std::size_t count = 0;
  for (const CheckedLinkPair& pair : setup.checked) {
    count += (1 + index(pair.a) % 17) * (1 + index(pair.b) % 17);
  }
  ASSERT_EQ(setup.table.size(), count);
  for (const PairRange& range : setup.ranges) {
    for (std::size_t i = range.first; i < range.last; ++i) {
      const BodyPair& pair = setup.table.pairs()[i];
      const Body& a = setup.bodies[index(pair.a)];
      const Body& b = setup.bodies[index(pair.b)];
      const CheckedLinkPair& links = setup.checked[setup.link_pair_of[i]];
      const ElementPair& elements = setup.element_pairs[setup.element_pair_of[i]];
      ASSERT_EQ(links.a, a.link);
      ASSERT_EQ(links.b, b.link);
      ASSERT_EQ(elements.a, a.element);
      ASSERT_EQ(elements.b, b.element);
      ASSERT_EQ(elements.link_pair, setup.link_pair_of[i]);
      if (i > range.first) {
        const BodyPair& before = setup.table.pairs()[i - 1];
        ASSERT_TRUE(before.a < pair.a || (before.a == pair.a && before.b < pair.b));
      }
      PairId found{};
      ASSERT_TRUE(setup.table.find(pair.b, pair.a, found));
      ASSERT_EQ(index(found), i);
    }
  }
}

TEST(ListPairs, bodiesOfOneLink_areNoPair) {
  const CycleSetup setup = manyBodies();
  PairId found{};
  EXPECT_FALSE(setup.table.find(BodyId{1}, BodyId{2}, found));  // both on the second link
}

}  // namespace
}  // namespace collision_monitor::test
