// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/pair_search/touch.h"

#include <gtest/gtest.h>

namespace collision_monitor::test {
namespace {

TEST(TouchOf, sharesWhatIsCertain) {
  PairDistance distance;
  const auto touch = [&](Quality quality, double value) {
    distance.quality = quality;
    distance.measured.distance = value;
    return touchOf(distance);
  };
  EXPECT_EQ(touch(Quality::exact, 1e-6), Touch::apart);
  EXPECT_EQ(touch(Quality::lower_bound, 1e-6), Touch::apart);
  EXPECT_EQ(touch(Quality::exact, 0.0), Touch::touching);
  EXPECT_EQ(touch(Quality::estimate, 0.0), Touch::touching);
  EXPECT_EQ(touch(Quality::lower_bound, -0.1), Touch::unclear);
  EXPECT_EQ(touch(Quality::unknown, 1.0), Touch::unclear);
}

}  // namespace
}  // namespace collision_monitor::test
