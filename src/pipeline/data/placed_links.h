// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "collision_monitor/geometry/pose.h"

namespace collision_monitor {

/// A part: links that are known beside each other. kWorldPart, or for a part that floats the LinkId
/// of its top link.
using PartId = std::uint32_t;
constexpr PartId kWorldPart = 0xffffffffU;  ///< joined to the world

/// The poses of links at an earlier time.
struct PlacedLinks {
  std::vector<Pose> world_from_link;
  std::vector<unsigned char> known;
  std::vector<PartId> part;
};

}  // namespace collision_monitor
