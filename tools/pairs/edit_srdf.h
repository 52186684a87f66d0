// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "report.h"
#include "srdf_places.h"

namespace collision_monitor::pairs_tool {

/// Returns the text without the lines `out` and with the lines `in`. New lines come after the last
/// remaining one, or at the end of the root. A removed element that fills its text lines is removed
/// with them. New lines copy the indentation and line ending of existing ones.
/// @pre `places` belong to the text; `out` is a subset of places.disabled
/// @throws std::logic_error if the result differs from the SRDF in more than these lines
std::string editSrdf(const std::string& srdf_xml, const SrdfPlaces& places,
                     const std::vector<SrdfLine>& out, const std::vector<PairLine>& in);

}  // namespace collision_monitor::pairs_tool
