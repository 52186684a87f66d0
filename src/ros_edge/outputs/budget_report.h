// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>

#include "pipeline/answers/budget_use.h"
#include "ros_edge/parameters/monitor_setup.h"

namespace collision_monitor {

/// The entry `budget`: whether refine_budget was sufficient; if not, which link pairs used it, and
/// advice for each of them. All keys differ.
/// @param spent since the last report
void describeBudget(const MonitorSetup& setup, const BudgetUse& spent,
                    diagnostic_updater::DiagnosticStatusWrapper& status);

}  // namespace collision_monitor
