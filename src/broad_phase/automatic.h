// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "broad_phase/methods/brute_force.h"
#include "broad_phase/methods/neighbour_list.h"
#include "broad_phase/methods/sweep_and_prune.h"

namespace collision_monitor {

/// Chooses a method by number of bodies, motion and density. It tries the neighbour list, which
/// tells how coherent the motion is and how many boxes a sweep tests. It takes brute force for few
/// bodies in incoherent motion. It takes sweep and prune for coherent motion in scenes so crowded
/// that a sweep tests very many boxes per body. It tries again after some calls. The rule counts
/// work, not time, so equal input leads to equal choices. Measured: docs/decisions/broad-phase.md.
class Automatic {
 public:
  explicit Automatic(std::size_t body_count = 0);

  /// Every pair of boxes that meet, sorted.
  void findMeetings(const std::vector<SmallBox>& boxes, std::vector<PairKey>& found) noexcept;

  /// As BruteForce::markPairs, if there are so few bodies that nothing is faster.
  /// @return false when there are more.
  bool markPairs(const std::vector<SmallBox>& boxes, const PairTable& table,
                 MarkedPairs& marks) noexcept;

 private:
  enum class Method : unsigned char { neighbour_list, brute_force, sweep_and_prune };

  Method chooseMethod(std::size_t body_count, std::size_t pair_count) const noexcept;

  NeighbourList neighbour_list_;
  BruteForce brute_force_;
  SweepAndPrune sweep_and_prune_;
  Method method_{Method::neighbour_list};
  std::size_t calls_{0};  ///< with this method
};

}  // namespace collision_monitor
