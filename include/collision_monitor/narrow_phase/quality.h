// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace collision_monitor {

/// What a distance says of the geometries.
enum class Quality : unsigned char {
  exact,        ///< between the geometries of the URDF themselves
  lower_bound,  ///< the geometries are at least as far apart; below 0 they may touch, and this is
                ///< how deep what encloses them overlaps
  unknown,      ///< a link's pose is unknown: the distance means nothing
  estimate,     ///< the geometries overlap, proven; they are at least this deep, perhaps deeper
};

}  // namespace collision_monitor
