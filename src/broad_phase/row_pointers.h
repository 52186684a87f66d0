// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace collision_monitor {

/// Where the rows of a BoxRows stand: code for one instruction set may not use std::vector.
struct RowPointers {
  const float* min[3];
  const float* max[3];
};

/// Rows from the first on and before the last.
struct RowSpan {
  std::size_t first;
  std::size_t last;
};

}  // namespace collision_monitor
