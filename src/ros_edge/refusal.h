// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace collision_monitor {

/// Of the last data of a frame or joint, if they were refused for being too far ahead of now.
struct Refusal {
  std::int64_t ahead_ns{0};  ///< how far; 0: they were not refused
  std::int64_t at_ns{0};     ///< when they came, by the clock of this node
};

/// How often something was refused, and when last.
struct Refusals {
  std::uint64_t count{0};
  std::int64_t last_ns{0};
};

}  // namespace collision_monitor
