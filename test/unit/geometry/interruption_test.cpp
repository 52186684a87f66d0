// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/interruption.h"

#include <gtest/gtest.h>

#include <thread>

namespace collision_monitor::test {
namespace {

TEST(Interruption, nobodyAsks_goesOn) { EXPECT_NO_THROW(throwIfInterrupted()); }

TEST(Interruption, whatAsksIsAskedUntilItEnds) {
  bool goes_on = true;
  {
    const Interruptible interruptible([&] { return goes_on; });
    EXPECT_NO_THROW(throwIfInterrupted());
    goes_on = false;
    EXPECT_THROW(throwIfInterrupted(), Interrupted);
  }
  EXPECT_NO_THROW(throwIfInterrupted());
}

TEST(Interruption, innerOneIsAskedAlone_outerOneAfterwards) {
  const Interruptible outer([] { return false; });
  {
    const Interruptible inner([] { return true; });
    EXPECT_NO_THROW(throwIfInterrupted());
    const Interruptible innermost(GoesOn{});
    EXPECT_NO_THROW(throwIfInterrupted());
  }
  EXPECT_THROW(throwIfInterrupted(), Interrupted);
}

TEST(Interruption, otherThreadsAreNotConcerned) {
  const Interruptible interruptible([] { return false; });
  bool is_interrupted = false;
  std::thread([&] {
    try {
      throwIfInterrupted();
    } catch (const Interrupted&) {
      is_interrupted = true;
    }
  }).join();
  EXPECT_FALSE(is_interrupted);
}

}  // namespace
}  // namespace collision_monitor::test
