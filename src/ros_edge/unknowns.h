// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "pipeline/cycle/cycle_buffers.h"
#include "ros_edge/poses/floating_parts.h"

namespace collision_monitor {

/// Unknown pairs between two robots.
struct UnknownPairs {
  std::size_t count{0};
  LinkPairIndex first{kNone};
  LinkPairIndex first_lost{kNone};  ///< of those that were in contact or a warning before
};

/// What is unknown, for messages and sentences. It is found anew only when it changes, because that
/// takes a walk over all pairs.
class Unknowns {
 public:
  /// @param poses those that the events judge; they outlive this
  void find(const CycleSetup& setup, const LinkPoses& poses, const CycleBuffers& buffers);

  /// The links that keep a checked pair unknown: those of the pair that are outside the MainPart.
  const std::vector<LinkId>& links() const noexcept { return links_; }
  /// Floating parts other than the main one that have known pairs of their own.
  const std::vector<FloatingPart>& parts() const noexcept { return parts_; }
  /// The links outside these parts.
  const std::vector<LinkId>& loneLinks() const noexcept { return lone_links_; }
  /// @param a, b robots that move links a and b of the pairs, or robotCount for what none moves
  const UnknownPairs& between(std::size_t a, std::size_t b) const {
    return between_[a * (robots_ + 1) + b];
  }
  /// The link of an unknown pair that is to blame.
  LinkId unknownOf(const CheckedLinkPair& pair) const;

 private:
  bool isUpToDate(const LinkPoses& poses, const PairEvents& events) const;
  void addPairs(const CycleSetup& setup, const PairEvents& events,
                const std::vector<Verdict>& reported, const RobotSpeeds& robots);
  void addParts(const CycleSetup& setup, const LinkPoses& poses);

  std::vector<LinkId> links_;
  std::vector<FloatingPart> parts_;
  std::vector<LinkId> lone_links_;
  std::size_t robots_{0};
  std::vector<UnknownPairs> between_;  ///< a table
  std::optional<MainPart> main_;
  // What these follow from.
  std::uint64_t judgements_{0};
  std::vector<LinkStatus> status_;
  std::vector<PartId> part_;
};

}  // namespace collision_monitor
