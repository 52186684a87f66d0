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
  default_overlap,   ///< ignored: the links touch in the default pose and there is no SRDF
};

const char* reasonText(PairReason reason) noexcept;
bool isChecked(PairReason reason) noexcept;

/// a < b; only links with shapes stand in pairs.
struct LinkPair {
  LinkId a{};
  LinkId b{};
  PairReason reason{PairReason::checked};
};

/// Every pair of links that have shapes, each with its reason, sorted by (a, b).
/// The first of these rules that says something decides:
///
/// 1. Links of different robots are checked.
/// 2. Only fixed joints between them: ignored, for nothing can bring them nearer.
/// 3. An `enable_collisions` line: checked. It wins over a `disable_collisions` line
///    for the same pair, because a pair too many costs less than a pair missed.
/// 4. A `disable_collisions` line, or `disable_default_collisions` of either link: ignored.
/// 5. Adjacent links: ignored, for the links of a joint touch by design. Adjacent is a link and
///    its nearest ancestor with geometry. Links without geometry between them are passed
///    through: they have no extent, and serve to build one mechanical joint of
///    several axes out of URDF's joints of one axis, at which the two neighbours meet.
///    An SRDF does not switch this off: by custom it lists adjacent pairs, but not always all.
/// 6. All others are checked.
///
/// @pre ids in `srdfs` are of `model`.
std::vector<LinkPair> decideLinkPairs(const RobotModel& model, const std::vector<SrdfPairs>& srdfs);

}  // namespace collision_monitor
