// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pair_answers.h"

#include <cstdio>

#include "enums.h"

namespace collision_monitor::python {

std::pair<std::string, std::string> linksOf(const Robot& robot, std::uint32_t pair) {
  const CheckedLinkPair& links = robot.monitor().pairs()[pair];
  return {robot.nameOfLink(links.a), robot.nameOfLink(links.b)};
}

std::string numberText(double number) {
  char digits[32];
  std::snprintf(digits, sizeof(digits), "%.5g", number);
  return digits;
}

std::string pairText(const Robot& robot, const MeasuredPair& pair) {
  const auto [link_a, link_b] = linksOf(robot, pair.pair);
  const std::string links = link_a + " - " + link_b + ": ";
  return pair.quality == Quality::unknown
             ? links + "unknown"
             : links + numberText(pair.measured.distance) + " m (" + nameOf(pair.quality) + ", " +
                   nameOf(pair.verdict) + ")";
}

std::size_t indexIn(pybind11::ssize_t given, std::size_t size) {
  const auto count = static_cast<pybind11::ssize_t>(size);
  if (given < -count || given >= count) {
    throw pybind11::index_error("index " + std::to_string(given) + " of " + std::to_string(size));
  }
  return static_cast<std::size_t>(given < 0 ? given + count : given);
}

}  // namespace collision_monitor::python
