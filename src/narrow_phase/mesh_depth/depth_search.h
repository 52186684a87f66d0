// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "collision_monitor/geometry/pose.h"
#include "narrow_phase/mesh_depth/mesh_depth.h"

namespace collision_monitor {

/// [m] Depths that differ by less are the same.
constexpr double kDepthRounding = 1e-12;

/// A corner of one mesh in the solid of the other. Frames: the solid's.
struct DeepCorner {
  KeptDepth::Corner corner;
  double depth{0.0};  ///< [m]
  Eigen::Vector3d at{Eigen::Vector3d::Zero()};
  Eigen::Vector3d on_surface{Eigen::Vector3d::Zero()};
};

/// The search for the corner of one mesh that is deepest in the solid of the other. Frames: the
/// solid's.
struct DepthSearch {
  const MeshTree& mesh;
  const MeshTree& solid;
  Pose solid_from_mesh;
  MeshQueryMemory& memory;
  KeptDepth::Side& side;
  double moved{0.0};  ///< [m] as KeptDepth
  DeepCorner deepest{};
  double beyond{0.0};       ///< [m] only greater depths count
  std::uint32_t points{0};  ///< measured
  std::uint32_t visits{0};  ///< as MeshDepth
};

/// Measures the corner that was the deepest. If it is inside, it is the deepest known.
/// @param is_inside it is known to be inside
void measureDeepest(const KeptDepth::Corner& corner, bool is_inside, DepthSearch& search) noexcept;

/// Passes over the deepest corner known, because a deeper one has been found.
void passOverDeepest(DepthSearch& search) noexcept;

/// Looks at the open places, and then at those passed over that may be deeper by now, until none is
/// left or the points are spent.
void searchDeepest(std::uint32_t point_budget, DepthSearch& search) noexcept;

}  // namespace collision_monitor
