// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/proofs/union_overshoot.h"

#include "collision_monitor/geometry/ids.h"
#include "geometry/interruption.h"

namespace collision_monitor {
namespace {

bool isHeldByAnother(const Eigen::Vector3d& point, std::size_t own,
                     const std::vector<PosedShape>& shapes) {
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const Pose& pose = shapes[i].geometry_from_body;
    const Eigen::Vector3d in_body = pose.rotation.transpose() * (point - pose.translation);
    if (i != own && signedDistanceTo(shapes[i].shape, in_body) < 0.0) {
      return true;
    }
  }
  return false;
}

}  // namespace

std::vector<MeasuredSample> measureSamples(const PosedShape& fit, const TriangleBvh& mesh,
                                           const DistanceGrid* grid,
                                           const OvershootSampling& sampling) {
  std::vector<MeasuredSample> samples;
  NearestPoint nearest;
  for (const auto& sample : sampleSurface(fit.shape, sampling.count)) {
    throwIfInterrupted();
    const Eigen::Vector3d point = fit.geometry_from_body * sample.point;
    if (grid != nullptr && !(grid->distanceTo(point) > 0.0)) {
      samples.push_back({point, 0.0, sample.area});
      continue;
    }
    const NearestPoint start = nearest.leaf_triangle == kNone
                                   ? NearestPoint{}
                                   : mesh.nearestOn(nearest.leaf_triangle, point);
    nearest = mesh.nearestTo(point, start, sampling.tolerance);
    samples.push_back({point, nearest.distance, sample.area});
  }
  return samples;
}

OvershootSum sumOutsideOthers(const std::vector<MeasuredSample>& samples, std::size_t own,
                              const std::vector<PosedShape>& shapes) {
  OvershootSum sum;
  for (const auto& sample : samples) {
    if (!isHeldByAnother(sample.point, own, shapes)) {
      sum.add(sample.distance, sample.area);
    }
  }
  return sum;
}

}  // namespace collision_monitor
