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
  checked,           ///< no rule says otherwise
  enabled_by_srdf,   ///< checked: an enable_collisions line
  same_rigid_group,  ///< ignored: only fixed joints between them
  adjacent,          ///< ignored: one joint, or joints and links without geometry, between them
  disabled_by_srdf,  ///< ignored: a disable_collisions or disable_default_collisions line
  default_overlap,   ///< ignored: the links touch in the default pose and there is no SRDF
  ignored_by_user,   ///< ignored: the parameter ignore_pairs names it
  touch_link,        ///< ignored: an object and a link that may touch it
};

const char* reasonText(PairReason reason) noexcept;
bool isChecked(PairReason reason) noexcept;

/// a < b; both links have shapes.
struct LinkPair {
  LinkId a{};
  LinkId b{};
  PairReason reason{PairReason::checked};
};

/// Two links to be ignored; each name may be a pattern for several links.
struct NamedPair {
  std::string a;
  std::string b;
};

using LinkIdPair = std::pair<LinkId, LinkId>;  ///< first < second

/// The pairs that `named` describes: each link that matches the first name with each other link
/// that matches the second. Names and patterns work as in shape rules: they match a link's name in
/// messages, or in the URDF of any robot.
///
/// Errors: a name that matches no link; two names that match only one and the same link.
/// @param list name of the list in messages
std::vector<LinkIdPair> findNamedPairs(const std::vector<NamedPair>& named, const std::string& list,
                                       const RobotModel& model, SetupReport& report);

/// Every pair of links that have shapes, each with its reason, sorted by (a, b). The first rule
/// that applies decides:
///
/// 1. A pair of `ignored` is ignored.
/// 2. Links of different robots are checked.
/// 3. Links with only fixed joints between them are ignored: their distance cannot change.
/// 4. A pair with an `enable_collisions` line is checked. This wins over a `disable_collisions`
///    line for the same pair, because an extra pair costs less than a missed one.
/// 5. A pair with a `disable_collisions` line, or `disable_default_collisions` of either link, is
///    ignored.
/// 6. Adjacent links are ignored: the links of a joint touch by design. A link is adjacent to its
///    nearest ancestor with geometry. Links without geometry in between are skipped: they have no
///    extent. They model one mechanical joint of several axes by several URDF joints of one axis.
///    An SRDF does not switch this rule off: it usually lists adjacent pairs, but not always all.
/// 7. All others are checked.
///
/// @pre ids in `srdfs` and `ignored` belong to `model`.
std::vector<LinkPair> decideLinkPairs(const RobotModel& model, const std::vector<SrdfPairs>& srdfs,
                                      const std::vector<LinkIdPair>& ignored = {});

}  // namespace collision_monitor
