// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "collision_monitor/pipeline/setup.h"
#include "pipeline/data/cycle_data.h"

/// Which parts of robots float, and the text about them.
namespace collision_monitor {

/// A part, with the number of its link pairs among those considered. A link that is not known in
/// any part is a part by itself.
struct FloatingPart {
  LinkId top{};
  LinkId first{};              ///< first of its links in these pairs
  std::size_t own_pairs{0};    ///< pairs within the part: known
  std::size_t other_pairs{0};  ///< pairs with other parts: unknown
};

/// The part that others float relative to. It is the world's part if a link of these pairs is known
/// there. Otherwise, for one robot, it is the part of the topmost link, because the pose of the
/// robot's root does not matter then; for several robots, the part of the first known pair. None if
/// there is none.
class MainPart {
 public:
  MainPart(const LinkPoses& poses, const std::vector<CheckedLinkPair>& pairs);
  bool has(LinkId link) const;

 private:
  void consider(const CheckedLinkPair& pair);

  const LinkPoses& poses_;
  std::optional<PartId> part_;
  std::optional<LinkId> topmost_;  ///< if there is only one robot
};

/// Parts other than the main one that have pairs with other parts, in the order of their top links.
std::vector<FloatingPart> findFloatingParts(const LinkPoses& poses,
                                            const std::vector<CheckedLinkPair>& pairs);

/// "link left/hand is unknown: no transform ..."; "object table is unknown: ...".
std::string unknownText(const RobotModel& model, LinkId link, const std::string& reason);

/// "the part of robot 'left' from link 'left/base' on floats: no transform ..."; for a part without
/// pairs of its own: "link left/hand is unknown: no transform ...".
std::string floatingText(const RobotModel& model, const FloatingPart& part,
                         const std::string& reason);

/// The text of services about floating parts among these pairs: the first, and the number of
/// others; empty if there are none.
/// @param reasons as in NewestState
std::string floatingPartsText(const RobotModel& model, const LinkPoses& poses,
                              const std::vector<CheckedLinkPair>& pairs,
                              const std::vector<std::string>& reasons);

}  // namespace collision_monitor
