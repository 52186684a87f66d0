// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/pipeline/fit_links.h"
#include "collision_monitor/pipeline/setup.h"

/// The stages of buildSetup, one file each. They fill a CycleSetup in this order.
namespace collision_monitor {

/// Adds paddings of links whose rules give none. Reports names that match nothing.
/// @param where the list in messages
void padLinks(const std::vector<NamedPadding>& paddings, const std::string& where,
              const RobotModel& model, std::vector<LinkRules>& rules, SetupReport& report);

/// Makes the spheres of SRDFs the given shapes of links that have none.
void giveSpheres(const std::vector<SrdfPairs>& srdfs, std::vector<LinkRules>& rules);

/// Where the warning is that no pair is checked.
constexpr const char* kPairsWarning = "pairs";

/// Fills bodies and labels, in order of link, and marks links with given shapes in the model.
void makeBodies(const std::vector<LinkFit>& fits, CycleSetup& setup);

/// What the elements of a link are.
struct ElementSettings {
  RefineGeometry geometry{RefineGeometry::mesh};  ///< where the rules say nothing
  const std::vector<LinkRules>& rules;            ///< by LinkId; empty for none

  RefineGeometry refineFor(LinkId link) const {
    return rules.empty() ? geometry : rules[index(link)].refine.value_or(geometry);
  }
};

/// Fills elements, in order of link, and sets the element of each body. Warns of meshes whose
/// inside is not known.
/// @pre makeBodies was called with these fits.
void makeElements(const std::vector<LinkFit>& fits, const ElementSettings& settings,
                  CycleSetup& setup, SetupReport& report);

/// The link pairs with those of two objects that rules ask for, and without those that former rules
/// asked for. A rule asks for pairs if it says `check: true` and both of its sides select objects
/// alone. Reports rules that ask for too many.
/// @pre link pairs are sorted
std::vector<LinkPair> withAskedPairs(const CycleSetup& setup, const std::vector<PairRule>& rules,
                                     SetupReport& report);

/// Gives link pairs their rules, reasons and limits by setup.pair_rules, and raises the horizon to
/// what thresholds of time need. Reports limits that break a precondition.
void decideByRules(IdleRule idle, CycleSetup& setup, SetupReport& report);

/// The objects of carriers with very many, see CycleSetup::carried.
/// @pre bodies and elements are filled
std::vector<CarriedObjects> findCarried(const CycleSetup& setup);

/// A copy with this model, without what listPairs fills.
CycleSetup withoutTables(const CycleSetup& setup, RobotModel model);

/// Fills the checked link pairs, the pairs of bodies (ordered by kind of core pair, then by bodies)
/// and the pairs of elements from setup.link_pairs; and what is carried.
void listPairs(CycleSetup& setup);

}  // namespace collision_monitor
