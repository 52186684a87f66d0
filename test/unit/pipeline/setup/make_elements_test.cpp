// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "open_torso.h"
#include "support/robots/geometry_setup.h"
#include "support/sample_meshes.h"

namespace collision_monitor::test {
namespace {

SetupOptions refinedAs(RefineGeometry refine) {
  SetupOptions options;
  options.refine.geometry = refine;
  return options;
}

void expectSame(const Element& a, const Element& b) {
  ASSERT_TRUE(a.mesh && b.mesh);
  EXPECT_EQ(a.mesh->triangles(), b.mesh->triangles());
  EXPECT_EQ(a.mesh->isClosed(), b.mesh->isClosed());
  EXPECT_EQ(a.mesh->hasInside(), b.mesh->hasInside());
  EXPECT_EQ(a.convex.has_value(), b.convex.has_value());
  EXPECT_EQ(a.hull.has_value(), b.hull.has_value());
  EXPECT_EQ(a.inner.sphere.has_value(), b.inner.sphere.has_value());
  EXPECT_EQ(a.is_exact, b.is_exact);
}

/// Between the two of a kind stands one that is nearly the same.
TEST(MakeElements, ofSameMeshesEachIsAsIfAlone) {
  for (const TriangleMesh& mesh : {angleMesh(), open_meshes::torso(), boxMesh({0.1, 0.2, 0.3})}) {
    TriangleMesh other = mesh;
    other.vertices[1].x() += 1e-6;
    for (const RefineGeometry refine : {RefineGeometry::mesh, RefineGeometry::hull}) {
      const CycleSetup all = geometrySetup({mesh, Sphere{0.1}, other, mesh}, refinedAs(refine));
      ASSERT_EQ(all.elements.size(), 4U);
      const Element alone = geometrySetup({mesh}, refinedAs(refine)).elements.front();
      const Element other_alone = geometrySetup({other}, refinedAs(refine)).elements.front();
      expectSame(all.elements[0], alone);
      expectSame(all.elements[2], other_alone);
      expectSame(all.elements[3], alone);
      EXPECT_FALSE(all.elements[1].mesh);
      EXPECT_NE(all.elements[0].mesh->triangles(), all.elements[2].mesh->triangles());
      EXPECT_NE(all.elements[0].link, all.elements[3].link);
    }
  }
}

}  // namespace
}  // namespace collision_monitor::test
