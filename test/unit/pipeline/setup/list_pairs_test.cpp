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

}  // namespace
}  // namespace collision_monitor::test
