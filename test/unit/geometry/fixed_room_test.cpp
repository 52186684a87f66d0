// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/fixed_room.h"

#include <gtest/gtest.h>

#include <memory>
#include <utility>

namespace collision_monitor::test {
namespace {

using Shared = std::shared_ptr<int>;

TEST(FixedRoom, things_stayWhereTheyAreAndEndWithTheRoom) {
  const Shared one = std::make_shared<int>(1);
  {
    FixedRoom<Shared> room(3);
    const Shared* first = &room.make(one);
    room.make(one);
    EXPECT_EQ(room.size(), 2U);
    EXPECT_EQ(room.most(), 3U);
    EXPECT_EQ(&room[0], first);
    EXPECT_EQ(one.use_count(), 3);
    FixedRoom<Shared> other(std::move(room));
    EXPECT_EQ(&other[0], first);
    EXPECT_EQ(room.size(), 0U);
    EXPECT_EQ(one.use_count(), 3);
    other = FixedRoom<Shared>(1);
    EXPECT_EQ(one.use_count(), 1);
  }
  EXPECT_EQ(one.use_count(), 1);
}

TEST(FixedRoom, room_holdsNothingAtFirst) {
  FixedRoom<Shared> none;
  EXPECT_EQ(none.size(), 0U);
  EXPECT_EQ(none.begin(), none.end());
}

}  // namespace
}  // namespace collision_monitor::test
