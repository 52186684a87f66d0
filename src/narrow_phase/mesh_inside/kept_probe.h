// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <optional>

namespace collision_monitor {

/// A probe that was outside of a mesh. The winding number changes slowly along a segment that does
/// not cross the surface. So the probe stays outside while it is near `point` and the segment from
/// there does not cross the surface.
struct KeptProbe {
  Eigen::Vector3d point{Eigen::Vector3d::Zero()};  ///< [m] in the frame of that mesh
  double hold{0.0};                                ///< [m] as PointInMesh::hold
  /// [m] A lower bound of the distance from `point` to the surface.
  double apart{0.0};

  /// [m] How far the probe may travel on before it can be inside. No value if it may be inside
  /// now.
  std::optional<double> leftAt(const Eigen::Vector3d& now) const noexcept {
    const double moved = (now - point).norm();
    return moved < std::min(hold, apart) ? std::make_optional(hold - moved) : std::nullopt;
  }
};

/// What is kept of the probes of two meshes, by HeldProbe (mesh_distance.h). If they have more
/// probes than `count`, nothing is kept.
struct KeptProbes {
  KeptProbe* first{nullptr};
  std::size_t count{0};
};

}  // namespace collision_monitor
