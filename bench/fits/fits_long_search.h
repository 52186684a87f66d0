// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include "collision_monitor/geometry/triangle_mesh.h"

namespace collision_monitor::test {

/// Volumes of the fits of a mesh, relative to those of a search from many more starts: 1 is as good
/// as the long search, below 1 is better. NaN without a search.
struct VolumeRatios {
  std::size_t corners{0};  ///< points that the fits use
  double capsule{std::numeric_limits<double>::quiet_NaN()};
  double box{std::numeric_limits<double>::quiet_NaN()};
  double rounded_box{std::numeric_limits<double>::quiet_NaN()};
  /// The rounded box over the smallest of sphere, capsule and box.
  double rounded_over_others{std::numeric_limits<double>::quiet_NaN()};
};

/// @param starts of the long search, spread evenly over all directions or rotations; 0: none.
/// Limits: all NaN for flat meshes, whose boxes have no volume.
VolumeRatios compareVolumes(const TriangleMesh& mesh, int starts);

}  // namespace collision_monitor::test
