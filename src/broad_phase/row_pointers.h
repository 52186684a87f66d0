// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace collision_monitor {

/// Where the rows of a BoxRows stand: code for one instruction set may not use std::vector.
struct RowPointers {
  const float* min[3];
  const float* max[3];
};

}  // namespace collision_monitor
