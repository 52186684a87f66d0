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

/// What the meshes of a link are refined to.
struct ElementSettings {
  RefineGeometry geometry{RefineGeometry::mesh};  ///< where the rules are silent
  const std::vector<LinkRules>& rules;            ///< by LinkId; empty for none

  RefineGeometry refineFor(LinkId link) const {
    return rules.empty() ? geometry : rules[index(link)].refine.value_or(geometry);
  }
};

/// Fills elements, in order of link, and notes in each body which one it encloses.
/// Warns of meshes whose inside is not known.
/// @pre makeBodies was called with these fits.
void makeElements(const std::vector<LinkFit>& fits, const ElementSettings& settings,
                  CycleSetup& setup, SetupReport& report);

/// Turns setup.link_pairs into the list of checked pairs of links and the table of body pairs,
/// ordered by kind of core pair and then by bodies; and that of element pairs.
void listPairs(CycleSetup& setup);

}  // namespace collision_monitor
