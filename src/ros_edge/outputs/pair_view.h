// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "ros_edge/watch.h"

namespace collision_monitor {

/// What a cycle knows of two links.
struct PairView {
  bool is_checked{false};
  Verdict verdict{Verdict::clear};
  std::string why;  ///< why the verdict is that; empty if they are not checked
  NearestSeen::Record nearest;
  JointPositions positions;  ///< as NearestSeen::positionsOf
};

/// @param a, b names of links, in any order
PairView viewOf(const Watch& watch, const std::string& a, const std::string& b);

/// As the constants of State: "OK", "WARNING", "UNKNOWN", "CONTACT".
const char* verdictName(Verdict verdict) noexcept;

/// Why the last cycle gave a checked pair its verdict.
std::string verdictReason(const Watch& watch, LinkPairIndex link_pair);

}  // namespace collision_monitor
