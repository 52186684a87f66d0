// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/geometry/mesh_tree.h"

namespace collision_monitor {

/// From this on an inside is more a convention than a fact. A cube without one face has 0.10,
/// half a sphere 0.18, a flat sheet 0.5.
constexpr double kTooOpen = 0.05;

/// How far the winding numbers beside a surface are from whole numbers, which they are beside a
/// closed one: the mean over 256 places spread evenly over the area. Between 0 and 1/2; 0 where the
/// mesh is closed or its surface alone counts. For set-up.
/// Error: of each number 0.005.
double opennessOf(const MeshTree& tree);

}  // namespace collision_monitor
