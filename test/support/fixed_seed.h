// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdlib>
#include <string>

namespace collision_monitor::test {

/// What random cases are drawn from, where a test has no seed of its own.
constexpr unsigned kSeed = 20260101;

/// Including this makes rapidcheck draw the same cases in every run, before its first check reads
/// the variable. A failure prints the seed; RC_PARAMS set outside goes before this.
const bool kSeedIsFixed = setenv("RC_PARAMS", "seed=20260101", 0) == 0;

/// More of them than rapidcheck's hundred, for the laws of a whole program, whichever of its files
/// is initialized first.
inline bool askForCases(int count) {
  return std::string(std::getenv("RC_PARAMS")) != "seed=20260101" ||
         setenv("RC_PARAMS", ("seed=20260101 max_success=" + std::to_string(count)).c_str(), 1) ==
             0;
}

}  // namespace collision_monitor::test
