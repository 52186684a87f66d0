// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/model/problems.h"

#include <new>
#include <utility>

namespace collision_monitor {
namespace {

std::string listOf(const std::vector<Problem>& problems) {
  std::string text =
      std::to_string(problems.size()) +
      (problems.size() == 1 ? " problem in the set-up:" : " problems in the set-up:");
  constexpr std::size_t kShown = 50;
  for (std::size_t i = 0; i < problems.size() && i < kShown; ++i) {
    text += "\n  " + toString(problems[i]);
  }
  if (problems.size() > kShown) {
    text += "\n  and " + std::to_string(problems.size() - kShown) + " more";
  }
  return text;
}

}  // namespace

std::string toString(const Problem& problem) {
  std::string text = problem.where;
  if (!problem.found.empty()) {
    text += (text.empty() ? "" : ": ") + problem.found;
  }
  if (!problem.accepted.empty()) {
    text += (text.empty() ? "accepted: " : "; accepted: ") + problem.accepted;
  }
  if (!problem.advice.empty()) {
    text += (text.empty() ? "" : "; ") + problem.advice;
  }
  return text;
}

SetupError::SetupError(std::vector<Problem> problems)
    : std::runtime_error(listOf(problems)), problems_(std::move(problems)) {}

std::string failureText(const std::exception& failure) {
  return dynamic_cast<const std::bad_alloc*>(&failure) == nullptr
             ? failure.what()
             : "there is not enough memory; fewer pairs of links, collision elements and triangles "
               "need less";
}

void throwIfErrors(const SetupReport& report) {
  if (!report.errors.empty()) {
    throw SetupError(report.errors);
  }
}

}  // namespace collision_monitor
