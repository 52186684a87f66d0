// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/epa/polytope.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <memory>

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

SupportVertex vertexAt(double x, double y, double z) {
  SupportVertex vertex;
  vertex.difference = {x, y, z};
  return vertex;
}

/// A corner at (-1, -1, -1), the others 4 along the axes: three faces at 1 from the origin, and
/// x + y + z = 1.
std::unique_ptr<ConvexWorkspace> tetrahedron(bool is_swapped = false) {
  std::array<SupportVertex, 4> corners{vertexAt(-1, -1, -1), vertexAt(3, -1, -1),
                                       vertexAt(-1, 3, -1), vertexAt(-1, -1, 3)};
  if (is_swapped) {
    std::swap(corners[1], corners[2]);
  }
  auto polytope = std::make_unique<ConvexWorkspace>();
  startPolytope(corners, *polytope);
  return polytope;
}

std::size_t nearestFaceOf(const ConvexWorkspace& polytope) {
  const double* first = polytope.keys.data();
  return static_cast<std::size_t>(std::min_element(first, first + polytope.face_count) - first);
}

std::size_t faceAcross(const Vector3d& normal, const ConvexWorkspace& polytope) {
  std::size_t face = 0;
  while (polytope.faces[face].is_gone || polytope.faces[face].normal.dot(normal) < 0.999) {
    ++face;
  }
  return face;
}

/// The faces that stand, each edge joined to the face that has it in the other sense, and no vertex
/// beyond any of them.
std::size_t countFaces(const ConvexWorkspace& polytope) {
  std::size_t count = 0;
  for (std::size_t f = 0; f < polytope.face_count; ++f) {
    const auto& face = polytope.faces[f];
    if (face.is_gone) {
      continue;
    }
    ++count;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& other = polytope.faces[face.neighbours[k]];
      bool is_joined = false;
      for (std::size_t j = 0; j < 3; ++j) {
        is_joined = is_joined || (other.corners[j] == face.corners[(k + 1) % 3] &&
                                  other.corners[(j + 1) % 3] == face.corners[k]);
      }
      EXPECT_TRUE(is_joined && !other.is_gone) << "face " << f << ", edge " << k;
    }
    for (std::size_t v = 0; v < polytope.vertex_count; ++v) {
      EXPECT_LE(face.normal.dot(polytope.vertices[v].difference), face.offset + 1e-12);
    }
  }
  return count;
}

TEST(Polytope, fourCorners_facesLookOutwardWhateverTheirOrder) {
  for (const bool is_swapped : {false, true}) {
    const auto polytope = tetrahedron(is_swapped);
    EXPECT_EQ(countFaces(*polytope), 4U);
    EXPECT_EQ(polytope->vertex_count, 4U);
    const std::size_t nearest = nearestFaceOf(*polytope);
    EXPECT_NEAR(polytope->keys[nearest], 1.0 / std::sqrt(3.0), 1e-15);
    EXPECT_NEAR((polytope->faces[nearest].normal - Vector3d::Ones().normalized()).norm(), 0.0,
                1e-15);
  }
}

TEST(Polytope, vertexThatOneFaceSees_threeInItsPlace) {
  const auto polytope = tetrahedron();
  const std::size_t nearest = nearestFaceOf(*polytope);
  EXPECT_EQ(grow(vertexAt(2, 2, 2), nearest, 1e-12, *polytope), Growth::grown);
  EXPECT_EQ(countFaces(*polytope), 6U);
  EXPECT_EQ(polytope->vertex_count, 5U);
  EXPECT_TRUE(polytope->faces[nearest].is_gone);
  EXPECT_TRUE(std::isinf(polytope->keys[nearest])) << "never the nearest again";
  EXPECT_EQ(polytope->keys[nearestFaceOf(*polytope)], 1.0);
}

TEST(Polytope, vertexThatTwoFacesSee_fourInTheirPlace) {
  const auto polytope = tetrahedron();
  const std::size_t nearest = nearestFaceOf(*polytope);
  EXPECT_EQ(grow(vertexAt(3, 3, -3), nearest, 1e-12, *polytope), Growth::grown);
  EXPECT_EQ(countFaces(*polytope), 6U);
}

TEST(Polytope, vertexInThePlaneOfANeighbour_doesNotTakeIt) {
  const auto polytope = tetrahedron();
  EXPECT_EQ(grow(vertexAt(2, 2, -1), nearestFaceOf(*polytope), 1e-12, *polytope), Growth::grown);
  EXPECT_EQ(countFaces(*polytope), 6U) << "one taken; two stand in one plane";
}

TEST(Polytope, placesOfFacesThatAreGone_areUsedAgain) {
  const auto polytope = tetrahedron();
  grow(vertexAt(2, 2, 2), nearestFaceOf(*polytope), 1e-12, *polytope);
  const std::size_t places = polytope->face_count;
  EXPECT_EQ(polytope->free_count, 1U);
  grow(vertexAt(-3, 0, 0), faceAcross(-Vector3d::UnitX(), *polytope), 1e-12, *polytope);
  EXPECT_EQ(countFaces(*polytope), 8U);
  EXPECT_EQ(polytope->face_count, places + 2);
}

TEST(Polytope, noRoomLeft_isFullAndUnchanged) {
  const auto polytope = tetrahedron();
  polytope->vertex_count = ConvexWorkspace::kMaxVertices;
  EXPECT_EQ(grow(vertexAt(2, 2, 2), nearestFaceOf(*polytope), 1e-12, *polytope), Growth::full);
  polytope->vertex_count = 4;
  EXPECT_EQ(countFaces(*polytope), 4U);
}

TEST(Polytope, everyFaceSeesTheVertex_isRefusedAndUnchanged) {
  const auto polytope = tetrahedron();
  // With so much taken for rounding no face is left to join the vertex to.
  EXPECT_EQ(grow(vertexAt(2, 2, 2), nearestFaceOf(*polytope), -100.0, *polytope), Growth::refused);
  EXPECT_EQ(countFaces(*polytope), 4U);
  for (std::size_t f = 0; f < 4; ++f) {
    EXPECT_FALSE(polytope->faces[f].is_visible);
  }
}

}  // namespace
}  // namespace collision_monitor
