// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <optional>

namespace collision_monitor {

/// A probe that was outside of a mesh. Whether a point is inside depends only on where it is, and
/// along a segment that does not cross the surface the winding number changes slowly. So the answer
/// holds for other places near by.
struct KeptProbe {
  Eigen::Vector3d point{Eigen::Vector3d::Zero()};  ///< [m] in the frame of that mesh
  double hold{0.0};                                ///< [m] as PointInMesh::hold
  double apart{0.0};                               ///< [m] a lower bound of its distance then

  /// [m] How far the probe may still travel, if the answer holds where it is now.
  std::optional<double> leftAt(const Eigen::Vector3d& now) const noexcept {
    const double moved = (now - point).norm();
    return moved < std::min(hold, apart) ? std::make_optional(hold - moved) : std::nullopt;
  }
};

/// The first probes of two meshes, by HeldProbe. Later ones are asked each time.
using KeptProbes = std::array<KeptProbe, 32>;

}  // namespace collision_monitor
