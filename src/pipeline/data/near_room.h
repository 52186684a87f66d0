// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>

namespace collision_monitor {

/// The room that lists of near pairs have: for all pairs, unless there are very many. Few of very
/// many pairs are near at a time; in scenes where more are, lists grow.
constexpr std::size_t roomForNear(std::size_t pairs) noexcept {
  constexpr std::size_t kMost = 250'000;
  return std::min(pairs, kMost);
}

}  // namespace collision_monitor
