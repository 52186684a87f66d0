// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "fitting/proofs/covering.h"
#include "support/fixed_seed.h"
#include "support/random_poses.h"
#include "support/reference/extended_distance.h"
#include "support/sample_meshes.h"

namespace collision_monitor {
namespace {

using test::Random;
using test::uniform;

constexpr double kTolerance = 1e-5;

/// Two to five shapes about a blob, large enough to cover it now and then.
std::vector<PosedShape> someShapes(Random& random, double size) {
  std::vector<PosedShape> shapes;
  const int count = 2 + static_cast<int>(random() % 4);
  for (int i = 0; i < count; ++i) {
    const Pose pose = test::randomPose(random, 0.4 * size);
    const double radius = uniform(random, 0.3, 1.2) * size;
    const Eigen::Vector3d half(radius, uniform(random, 0.3, 1.2) * size, radius);
    const Shape choices[] = {Sphere{radius}, Capsule{0.5 * size, radius}, Box{half},
                             RoundedBox{half, 0.1 * size}};
    shapes.push_back({choices[random() % 4], pose});
  }
  return shapes;
}

/// The least distance of a point to any of the shapes, negative inside.
long double distanceToUnion(const std::vector<PosedShape>& shapes, const Eigen::Vector3d& point) {
  long double least = 1e30L;
  for (const PosedShape& shape : shapes) {
    least = std::min(least, test::extendedDistance(shape.shape, shape.geometry_from_body, point));
  }
  return least;
}

/// Most cases are one or the other; a few at the edge may be neither.
RC_GTEST_PROP(CoveringLaws, provenUnions_holdEveryPointOfTheSurface, ()) {
  Random random(*rc::gen::inRange(0U, 1000000U));
  const double size = 0.3;
  const TriangleMesh mesh = test::moved(test::randomCloud({size, 0.5 * size, 0.5 * size}, 30, 7U),
                                        test::randomPoint(random, 1.0), {0.0, 0.0, 0.0});
  const std::vector<PosedShape> shapes = someShapes(random, size);
  const Geometry geometry = mesh;
  const Covering covering = proveCovering({{Pose(), &geometry}}, shapes, kTolerance);
  RC_TAG(covering.is_proven ? "proven" : "not proven");
  if (!covering.is_proven) {
    // A point that is said to lie outside does.
    RC_ASSERT(covering.excess > 0.0);
    if (covering.excess > kTolerance) {
      RC_ASSERT(distanceToUnion(shapes, covering.farthest) > 0.0L);
    }
    return;
  }
  for (const auto& triangle : mesh.triangles) {
    for (int sample = 0; sample < 50; ++sample) {
      const double a = uniform(random, 0.0, 1.0);
      const double b = uniform(random, 0.0, 1.0 - a);
      const Eigen::Vector3d point = a * mesh.vertices[triangle[0]] +
                                    b * mesh.vertices[triangle[1]] +
                                    (1.0 - a - b) * mesh.vertices[triangle[2]];
      RC_ASSERT(distanceToUnion(shapes, point) <=
                static_cast<long double>(covering.widening) + 1e-15L);
    }
  }
}

}  // namespace
}  // namespace collision_monitor
