// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/pipeline/fit_links.h"
#include "collision_monitor/pipeline/setup.h"

namespace collision_monitor {

/// Measures all checked pairs of links of one robot in its default pose (see defaultPositions)
/// and reports those that touch or overlap, with advice. For robots without an SRDF such pairs
/// become ignored, if `ignore`: a pair that always touches would keep the monitor in contact for
/// ever. With an SRDF somebody has decided which pairs count, so they stay checked.
///
/// A cycle refines, so the geometries decide, and not their enclosing shapes: what these hide is
/// apart, and may come into contact. Only where nothing is refined do the shapes speak.
/// Links that only their padding brings together are reported and stay checked.
///
/// Pairs of different robots are left alone: where the robots stand is known only to tf.
/// @pre the set-up was made of these fits
void ruleDefaultOverlaps(const std::vector<SrdfPairs>& srdfs, const std::vector<LinkFit>& fits,
                         bool ignore, CycleSetup& setup, SetupReport& report);

}  // namespace collision_monitor
