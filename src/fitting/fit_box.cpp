// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/fitting/fit_box.h"

#include "fitting/box_rotations.h"
#include "fitting/point_cloud.h"

namespace collision_monitor {

PosedShape fitBox(const Points& points) {
  const NormalisedPoints cloud = normalise(points);
  if (!(cloud.scale > 0.0)) {
    return {Box{}, {Eigen::Matrix3d::Identity(), points[0]}};
  }
  const Points representatives =
      extremePoints(cloud.points, spreadDirections(kRepresentativeDirections));
  const Eigen::Matrix3d axes = smallBoxRotations(representatives, 1).front();
  return boxWithAxes(axes, points);
}

}  // namespace collision_monitor
