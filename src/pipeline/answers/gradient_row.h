// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "collision_monitor/geometry/twist.h"
#include "collision_monitor/pipeline/setup.h"
#include "pipeline/data/cycle_data.h"

namespace collision_monitor {

/// The derivative of a pair's distance by one velocity of a joint, [m/rad] or [m/m].
struct GradientEntry {
  std::uint32_t variable{0};  ///< index of velocities as in jointTwist
  double value{0.0};
};

/// How the signed distance of a pair changes with the joints between its links; motion of both
/// links changes nothing. Sorted by variable. The rate of the distance is the sum of values times
/// velocities, plus the effect of moving roots.
using GradientRow = std::vector<GradientEntry>;

/// The rows of pairs that are measured at the same poses. The twist of each joint is found once for
/// all rows.
class GradientRows {
 public:
  /// @pre setup and poses outlive the rows and stay unchanged
  GradientRows(const CycleSetup& setup, const LinkPoses& poses);

  /// Moves the links; rows are then those at these poses. Does not allocate.
  void moveTo(const LinkPoses& poses) noexcept;

  /// The row of a measured pair, apart or overlapping. Mimic joints count for their source. The row
  /// is valid until the next call.
  /// Error: the error of the witness points times the derivative of the normal: 1e-9 of the lever
  /// arms where the distance is smooth. Limits: as distanceRate.
  /// Source: distanceRate for the twist of each joint, as in Schulman et al., "Motion planning with
  /// sequential convex optimization and convex collision checking" (2014), section V.
  /// @pre both links are known
  const GradientRow& of(const PairDistance& distance) noexcept;

 private:
  /// How a link is joined to its parent: twists [first, last), one for each velocity of the joint.
  struct Joined {
    LinkId parent{};
    std::size_t first_variable{0};
    std::size_t first{0};
    std::size_t last{0};
    bool is_root{true};
  };

  void addLink(const LinkPoses& poses, const Joint& joint);
  void addJoint(const Wrench& pull, const Joined& joined) noexcept;

  const CycleSetup& setup_;
  std::vector<Joined> joined_;  ///< by LinkId
  std::vector<Twist> twists_;
  GradientRow row_;  ///< has room for every variable
};

}  // namespace collision_monitor
