// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/reference/reference_features.h"

#include <Eigen/Dense>
#include <algorithm>
#include <limits>

namespace collision_monitor::test {
namespace {

using Columns = Eigen::Matrix<Real, 3, Eigen::Dynamic, 0, 3, 3>;
using Parameters = Eigen::Matrix<Real, Eigen::Dynamic, 1, 0, 3, 1>;

constexpr Real kInside = 1e-17L;  // parameters outside by no more than this are clamped

RealVector exact(const Eigen::Vector3d& point) { return point.cast<Real>(); }

// Clamps parameters that are outside by rounding; false if one is farther outside.
bool bringInside(const ReferenceFeature& feature, Eigen::Ref<Parameters> parameters) {
  Real sum = 0;
  for (Eigen::Index i = 0; i < parameters.size(); ++i) {
    if (!(parameters[i] >= -kInside && parameters[i] <= 1 + kInside)) {
      return false;
    }
    parameters[i] = std::clamp<Real>(parameters[i], 0, 1);
    sum += parameters[i];
  }
  return !feature.is_simplex || sum <= 1 + 2 * kInside;
}

RealVector pointOn(const ReferenceFeature& feature,
                   const Eigen::Ref<const Parameters>& parameters) {
  RealVector point = feature.base;
  for (Eigen::Index i = 0; i < parameters.size(); ++i) {
    point += parameters[i] * feature.directions[static_cast<std::size_t>(i)];
  }
  return point;
}

Real distanceOfFeatures(const ReferenceFeature& a, const ReferenceFeature& b) {
  constexpr Real kFarAway = std::numeric_limits<Real>::infinity();
  const auto count_a = static_cast<Eigen::Index>(a.directions.size());
  const auto count_b = static_cast<Eigen::Index>(b.directions.size());
  const RealVector between = b.base - a.base;
  if (count_a + count_b == 0) {
    return between.norm();
  }
  Columns columns(3, count_a + count_b);
  for (Eigen::Index i = 0; i < count_a; ++i) {
    columns.col(i) = a.directions[static_cast<std::size_t>(i)];
  }
  for (Eigen::Index i = 0; i < count_b; ++i) {
    columns.col(count_a + i) = -b.directions[static_cast<std::size_t>(i)];
  }
  Eigen::ColPivHouseholderQR<Columns> solver(columns);
  solver.setThreshold(1e-16L);
  if (solver.rank() < columns.cols()) {
    return kFarAway;  // features of fewer parameters hold the solution too
  }
  Parameters solution = solver.solve(between);
  if (!bringInside(a, solution.head(count_a)) || !bringInside(b, solution.tail(count_b))) {
    return kFarAway;
  }
  return (pointOn(b, solution.tail(count_b)) - pointOn(a, solution.head(count_a))).norm();
}

Triangle placedTriangle(const TriangleMesh& mesh, std::size_t i, const Pose& pose) {
  const auto& corners = mesh.triangles[i];
  return {pose * mesh.vertices[corners[0]], pose * mesh.vertices[corners[1]],
          pose * mesh.vertices[corners[2]]};
}

}  // namespace

ReferencePolytope polytopeOf(const Triangle& triangle) {
  ReferencePolytope polytope;
  for (std::size_t i = 0; i < 3; ++i) {
    const RealVector corner = exact(triangle[i]);
    polytope.push_back({corner, {}});
    polytope.push_back({corner, {exact(triangle[(i + 1) % 3]) - corner}});
  }
  const RealVector corner = exact(triangle[0]);
  polytope.push_back({corner, {exact(triangle[1]) - corner, exact(triangle[2]) - corner}, true});
  return polytope;
}

ReferencePolytope polytopeOf(const Shape& shape, const Pose& world_from_shape) {
  // Each axis of the core is at its low end, at its high end, or free.
  ReferencePolytope polytope;
  const Eigen::Vector3d half_extents = coreHalfExtents(shape);
  for (int code = 0; code < 27; ++code) {
    const int choice[3] = {code % 3, code / 3 % 3, code / 9};
    ReferenceFeature feature;
    feature.base = exact(world_from_shape.translation);
    for (int k = 0; k < 3; ++k) {
      const RealVector half =
          static_cast<Real>(half_extents[k]) * exact(world_from_shape.rotation.col(k));
      feature.base += choice[k] == 1 ? half : RealVector(-half);
      if (choice[k] == 2) {
        feature.directions.emplace_back(2 * half);
      }
    }
    polytope.push_back(feature);
  }
  return polytope;
}

Real referenceDistance(const ReferencePolytope& a, const ReferencePolytope& b) {
  Real least = std::numeric_limits<Real>::infinity();
  for (const ReferenceFeature& on_a : a) {
    for (const ReferenceFeature& on_b : b) {
      if (on_a.directions.size() + on_b.directions.size() <= 3) {
        least = std::min(least, distanceOfFeatures(on_a, on_b));
      }
    }
  }
  return least;
}

Real referenceDistance(const TriangleMesh& a, const Pose& world_from_a, const TriangleMesh& b,
                       const Pose& world_from_b) {
  Real least = std::numeric_limits<Real>::infinity();
  for (std::size_t i = 0; i < a.triangles.size(); ++i) {
    const ReferencePolytope of_a = polytopeOf(placedTriangle(a, i, world_from_a));
    for (std::size_t j = 0; j < b.triangles.size(); ++j) {
      least =
          std::min(least, referenceDistance(of_a, polytopeOf(placedTriangle(b, j, world_from_b))));
    }
  }
  return least;
}

Real referenceCoreDistance(const TriangleMesh& a, const Pose& world_from_a, const Shape& b,
                           const Pose& world_from_b) {
  const ReferencePolytope of_b = polytopeOf(b, world_from_b);
  Real least = std::numeric_limits<Real>::infinity();
  for (std::size_t i = 0; i < a.triangles.size(); ++i) {
    least =
        std::min(least, referenceDistance(polytopeOf(placedTriangle(a, i, world_from_a)), of_b));
  }
  return least;
}

}  // namespace collision_monitor::test
