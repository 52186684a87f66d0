// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/geometry/mesh_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>

#include "collision_monitor/geometry/ids.h"
#include "geometry/all_cores.h"
#include "support/query_meshes.h"
#include "support/sample_meshes.h"

namespace collision_monitor::test {
namespace {

using Index = std::uint32_t;
constexpr Index kWidth = MeshTreeNode::kWidth;

// Exact: sums of a few numbers with 24 and 53 bits that are not far apart fit 64 bits.
void expectEncloses(const MeshTree& tree, const MeshTreeNode& node, Index slot,
                    const Triangle& triangle) {
  for (const Eigen::Vector3d& corner : triangle) {
    long double height = 0.0L;
    for (Index k = 0; k < 3; ++k) {
      const long double here = static_cast<long double>(corner[k]) - tree.center()[k];
      EXPECT_LE(std::abs(here - node.center[k][slot]), node.half[k][slot]);
      height += here * node.normal[k][slot];
    }
    EXPECT_LE(std::abs(height - node.slab_center[slot]), node.slab_half[slot]);
  }
}

// Visits what hangs below a slot, holds it against the bound of every ancestor's slot, and notes
// the deepest level.
struct Walk {
  const MeshTree& tree;
  std::multiset<Index> seen;
  Index levels{0};

  void below(const std::vector<std::pair<Index, Index>>& ancestors) {
    levels = std::max(levels, static_cast<Index>(ancestors.size()));
    const auto [node, slot] = ancestors.back();
    const Index child = tree.nodes()[node].child[slot];
    if ((child & MeshTreeNode::kTriangle) != 0) {
      const Index triangle = child & ~MeshTreeNode::kTriangle;
      seen.insert(triangle);
      for (const auto& [above, at] : ancestors) {
        expectEncloses(tree, tree.nodes()[above], at, tree.triangles()[triangle]);
      }
      return;
    }
    for (Index i = 0; i < kWidth; ++i) {
      if (tree.nodes()[child].child[i] != kNone) {
        auto deeper = ancestors;
        deeper.emplace_back(child, i);
        below(deeper);
      }
    }
  }
};

void expectSound(const MeshTree& tree, std::size_t count) {
  Walk walk{tree, {}};
  walk.below({{0, 0}});
  EXPECT_EQ(walk.seen.size(), count);
  EXPECT_EQ(std::set<Index>(walk.seen.begin(), walk.seen.end()).size(), count);
  EXPECT_LE(walk.levels, MeshTree::kMaxLevels + 1);
  std::set<Index> sources(tree.sourceTriangles().begin(), tree.sourceTriangles().end());
  EXPECT_EQ(sources.size(), count);
  EXPECT_EQ(*sources.rbegin(), count - 1);
}

TEST(MeshTree, everyTriangleHangsOnceBelowBoundsThatHoldIt) {
  const TriangleMesh mesh = bumpyMesh(1.0, 60);
  const MeshTree tree(mesh);
  expectSound(tree, mesh.triangles.size());
  // Nodes are well filled: fewer than one for every five triangles.
  EXPECT_LT(tree.nodes().size(), mesh.triangles.size() / 5);
}

TEST(MeshTree, ofManyTriangles_isSoundWhenAllCoresBuildIt) {
  const TriangleMesh mesh = bumpyMesh(1.0, 120);
  ASSERT_GT(mesh.triangles.size(), kManyTriangles);
  expectSound(MeshTree(mesh), mesh.triangles.size());
}

TEST(MeshTree, meshesOfFewTriangles) {
  Random random(20260101);
  for (int count = 1; count <= 70; ++count) {
    expectSound(MeshTree(triangleSoup(1.0, count, random)), static_cast<std::size_t>(count));
  }
}

TEST(MeshTree, farFromTheOriginAndTiny_boundsStillHold) {
  TriangleMesh mesh = bumpyMesh(1e-3, 12);
  for (Eigen::Vector3d& vertex : mesh.vertices) {
    vertex += Eigen::Vector3d(1000.0, -2000.0, 0.1);
  }
  expectSound(MeshTree(mesh), mesh.triangles.size());
}

TEST(MeshTree, equalTriangles_areHalvedByCount) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  for (const std::size_t count : {1000, 10000}) {  // on one core, and on all
    mesh.triangles.assign(count, {0, 1, 2});
    expectSound(MeshTree(mesh), count);
  }
}

TEST(MeshTree, trianglesThatShrinkGeometrically_stayWithinTheLevels) {
  TriangleMesh mesh;
  double x = 1e5;
  for (Index i = 0; i < 300; ++i, x *= 0.8) {
    mesh.vertices.insert(mesh.vertices.end(), {{x, 0, 0}, {1.1 * x, 0, 0}, {x, 0.1 * x, 0}});
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  expectSound(MeshTree(mesh), 300);
}

TEST(MeshTree, sourceTriangles_nameTheMeshsOwn) {
  const TriangleMesh mesh = sphereMesh(1.0, 10);
  const MeshTree tree(mesh);
  for (std::size_t i = 0; i < tree.triangles().size(); ++i) {
    const auto& corners = mesh.triangles[tree.sourceTriangles()[i]];
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(tree.triangles()[i][k], mesh.vertices[corners[k]]);
    }
  }
}

void expectRefused(const TriangleMesh& mesh, const std::string& part) {
  try {
    const MeshTree tree(mesh);
    FAIL() << "taken";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

TEST(MeshTree, badMeshes_areRefusedWithTheirPlace) {
  expectRefused({}, "no vertices");
  expectRefused({{{0, 0, std::numeric_limits<double>::quiet_NaN()}}, {}}, "vertex 0");
  expectRefused({{{0, 0, 0}, {0, 2e6, 0}}, {}}, "vertex 1");
  expectRefused({{{0, 0, 0}, {1, 0, 0}}, {{0, 1, 2}}}, "names vertex 2");
}

}  // namespace
}  // namespace collision_monitor::test
