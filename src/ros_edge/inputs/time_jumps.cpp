// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/inputs/time_jumps.h"

namespace collision_monitor {

std::string TimeJumps::tell(SteadyClock::time_point now) {
  constexpr std::chrono::seconds kPeriod(10);
  if (told_at_ && now - *told_at_ < kPeriod) {
    ++untold_;
    return "";
  }
  told_at_ = now;
  const std::uint64_t jumps = untold_ + 1;
  untold_ = 0;
  return jumps == 1 ? "time jumped back; poses are unknown until new transforms come"
                    : "time jumps back again and again (" + std::to_string(jumps) +
                          " times since it was last said), and poses are unknown each time until "
                          "new transforms come: two nodes may publish /clock and contradict each "
                          "other";
}

}  // namespace collision_monitor
