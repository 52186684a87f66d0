// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "measure_fit.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "collision_monitor/fitting/inner_shape.h"
#include "collision_monitor/geometry/bounds.h"
#include "geometry/constants.h"
#include "geometry/hulls/convex_hull.h"

namespace collision_monitor::fit_tool {
namespace {

struct HullVolume {
  double operator()(const Sphere& sphere) const { return volumeOf(sphere); }
  double operator()(const Capsule& capsule) const { return volumeOf(capsule); }
  double operator()(const Box& box) const { return volumeOf(box); }
  double operator()(const Cylinder& cylinder) const {
    return 2.0 * kPi * cylinder.radius * cylinder.radius * cylinder.half_length;
  }
  double operator()(const TriangleMesh& mesh) const {
    const TriangleMesh hull = convexHullOf(mesh.vertices);
    const Eigen::Vector3d& apex = hull.vertices.front();
    double six_volumes = 0.0;
    for (const auto& [a, b, c] : hull.triangles) {
      six_volumes +=
          (hull.vertices[a] - apex).cross(hull.vertices[b] - apex).dot(hull.vertices[c] - apex);
    }
    return six_volumes / 6.0;
  }
};

bool isInside(const PosedShape& shape, const Eigen::Vector3d& point) {
  return signedDistanceTo(shape.shape, inverse(shape.geometry_from_body) * point) <= 0.0;
}

Aabb boundsOf(const std::vector<PosedShape>& shapes) {
  Aabb bounds;
  bounds.min.setConstant(std::numeric_limits<double>::infinity());
  bounds.max = -bounds.min;
  for (const PosedShape& shape : shapes) {
    const Aabb own = aabbOf(shape.shape, shape.geometry_from_body, 0.0);
    bounds.min = bounds.min.cwiseMin(own.min);
    bounds.max = bounds.max.cwiseMax(own.max);
  }
  return bounds;
}

void keepLarger(const Pose& link_from_geometry, const std::optional<PosedShape>& shape,
                std::optional<PosedShape>& largest) {
  if (shape && (!largest || volumeOf(shape->shape) > volumeOf(largest->shape))) {
    largest = {shape->shape, link_from_geometry * shape->geometry_from_body};
  }
}

}  // namespace

double hullVolumeOf(const Geometry& geometry) { return std::visit(HullVolume(), geometry); }

double unionVolumeOf(const std::vector<PosedShape>& shapes) {
  if (shapes.size() == 1) {
    return volumeOf(shapes.front().shape);
  }
  constexpr int kSteps = 64;
  const Aabb bounds = boundsOf(shapes);
  const Eigen::Vector3d step = (bounds.max - bounds.min) / kSteps;
  std::size_t inside = 0;
  for (int i = 0; i < kSteps * kSteps * kSteps; ++i) {
    const Eigen::Array3i place(i % kSteps, i / kSteps % kSteps, i / (kSteps * kSteps));
    const Eigen::Vector3d point =
        bounds.min + ((place.cast<double>() + 0.5) * step.array()).matrix();
    inside += std::any_of(shapes.begin(), shapes.end(),
                          [&](const PosedShape& shape) { return isInside(shape, point); })
                  ? 1
                  : 0;
  }
  return static_cast<double>(inside) * step.prod();
}

Overshoot unionOvershootOf(const std::vector<PosedShape>& shapes, const TriangleMesh& mesh) {
  const OvershootSampling sampling;
  const TriangleBvh bvh(mesh);
  OvershootSum sum;
  for (const PosedShape& own : shapes) {
    for (const SurfaceSample& sample : sampleSurface(own.shape, sampling.count)) {
      const Eigen::Vector3d point = own.geometry_from_body * sample.point;
      const bool is_hidden = std::any_of(
          shapes.begin(), shapes.end(),
          [&](const PosedShape& other) { return &other != &own && isInside(other, point); });
      if (!is_hidden) {
        sum.add(bvh.nearestTo(point, NearestPoint{}, sampling.tolerance).distance, sample.area);
      }
    }
  }
  return sum.total();
}

InnerShapes innerShapesOf(const Link& link, const std::vector<std::size_t>& elements) {
  InnerShapes largest;
  for (const std::size_t element : elements) {
    const CollisionElement& collision = link.collisions[element];
    const InnerShapes inner = inscribeShapes(collision.geometry);
    keepLarger(collision.link_from_geometry, inner.sphere, largest.sphere);
    keepLarger(collision.link_from_geometry, inner.capsule, largest.capsule);
  }
  return largest;
}

}  // namespace collision_monitor::fit_tool
