// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/arguments.h"

#include <utility>

namespace collision_monitor {
namespace {

std::string inLines(const std::vector<std::string>& texts) {
  std::string lines;
  for (const std::string& text : texts) {
    lines += (lines.empty() ? "" : "\n") + text;
  }
  return lines;
}

}  // namespace

ArgumentError::ArgumentError(std::vector<std::string> faults)
    : std::invalid_argument(inLines(faults)), faults_(std::move(faults)) {}

}  // namespace collision_monitor
