// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "pair_answers.h"

namespace collision_monitor::python {

/// The answers for many states.
struct StatesAnswer {
  SharedRobot robot;
  std::vector<StateAnswer> states;
};

/// The answer for a path.
struct PathsAnswer {
  SharedRobot robot;
  PathAnswer path;
};

}  // namespace collision_monitor::python
