// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "report.h"
#include "srdf_places.h"

namespace collision_monitor::pairs_tool {

/// The text without some of its lines and with others: behind the last that stays, or where
/// the root ends. An element that has its lines of text for itself takes them with it. New ones
/// are indented, and their lines end, as those that are there.
/// @pre `places` are of the text; `out` is some of places.disabled
/// @throws std::logic_error if the result is not the same SRDF but for these lines
std::string editSrdf(const std::string& srdf_xml, const SrdfPlaces& places,
                     const std::vector<SrdfLine>& out, const std::vector<PairLine>& in);

}  // namespace collision_monitor::pairs_tool
