// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/pipeline/fit_links.h"
#include "collision_monitor/pipeline/setup.h"

namespace collision_monitor {

/// Measures all checked link pairs of one robot in its default pose (see defaultPositions) and
/// reports those that touch or overlap, with advice. If `ignore`, such pairs of robots without an
/// SRDF become ignored: a pair that always touches would keep the monitor in contact for ever. With
/// an SRDF they stay checked, since a person has decided which pairs count.
///
/// Geometries decide, as in a cycle: links may be apart whose enclosing shapes overlap, and they
/// may come into contact. Enclosing shapes decide where nothing is refined. Links that overlap only
/// by their padding are reported and stay checked.
///
/// Skips pairs of different robots: only tf knows where robots stand.
/// @pre the set-up was made from these fits
void ruleDefaultOverlaps(const std::vector<SrdfPairs>& srdfs, const std::vector<LinkFit>& fits,
                         bool ignore, CycleSetup& setup, SetupReport& report);

}  // namespace collision_monitor
