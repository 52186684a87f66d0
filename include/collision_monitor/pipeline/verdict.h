// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace collision_monitor {

/// What is said of a pair of links, or of all pairs. Ordered by urgency: the overall verdict is the
/// largest.
enum class Verdict : unsigned char { clear, warning, unknown, contact };

/// What many states are asked at once.
enum class StateQuestion : unsigned char {
  contact,  ///< is anything in contact? The search of a state ends at its first contact
  nearest,  ///< the nearest pair and the worst verdict
};

}  // namespace collision_monitor
