// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/narrow_phase/pair_rows.h"

namespace collision_monitor {

/// Has the plain twin measure the rows whose distance is NaN.
void finishRows(CoreKind a, CoreKind b, std::size_t count, PairRows& rows) noexcept;

}  // namespace collision_monitor
