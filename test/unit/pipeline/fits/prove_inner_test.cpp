// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/fits/prove_inner.h"

#include <gtest/gtest.h>

#include <limits>

#include "fitting/proofs/surrounding_mesh.h"

namespace collision_monitor {
namespace {

const TriangleMesh kMesh = surroundingMesh(Cylinder{0.3, 0.1});

/// With the shapes that are found for the mesh, changed.
template <class Change>
bool areInsideWith(const Change& change, bool is_closed = true) {
  InnerShapes inner = inscribeShapes(kMesh);
  change(inner);
  return areInside(inner, MeshTree(kMesh, is_closed));
}

TEST(AreInside, whatIsFound_isProven) {
  EXPECT_TRUE(areInsideWith([](InnerShapes&) {}));
  EXPECT_TRUE(areInsideWith([](InnerShapes& inner) { inner = {}; }));
}

TEST(AreInside, whatSticksOut_isRefused) {
  EXPECT_FALSE(areInsideWith(
      [](InnerShapes& inner) { std::get<Sphere>(inner.sphere->shape).radius *= 1.001; }));
  EXPECT_FALSE(areInsideWith(
      [](InnerShapes& inner) { std::get<Capsule>(inner.capsule->shape).radius *= 1.001; }));
  EXPECT_FALSE(areInsideWith(
      [](InnerShapes& inner) { std::get<Capsule>(inner.capsule->shape).half_length += 0.1; }));
}

TEST(AreInside, whatIsFarOutside_isRefused) {
  EXPECT_FALSE(areInsideWith(
      [](InnerShapes& inner) { inner.sphere->geometry_from_body.translation.x() = 5.0; }));
}

TEST(AreInside, openMesh_hasNoInside) {
  EXPECT_FALSE(areInsideWith([](InnerShapes&) {}, false));
}

TEST(AreInside, badNumbersAndKinds_areRefused) {
  EXPECT_FALSE(areInsideWith([](InnerShapes& inner) { inner.sphere->shape = Box{}; }));
  EXPECT_FALSE(areInsideWith([](InnerShapes& inner) { inner.capsule->shape = Sphere{0.01}; }));
  for (const double bad : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_FALSE(areInsideWith([&](InnerShapes& inner) { inner.sphere->shape = Sphere{bad}; }));
  }
  EXPECT_FALSE(areInsideWith(
      [](InnerShapes& inner) { inner.capsule->geometry_from_body.rotation(0, 0) = 3.0; }));
}

}  // namespace
}  // namespace collision_monitor
