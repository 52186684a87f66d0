// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/hulls/hull_faces.h"

#include <gtest/gtest.h>

namespace collision_monitor::test {
namespace {

// Corners 0 to 3; corner 4 is the middle of the edge from 0 to 1.
TriangleMesh tetrahedron() {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return mesh;
}

TEST(HullFaces, closedSolid_hasAllItsEdges) {
  const HullFaces gathered = gatherFaces(tetrahedron(), 1.0);
  EXPECT_EQ(gathered.faces.size(), 4U);
  EXPECT_EQ(gathered.edges.size(), 6U);
}

// Either face may take the triangle without area that lies in their edge: corner 4 is then on the
// other side of it, or in a face and on no edge.
TEST(HullFaces, sliverInAnEdge_isNoGap) {
  TriangleMesh mesh = tetrahedron();
  mesh.vertices.emplace_back(0.5, 0, 0);
  mesh.triangles = {{0, 2, 4}, {4, 2, 1}, {0, 4, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  EXPECT_EQ(gatherFaces(mesh, 1.0).edges.size(), 7U);
  mesh.vertices[3].z() = 0.25;
  EXPECT_EQ(gatherFaces(mesh, 1.0).edges.size(), 6U);
}

TEST(HullFaces, cornerWithinAnEdge_isNoGap) {
  TriangleMesh mesh = tetrahedron();
  mesh.vertices.emplace_back(0.5, 0, 0);
  mesh.triangles = {{0, 2, 4}, {4, 2, 1}, {0, 4, 3}, {4, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  EXPECT_EQ(gatherFaces(mesh, 1.0).edges.size(), 7U);
}

TEST(HullFaces, gapOrFold_noEdgesAtAll) {
  TriangleMesh torn = tetrahedron();
  torn.vertices.emplace_back(0.4, 0.4, 0.4);
  torn.triangles.pop_back();
  torn.triangles.insert(torn.triangles.end(), {{1, 2, 4}, {2, 3, 4}});  // without {3, 1, 4}
  EXPECT_EQ(gatherFaces(torn, 1.0).faces.size(), 5U);
  EXPECT_TRUE(gatherFaces(torn, 1.0).edges.empty());
  TriangleMesh folded = torn;
  folded.triangles.push_back({3, 1, 4});
  EXPECT_EQ(gatherFaces(folded, 1.0).edges.size(), 9U);
  folded.vertices[4] = {0.2, 0.2, 0.2};
  EXPECT_TRUE(gatherFaces(folded, 1.0).edges.empty());
}

TEST(HullFaces, flatHull_keepsItsEdges) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 1}};
  EXPECT_EQ(gatherFaces(mesh, 1.0).edges.size(), 3U);
}

}  // namespace
}  // namespace collision_monitor::test
