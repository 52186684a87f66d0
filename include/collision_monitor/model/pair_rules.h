// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "collision_monitor/geometry/ids.h"
#include "collision_monitor/model/document_text.h"
#include "collision_monitor/model/limits.h"
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
  checked_by_rule,   ///< checked: a rule for pairs says so
  ignored_by_rule,   ///< ignored: a rule for pairs says so
  muted,             ///< ignored until a rule for pairs ends by itself
  touch_link,        ///< ignored: an object and a link that may touch it
  two_objects,       ///< ignored unless a rule asks: two objects, none of them attached
};

/// In messages: "ignored: a line of the SRDF", ...
const char* reasonText(PairReason reason) noexcept;
bool isChecked(PairReason reason) noexcept;  ///< whether pairs with this reason are checked

/// a < b; both links have shapes.
struct LinkPair {
  LinkId a{};                                     ///< the link with the lower id
  LinkId b{};                                     ///< the link with the higher id
  PairReason reason{PairReason::checked};         ///< why it is checked or ignored
  PairReason without_rules{PairReason::checked};  ///< the reason if there were no PairRule
  std::uint32_t rule{kNone};                      ///< the PairRule behind the reason, or kNone
  std::uint32_t limits{0};  ///< 0: the common limits; else an index into OwnLimits, plus one
};

/// One of a user's rules about pairs, with its names resolved to links of a model.
struct PairRule {
  std::vector<bool> a;             ///< by LinkId
  std::vector<bool> b;             ///< by LinkId
  std::optional<bool> is_checked;  ///< empty: the rule does not decide it
  LimitChanges limits{};           ///< those that it sets; empty: the rule leaves them
  bool ends{false};   ///< ends by itself: a rule of this kind that ignores pairs mutes them
  std::string where;  ///< "rules.yaml line 12, rule 3"
  std::string yaml;   ///< the rule as it was read
};

/// Limits that rules give to some pairs.
struct OwnLimits {
  Limits limits;  ///< all of them, those that no rule sets as they are for all pairs
  std::array<std::uint32_t, kLimitFields.size()> rules{};  ///< which set each field, or kNone
};

/// Whether a rule selects two links, in either order.
bool selects(const PairRule& rule, LinkId a, LinkId b) noexcept;

/// What becomes of a rule that selects no pair, and of names that match nothing.
enum class IdleRule : unsigned char {
  is_error,
  is_warning,
  is_accepted,  ///< objects that come later may match
};

/// Reads a user's rules about pairs of links, in YAML, and finds the links that they select.
/// config/pair_rules.yaml shows all of it.
///
/// The text is a list of rules, alone or under `pair_rules`. Each rule selects pairs by `a` and
/// `b`, in either order, and sets some fields: `check`, or limits. The last rule that sets a field
/// of a pair decides it.
///
/// `a` and `b` are each a name, a pattern (* for any characters, ? for one), a group as {group:
/// NAME}, or a list of these. Names and groups are found as in shape rules.
///
/// Adds every fault to `report` as an error with its line: text that is no YAML, unknown and
/// repeated keys, values of a wrong kind or out of range, rules without links or without effect.
/// Names that match nothing are told as `idle` says.
/// @return after an error, what could be read.
std::vector<PairRule> readPairRules(const DocumentText& text, const RobotModel& model,
                                    const std::vector<SrdfPairs>& srdfs, IdleRule idle,
                                    SetupReport& report);

/// The same rules for a model with other links, which their names may select, too.
std::vector<PairRule> selectAnew(std::vector<PairRule> rules, const RobotModel& model,
                                 const std::vector<SrdfPairs>& srdfs);

/// Sets reason, rule and limits of each pair anew.
/// @return the limits that are not the common ones, each once
std::vector<OwnLimits> applyPairRules(const std::vector<PairRule>& rules, const Limits& common,
                                      std::vector<LinkPair>& pairs);

/// Tells of each rule that selects no pair. A rule that names links without shapes is one.
void reportIdleRules(const std::vector<PairRule>& rules, const std::vector<LinkPair>& pairs,
                     IdleRule idle, SetupReport& report);

/// Two links to be ignored; each name may be a pattern for several links.
struct NamedPair {
  std::string a;  ///< a name or pattern
  std::string b;  ///< a name or pattern
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
