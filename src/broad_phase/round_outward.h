// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace collision_monitor {

/// Converts the corners of `count` boxes to single precision, with the same rounding as smallBoxOf
/// to the last bit. NaN gives undefined numbers.
/// @param corners 6 numbers per box, min first, and one more number behind the last box.
/// @param rounded 8 numbers per box, as in a SmallBox; the fourth and the eighth are undefined.
void roundOutward(const double* corners, std::size_t count, float* rounded) noexcept;

}  // namespace collision_monitor
