// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdlib>
#include <string>

namespace collision_monitor::test {

/// The seed of random cases in tests without a seed of their own.
constexpr unsigned kSeed = 20260101;

/// Makes rapidcheck draw the same cases in every run; initialized before its first check reads the
/// variable. A failure prints the seed. RC_PARAMS from outside takes precedence.
const bool kSeedIsFixed = setenv("RC_PARAMS", "seed=20260101", 0) == 0;

/// Asks for more than rapidcheck's hundred cases, for all laws of a program, in any order of
/// initialization.
inline bool askForCases(int count) {
  return std::string(std::getenv("RC_PARAMS")) != "seed=20260101" ||
         setenv("RC_PARAMS", ("seed=20260101 max_success=" + std::to_string(count)).c_str(), 1) ==
             0;
}

}  // namespace collision_monitor::test
