// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_msgs/DiagnosticStatus.h>
#include <gtest/gtest.h>

#include <map>
#include <string>

namespace collision_monitor::test {

/// By key. Fails where two values have the same one.
inline std::map<std::string, std::string> valuesOf(
    const diagnostic_msgs::DiagnosticStatus& status) {
  std::map<std::string, std::string> values;
  for (const diagnostic_msgs::KeyValue& value : status.values) {
    EXPECT_TRUE(values.emplace(value.key, value.value).second) << value.key;
  }
  return values;
}

}  // namespace collision_monitor::test
