// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

namespace collision_monitor {

/// One fault of the user's input: where it is, what was found there, and what is accepted or
/// advised.
struct Problem {
  std::string where;     ///< "robot.urdf line 42, link 'arm', collision 2"
  std::string found;     ///< "box size '0.1 -0.2 0.3'"
  std::string accepted;  ///< "three numbers greater than 0, in metres"; "" if it does not apply
  std::string advice{};  ///< "they are taken as unlimited": what was done, or what the user can do
};

/// One sentence or two: where it is, what was found, what is accepted and advised.
std::string toString(const Problem& problem);

/// All faults that set-up finds. Readers add to it and go on, so that the user sees every fault at
/// once.
struct SetupReport {
  std::vector<Problem> errors;    ///< the set-up cannot be used
  std::vector<Problem> warnings;  ///< the set-up can be used, but the user should know
  /// A name in a rule that matches nothing is no fault: a robot that comes later may have it, or
  /// something that could not be read.
  bool awaits_names{false};
};

/// All faults of a set-up in one error; what() lists them, one per line.
class SetupError : public std::runtime_error {
 public:
  explicit SetupError(std::vector<Problem> problems);  ///< @param problems at least one
  /// In the order in which they were found.
  const std::vector<Problem>& problems() const noexcept { return problems_; }

 private:
  std::vector<Problem> problems_;
};

/// Text for the user about what ended a program or a request: what() of `failure`, but advice if
/// memory ran out.
std::string failureText(const std::exception& failure);

/// @throws SetupError when the report holds an error.
void throwIfErrors(const SetupReport& report);

}  // namespace collision_monitor
