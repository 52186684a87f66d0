// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace collision_monitor {

/// The refusal of a frame's or joint's last data for being too far ahead of now.
struct Refusal {
  std::int64_t ahead_ns{0};  ///< how far ahead; 0: not refused
  std::int64_t at_ns{0};     ///< when they arrived, by this node's clock
};

/// Number of refusals, and time of the last.
struct Refusals {
  std::uint64_t count{0};
  std::int64_t last_ns{0};
};

}  // namespace collision_monitor
