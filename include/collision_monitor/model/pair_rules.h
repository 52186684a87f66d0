// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/model/srdf_reader.h"

namespace collision_monitor {

/// Why a pair of links is checked or ignored.
enum class PairReason : unsigned char {
  checked,           ///< nothing says otherwise
  enabled_by_srdf,   ///< checked: an enable_collisions line
  same_rigid_group,  ///< ignored: only fixed joints between them
  adjacent,          ///< ignored: one joint, or joints and links without geometry, between them
  disabled_by_srdf,  ///< ignored: a disable_collisions or disable_default_collisions line
  default_overlap,   ///< ignored: the shapes overlap in the default pose and there is no SRDF
};

const char* reasonText(PairReason reason) noexcept;
bool isChecked(PairReason reason) noexcept;

/// a < b; only links with geometry stand in pairs.
struct LinkPair {
  LinkId a{};
  LinkId b{};
  PairReason reason{PairReason::checked};
};

/// Every pair of links that have geometry, each with its reason, sorted by (a, b). Topology decides
/// first (rigid group), then the SRDF where a robot has one, then adjacency. Links of different
/// robots are checked.
///
/// A robot's SRDF is complete by custom: adjacency still applies, for a joint's two links touch.
std::vector<LinkPair> decideLinkPairs(const RobotModel& model, const std::vector<SrdfPairs>& srdfs);

}  // namespace collision_monitor
