// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace collision_monitor {

/// What a distance says about the geometries.
enum class Quality : unsigned char {
  exact,        ///< the distance of the URDF's geometries themselves
  lower_bound,  ///< the signed distance is at least this; below 0 the geometries may touch, and
                ///< overlap at most this deep
  unknown,      ///< a link's pose is unknown: the distance means nothing
  estimate,     ///< the geometries provably overlap, at least this deep
};

}  // namespace collision_monitor
