// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "enums.h"
#include "failures.h"
#include "robot.h"

// The extension behind the package collision_monitor_core. Users import the package.
PYBIND11_MODULE(_core, module) {
  namespace binding = collision_monitor::python;
  binding::translateFailures();
  binding::findMembers();
  binding::bindRobot(module);
  binding::bindDistances(module);
  binding::bindMany(module);
  binding::bindLoading(module);
  binding::bindSolids(module);
}
