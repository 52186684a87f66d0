// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "collision_monitor/pipeline/setup.h"
#include "pipeline/data/cycle_data.h"

/// Which parts of robots float, and how that is said.
namespace collision_monitor {

/// A part, and its pairs of links among those that are asked for. A link that is not known in any
/// part is one by itself.
struct FloatingPart {
  LinkId top{};
  LinkId first{};              ///< of its links in these pairs
  std::size_t own_pairs{0};    ///< between its links: these are known
  std::size_t other_pairs{0};  ///< with other parts: these are not
};

/// The part that others are told apart from: the world's if a link of these pairs is known there,
/// else of one robot that of its topmost link, for where its root stands is of no matter then, of
/// several that of the first pair that is known; none if none is.
class MainPart {
 public:
  MainPart(const LinkPoses& poses, const std::vector<CheckedLinkPair>& pairs);
  bool has(LinkId link) const;

 private:
  void consider(const CheckedLinkPair& pair);

  const LinkPoses& poses_;
  std::optional<PartId> part_;
  std::optional<LinkId> topmost_;  ///< of one robot
};

/// Parts beside the main one that have pairs with others, in order of their tops.
std::vector<FloatingPart> findFloatingParts(const LinkPoses& poses,
                                            const std::vector<CheckedLinkPair>& pairs);

/// "the part of robot 'left' from link 'left/base' on floats: no transform ..." or, of a part
/// without pairs of its own, "link left/hand is unknown: no transform ...".
std::string floatingText(const RobotModel& model, const FloatingPart& part,
                         const std::string& reason);

/// What services say of parts that float among these pairs: the first, and how many more; empty if
/// there are none.
/// @param reasons as those of NewestState
std::string floatingPartsText(const RobotModel& model, const LinkPoses& poses,
                              const std::vector<CheckedLinkPair>& pairs,
                              const std::vector<std::string>& reasons);

}  // namespace collision_monitor
