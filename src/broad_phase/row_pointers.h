// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace collision_monitor {

/// Pointers to the rows of a BoxRows: code for one instruction set may not use std::vector.
struct RowPointers {
  const float* min[3];
  const float* max[3];
};

/// The rows [first, last).
struct RowSpan {
  std::size_t first;
  std::size_t last;
};

}  // namespace collision_monitor
