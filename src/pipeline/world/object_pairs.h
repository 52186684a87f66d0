// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/model/world.h"
#include "collision_monitor/pipeline/setup.h"
#include "pipeline/setup/memory_need.h"

namespace collision_monitor {

/// An object and the link that it becomes.
struct ObjectLink {
  LinkId link{};
  const WorldObject* object{nullptr};
};

/// The pairs of objects, as addWorld says. Pairs of two objects are left out if neither is attached
/// or both move together: they may be a hundred million. See withAskedPairs.
/// @pre bodies and elements of `setup` are made, its link_pairs are those of the robots, and the
/// links of objects follow all others, in order of id.
class ObjectPairs {
 public:
  ObjectPairs(const CycleSetup& setup, const std::vector<ObjectLink>& objects);

  /// The sizes of the set-up with them. Nothing is made that grows with the number of pairs.
  /// @throws Interrupted
  PairCounts count() const;

  /// Merges them into pairs of robots, sorted by (a, b).
  /// @param count that of link pairs, for all
  /// @throws Interrupted
  std::vector<LinkPair> merged(std::size_t count) const;

 private:
  PairReason reasonFor(LinkId link, std::size_t k) const;
  template <class Visit>
  void visitWithLink(LinkId link, const Visit& visit) const;
  template <class Visit>
  void visitOfObjects(const Visit& visit) const;

  const CycleSetup& setup_;
  const std::vector<ObjectLink>& objects_;
  std::vector<LinkId> group_of_;
  std::vector<std::size_t> attached_;             ///< those objects
  std::vector<std::vector<LinkId>> touch_links_;  ///< by object, sorted
};

}  // namespace collision_monitor
