// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace collision_monitor {

/// Corners of `count` boxes to single precision, each rounded as smallBoxOf does, to the last bit.
/// `corners`: 6 numbers a box, least first, and one more behind the last box. `rounded`: 8 a box,
/// as in a SmallBox, of which the fourth and the eighth mean nothing. What comes of NaN means
/// nothing.
void roundOutward(const double* corners, std::size_t count, float* rounded) noexcept;

}  // namespace collision_monitor
