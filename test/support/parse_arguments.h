// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace collision_monitor::test {

/// Parses a command line.
/// @param parse takes (argc, argv) as main does.
/// @param said receives what was printed to both streams, unless null.
template <class Parse>
auto parseArguments(const Parse& parse, std::vector<const char*> arguments, std::string* said) {
  arguments.insert(arguments.begin(), "program");
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const auto parsed = parse(static_cast<int>(arguments.size()), arguments.data());
  const std::string text =
      testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr();
  if (said != nullptr) {
    *said = text;
  }
  return parsed;
}

}  // namespace collision_monitor::test
