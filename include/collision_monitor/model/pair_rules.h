// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
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
  ignored_by_user,   ///< ignored: the parameter ignore_pairs names it
};

const char* reasonText(PairReason reason) noexcept;
bool isChecked(PairReason reason) noexcept;

/// a < b; only links with shapes stand in pairs.
struct LinkPair {
  LinkId a{};
  LinkId b{};
  PairReason reason{PairReason::checked};
};

/// Two links, or patterns for several, that the user wants to be ignored.
struct NamedPair {
  std::string a;
  std::string b;
};

using LinkIdPair = std::pair<LinkId, LinkId>;  ///< first < second

/// The pairs that are named: of every link that fits one name with every other that fits the
/// second. Names and patterns are as in rules for shapes: of links in messages, or in the URDF of
/// any robot.
///
/// Errors: a name that no link fits, and two that fit but one and the same link.
/// @param list what messages call it
std::vector<LinkIdPair> findNamedPairs(const std::vector<NamedPair>& named, const std::string& list,
                                       const RobotModel& model, SetupReport& report);

/// Every pair of links that have shapes, each with its reason, sorted by (a, b).
/// The first of these rules that says something decides:
///
/// 1. A pair of `ignored`: ignored.
/// 2. Links of different robots are checked.
/// 3. Only fixed joints between them: ignored, for nothing can bring them nearer.
/// 4. An `enable_collisions` line: checked. It wins over a `disable_collisions` line
///    for the same pair, because a pair too many costs less than a pair missed.
/// 5. A `disable_collisions` line, or `disable_default_collisions` of either link: ignored.
/// 6. Adjacent links: ignored, for the links of a joint touch by design. Adjacent is a link and
///    its nearest ancestor with geometry. Links without geometry between them are passed
///    through: they have no extent, and serve to build one mechanical joint of
///    several axes out of URDF's joints of one axis, at which the two neighbours meet.
///    An SRDF does not switch this off: by custom it lists adjacent pairs, but not always all.
/// 7. All others are checked.
///
/// @pre ids in `srdfs` and `ignored` are of `model`.
std::vector<LinkPair> decideLinkPairs(const RobotModel& model, const std::vector<SrdfPairs>& srdfs,
                                      const std::vector<LinkIdPair>& ignored = {});

}  // namespace collision_monitor
