// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "collision_monitor/fitting/enclose.h"
#include "collision_monitor/fitting/fit_parts.h"
#include "collision_monitor/fitting/inner_shape.h"
#include "fitting/proofs/proof.h"
#include "fitting/sphere_trees/build_sphere_tree.h"
#include "support/sample_meshes.h"

// Meshes as they are found in the wild, each through everything that takes a mesh: each gets fits
// that enclose, or the same clear error everywhere.
namespace collision_monitor {
namespace {

using test::boxMesh;
using test::scaled;

struct HardMesh {
  const char* name;
  TriangleMesh mesh;
};

TriangleMesh openBox() {
  TriangleMesh mesh = boxMesh({0.3, 0.2, 0.1});
  mesh.triangles.resize(9);
  return mesh;
}

TriangleMesh insideOutBox() {
  TriangleMesh mesh = boxMesh({0.3, 0.2, 0.1});
  for (auto& triangle : mesh.triangles) {
    std::swap(triangle[0], triangle[1]);
  }
  return mesh;
}

/// Two boxes that cross each other like a plus sign.
TriangleMesh crossedBoxes() {
  return test::joined(boxMesh({0.3, 0.05, 0.05}), boxMesh({0.05, 0.3, 0.05}));
}

/// Every triangle with vertices of its own, as STL files have them, and each of them twice.
TriangleMesh duplicatedBox() {
  const TriangleMesh box = boxMesh({0.3, 0.2, 0.1});
  TriangleMesh mesh;
  for (int copy = 0; copy < 2; ++copy) {
    for (const auto& t : box.triangles) {
      const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
      for (const auto corner : t) {
        mesh.vertices.push_back(box.vertices[corner]);
      }
      mesh.triangles.push_back({first, first + 1, first + 2});
    }
  }
  return mesh;
}

std::vector<HardMesh> hardMeshes() {
  return {
      {"one point", {{{0.1, 0.2, 0.3}}, {}}},
      {"one point as a triangle", {{{0.1, 0.2, 0.3}}, {{0, 0, 0}}}},
      {"many vertices in one place", {std::vector<Eigen::Vector3d>(50, {0.1, -0.2, 0.3}), {}}},
      {"one triangle", {{{0, 0, 0}, {0.3, 0, 0}, {0.1, 0.2, 0.1}}, {{0, 1, 2}}}},
      {"a triangle without area", {{{0, 0, 0}, {0.1, 0.1, 0}, {0.3, 0.3, 0}}, {{0, 1, 2}}}},
      {"flat", {{{0, 0, 0}, {0.3, 0, 0}, {0.3, 0.2, 0}, {0, 0.2, 0}}, {{0, 1, 2}, {0, 2, 3}}}},
      {"duplicate vertices", duplicatedBox()},
      {"inside out", insideOutBox()},
      {"open", openBox()},
      {"crossing itself", crossedBoxes()},
      {"far away", test::moved(boxMesh({0.3, 0.2, 0.1}), {0, 0, 1}, {1e4, -2e4, 5e3})},
      {"needle", boxMesh({1.0, 1e-7, 1e-9})},
  };
}

constexpr double kScales[] = {1e-6, 1.0, 1e6};

bool isInsideOne(const std::vector<SphereNode>& spheres, const Eigen::Vector3d& point) {
  return std::any_of(spheres.begin(), spheres.end(), [&](const SphereNode& sphere) {
    return (point - sphere.center).norm() <= sphere.radius;
  });
}

TEST(HardMeshes, eachHasAShapeThatEnclosesIt) {
  for (const auto& hard : hardMeshes()) {
    for (const double scale : kScales) {
      const TriangleMesh mesh = scaled(hard.mesh, scale);
      const Enclosure enclosure = encloseTightly(mesh);
      const PosedShape fit{enclosure.shape, enclosure.geometry_from_body};
      EXPECT_LE(provenExcess(fit, mesh.vertices), 0.0) << hard.name << ", scale " << scale;
      EXPECT_TRUE(std::isfinite(enclosure.overshoot.max)) << hard.name << ", scale " << scale;
    }
  }
}

TEST(HardMeshes, eachIsHeldBySeveralShapesToo) {
  FitLimits limits;
  limits.max_shapes = 3;
  for (const auto& hard : hardMeshes()) {
    for (const double scale : kScales) {
      const TriangleMesh mesh = scaled(hard.mesh, scale);
      const Fit fit = fitGeometries({mesh}, limits).front();
      EXPECT_LE(provenExcess(mesh, fit), 0.0) << hard.name << ", scale " << scale;
      EXPECT_LE(fit.shapes.size(), limits.max_shapes) << hard.name << ", scale " << scale;
      EXPECT_TRUE(std::isfinite(fit.overshoot.max)) << hard.name << ", scale " << scale;
    }
  }
}

TEST(HardMeshes, aMillionTriangles_areOneMeshMore) {
  const TriangleMesh mesh = test::sphereMesh(0.3, 1002);
  ASSERT_GE(mesh.triangles.size(), 1000000u);
  const Enclosure enclosure = encloseTightly(mesh);
  EXPECT_LE(provenExcess({enclosure.shape, enclosure.geometry_from_body}, mesh.vertices), 0.0);
  EXPECT_NEAR(radiusOf(enclosure.shape), 0.3, 1e-6);
  EXPECT_LT(enclosure.overshoot.max, 1e-5);
  SphereTreeLimits limits;
  limits.max_leaves = 2;
  const auto halves = spheresOfLevel(buildSphereTree(mesh, limits), 1);
  ASSERT_EQ(halves.size(), 2u);
  EXPECT_TRUE(std::all_of(mesh.vertices.begin(), mesh.vertices.end(),
                          [&](const auto& vertex) { return isInsideOne(halves, vertex); }));
}

TEST(HardMeshes, eachHasASphereTreeThatHoldsItOnEveryLevel) {
  for (const auto& hard : hardMeshes()) {
    for (const double scale : kScales) {
      const TriangleMesh mesh = scaled(hard.mesh, scale);
      const SphereTree tree = buildSphereTree(mesh, {});
      for (std::uint32_t level = 0; level < levelCount(tree); ++level) {
        const auto spheres = spheresOfLevel(tree, level);
        for (const auto& vertex : mesh.vertices) {
          EXPECT_TRUE(isInsideOne(spheres, vertex))
              << hard.name << ", scale " << scale << ", level " << level;
        }
      }
    }
  }
}

TEST(HardMeshes, onlyThoseWithAnInsideHaveInnerShapes) {
  for (const auto& hard : hardMeshes()) {
    for (const double scale : kScales) {
      const InnerShapes inner = inscribeShapes(scaled(hard.mesh, scale));
      const std::string name = hard.name;
      const bool is_thick = name == "inside out" || name == "crossing itself" || name == "far away";
      const bool is_hollow = !is_thick && name != "needle" && name != "duplicate vertices";
      EXPECT_TRUE(inner.sphere.has_value() || !is_thick) << name << ", scale " << scale;
      EXPECT_FALSE(inner.sphere.has_value() && is_hollow) << name << ", scale " << scale;
      if (inner.sphere) {
        // The largest ball of the boxes has their least half extent.
        EXPECT_LE(radiusOf(inner.sphere->shape), 0.1 * scale) << name << ", scale " << scale;
      }
    }
  }
}

template <class Function>
std::string faultOf(const Function& function) {
  try {
    function();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "no error";
}

TEST(HardMeshes, whatCannotBeUsed_isTheSameErrorEverywhere) {
  TriangleMesh with_nan = boxMesh({1, 1, 1});
  with_nan.vertices[5].z() = std::numeric_limits<double>::quiet_NaN();
  TriangleMesh without_vertex = boxMesh({1, 1, 1});
  without_vertex.triangles[3][1] = 8;
  const HardMesh faults[] = {
      {"mesh: no vertices; at least one is needed", {}},
      {"mesh: vertex 5 is (1, -1, nan); coordinates up to 1e+100 are accepted", with_nan},
      {"mesh: triangle 3 names vertex 8; there are 8, counted from 0", without_vertex},
  };
  for (const auto& fault : faults) {
    EXPECT_EQ(faultOf([&] { encloseTightly(fault.mesh); }), fault.name);
    EXPECT_EQ(faultOf([&] { fitGeometries({fault.mesh}, {}); }), fault.name);
    EXPECT_EQ(faultOf([&] { buildSphereTree(fault.mesh, {}); }), fault.name);
    EXPECT_EQ(faultOf([&] { inscribeShapes(fault.mesh); }), fault.name);
  }
}

}  // namespace
}  // namespace collision_monitor
