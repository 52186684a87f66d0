// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/meshes/check_mesh.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>

namespace collision_monitor {
namespace {

std::string faultOf(const TriangleMesh& mesh) {
  try {
    checkMesh(mesh);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

const TriangleMesh kTriangle{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};

TEST(CheckMesh, soundMeshes_pass) {
  EXPECT_EQ(faultOf(kTriangle), "");
  EXPECT_EQ(faultOf({{{0, 0, 0}}, {}}), "");
  EXPECT_EQ(faultOf({{{0, 0, 0}}, {{0, 0, 0}}}), "");
  EXPECT_EQ(faultOf({{{-kMaxLength, 0, kMaxLength}}, {}}), "");
}

TEST(CheckMesh, noVertices) { EXPECT_EQ(faultOf({}), "mesh: no vertices; at least one is needed"); }

TEST(CheckMesh, vertexOutOfRange_isNamed) {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(),
                           -std::numeric_limits<double>::infinity(), 2e100, -2e100}) {
    for (int axis = 0; axis < 3; ++axis) {
      TriangleMesh mesh = kTriangle;
      mesh.vertices[2][axis] = bad;
      const std::string fault = faultOf(mesh);
      EXPECT_EQ(fault.rfind("mesh: vertex 2 is (", 0), 0u) << fault;
      EXPECT_NE(fault.find("up to 1e+100 are accepted"), std::string::npos) << fault;
    }
  }
}

TEST(CheckMesh, vertexThatIsNotThere_isNamed) {
  TriangleMesh mesh = kTriangle;
  mesh.triangles.push_back({0, 3, 1});
  EXPECT_EQ(faultOf(mesh), "mesh: triangle 1 names vertex 3; there are 3, counted from 0");
}

}  // namespace
}  // namespace collision_monitor
