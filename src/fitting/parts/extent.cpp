// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/parts/extent.h"

#include <Eigen/Eigenvalues>

#include "fitting/shapes/rough_fit.h"

namespace collision_monitor {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d sidesOf(const Points& points, const Matrix3d& axes) {
  return 2.0 * boxAround(axes, points).half_extents;
}

}  // namespace

Extent extentOf(const PointSummary& summary, double layer) {
  Eigen::SelfAdjointEigenSolver<Matrix3d> scatter;
  scatter.computeDirect(summary.moments.covariance());
  const Vector3d along_frame = sidesOf(summary.corners, Matrix3d::Identity()).array() + layer;
  const Vector3d along_scatter = sidesOf(summary.corners, scatter.eigenvectors()).array() + layer;
  const Vector3d& box = along_frame.prod() <= along_scatter.prod() ? along_frame : along_scatter;
  constexpr double kOfABox = 12.0;  // squared side of a box, over its variance
  const Vector3d even = (kOfABox * scatter.eigenvalues().cwiseMax(0.0)).cwiseSqrt().array() + layer;
  return {box.prod() + even.prod(), box.norm()};
}

}  // namespace collision_monitor
