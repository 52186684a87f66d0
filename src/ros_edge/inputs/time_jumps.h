// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "ros_edge/pace.h"

namespace collision_monitor {

/// Log text about time that jumps back. A recording that restarts causes one jump. Two clocks that
/// contradict each other cause one with every message.
class TimeJumps {
 public:
  /// Counts a jump back in time.
  /// @return the text to log; empty if one was logged in the last ten seconds of wall time
  std::string tell(SteadyClock::time_point now);

 private:
  std::optional<SteadyClock::time_point> told_at_;
  std::uint64_t untold_{0};  ///< jumps since then
};

}  // namespace collision_monitor
