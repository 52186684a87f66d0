// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/robots/missing.h"

#include <algorithm>

#include "ros_edge/outputs/sentences.h"

namespace collision_monitor {
namespace {

template <class IsTold>
std::string sentenceOfMissing(const MonitorSetup& setup, const IsTold& is_told) {
  std::string text;
  std::size_t count = 0;
  for (const ListedRobot& robot : setup.listed) {
    if (!robot.id && is_told(robot)) {
      text = count == 0 ? "robot '" + robot.name + "' is missing: " + robot.missing : text;
      ++count;
    }
  }
  return text + andMore(count, "robot");
}

}  // namespace

bool isAwaited(const ListedRobot& robot) {
  return !robot.id && (robot.has_come || !robot.may_be_absent);
}

bool isAnyAwaited(const MonitorSetup& setup) {
  return std::any_of(setup.listed.begin(), setup.listed.end(), isAwaited);
}

std::string missingSentence(const MonitorSetup& setup) {
  return sentenceOfMissing(setup, [](const ListedRobot&) { return true; });
}

std::string awaitedSentence(const MonitorSetup& setup) {
  return sentenceOfMissing(setup, isAwaited);
}

}  // namespace collision_monitor
