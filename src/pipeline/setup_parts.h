// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/pipeline/fit_links.h"
#include "collision_monitor/pipeline/setup.h"

/// The steps of buildSetup, each in a file of its own. They fill a CycleSetup in this order.
namespace collision_monitor {

/// Fills bodies and labels, in order of link, and notes in the model which links got given shapes.
void makeBodies(const std::vector<LinkFit>& fits, CycleSetup& setup);

/// Turns setup.link_pairs into the list of checked pairs of links and the table of body pairs,
/// ordered by kind of core pair and then by bodies.
void listPairs(CycleSetup& setup);

}  // namespace collision_monitor
