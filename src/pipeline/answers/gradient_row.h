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

/// Derivative of a pair's distance by one velocity of a joint, [m/rad] or [m/m].
struct GradientEntry {
  std::uint32_t variable{0};  ///< as jointTwist counts velocities
  double value{0.0};
};

/// How a pair's signed distance changes with the joints: only those between the two links are in
/// it, for what moves both changes nothing. Sorted by variable. The rate of the distance is the
/// sum of values times velocities, plus what moves the robots' roots.
using GradientRow = std::vector<GradientEntry>;

/// The rows of pairs that are measured at the same poses: how each joint moves what hangs on it is
/// found once for all of them.
class GradientRows {
 public:
  /// @pre both outlive the rows, and the poses do not change meanwhile
  GradientRows(const CycleSetup& setup, const LinkPoses& poses);

  /// The row of a measured pair, apart or overlapping; mimic joints count for their source. It
  /// stands until the next is asked for.
  /// Error: that of the witness points times the derivative of the normal: 1e-9 of the levers where
  /// the distance is smooth. Limits: as distanceRate.
  /// Source: distanceRate for the twist that each joint gives, as in Schulman et al., "Motion
  /// planning with sequential convex optimization and convex collision checking" (2014), section V.
  /// @pre both links are known
  const GradientRow& of(const PairDistance& distance) noexcept;

 private:
  /// What joins a link to its parent: twists [first, last), one for each of the joint's velocities.
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
  GradientRow row_;  ///< with room for every variable
};

}  // namespace collision_monitor
