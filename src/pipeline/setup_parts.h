// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/pipeline/setup.h"

/// The steps of buildSetup, each in a file of its own. They fill a CycleSetup in this order.
namespace collision_monitor {

/// Encloses every collision element: fills bodies and labels, in order of link. Faults of the
/// geometry are added to `report`.
void encloseLinks(double padding, CycleSetup& setup, SetupReport& report);

/// Turns setup.link_pairs into the list of checked pairs of links and the table of body pairs,
/// ordered by kind of core pair and then by bodies.
void listPairs(CycleSetup& setup);

}  // namespace collision_monitor
