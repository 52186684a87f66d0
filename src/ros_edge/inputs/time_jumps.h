// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "ros_edge/pace.h"

namespace collision_monitor {

/// What the log says of time that jumps back. One jump is that of a recording that begins again;
/// two clocks that contradict each other make as many as they have messages.
class TimeJumps {
 public:
  /// Time jumped back.
  /// @return what is to be said; empty where that was said in the last ten seconds of wall time
  std::string tell(SteadyClock::time_point now);

 private:
  std::optional<SteadyClock::time_point> told_at_;
  std::uint64_t untold_{0};  ///< since then
};

}  // namespace collision_monitor
