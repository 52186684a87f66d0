// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/geometry/mesh_tree.h"

namespace collision_monitor {

/// From this value on the inside is more a convention than a fact. A cube without one face has
/// 0.10, half a sphere 0.18, a flat sheet 0.5.
constexpr double kTooOpen = 0.05;

/// How far the winding numbers beside a surface are from whole numbers: the mean over 256 places
/// spread evenly over the area. Beside a closed surface they are whole. Between 0 and 1/2; 0 if the
/// mesh is closed or only its surface counts. For set-up. Error: 0.005 in each number.
double opennessOf(const MeshTree& tree);

}  // namespace collision_monitor
