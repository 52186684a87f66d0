// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/mesh_files/binary_stl.h"

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "mesh_file.h"
#include "model/mesh_loading/mesh_process.h"

namespace collision_monitor::test {
namespace {

using Corners = std::array<Eigen::Vector3f, 3>;

const Corners kTheTriangle = {Eigen::Vector3f(0, 0, 0), {1, 0, 0}, {0, 2, 0}};
const Corners kItsOtherSide = {Eigen::Vector3f(1, 0, 0), {0, 0, 0}, {0, 2, 0}};

void append(float number, std::string& bytes) {
  char word[4];
  std::memcpy(word, &number, sizeof word);
  bytes.append(word, sizeof word);
}

std::string binaryStl(const std::vector<Corners>& triangles) {
  std::string bytes(80, ' ');
  for (std::size_t shift = 0; shift < 32; shift += 8) {
    bytes += static_cast<char>(triangles.size() >> shift & 0xffU);
  }
  for (const Corners& corners : triangles) {
    bytes.append(12, '\x7f');  // a normal that is not finite, which nobody reads
    for (const Eigen::Vector3f& corner : corners) {
      for (const float number : {corner.x(), corner.y(), corner.z()}) {
        append(number, bytes);
      }
    }
    bytes.append(2, '\xff');
  }
  return bytes;
}

TEST(BinaryStl, equalCornersAreOneVertex_inTheOrderOfTheFile) {
  Corners other = kItsOtherSide;
  other[1].x() = -0.0F;  // equals 0
  const TriangleMesh mesh = readBinaryStl(binaryStl({kTheTriangle, other}));
  ASSERT_EQ(mesh.vertices.size(), 3u);
  EXPECT_FALSE(std::signbit(mesh.vertices[0].x()));
  ASSERT_EQ(mesh.triangles.size(), 2u);
  EXPECT_EQ(mesh.triangles[1], (std::array<std::uint32_t, 3>{1, 0, 2}));
}

TEST(BinaryStl, trianglesOfManyVerticesAreAllThere) {
  std::vector<Corners> triangles;
  for (int i = 0; i < 1000; ++i) {
    const auto at = 0.1F * static_cast<float>(i);
    triangles.push_back({Eigen::Vector3f(at, 0, 0), {at, 1, 0.7F * at}, {at, 0, 1}});
  }
  const TriangleMesh mesh = readBinaryStl(binaryStl(triangles));
  ASSERT_EQ(mesh.vertices.size(), 3000u);
  ASSERT_EQ(mesh.triangles.size(), 1000u);
  for (std::size_t i = 0; i < 1000; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(mesh.vertices[mesh.triangles[i][k]], triangles[i][k].cast<double>());
    }
  }
}

using VertexNumbers = std::array<std::uint32_t, 3>;

TEST(BinaryStl, triangleWithoutArea_isItsLongestSide) {
  const TriangleMesh mesh =
      readBinaryStl(binaryStl({{Eigen::Vector3f(0, 0, 0), {2, 0, 0}, {1, 0, 0}},
                               {Eigen::Vector3f(0, 0, 7), {0, 0, 7}, {0, 0, 7}},
                               {Eigen::Vector3f(1, 0, 0), {0, 0, 0}, {1, 0, 0}},
                               kTheTriangle}));
  ASSERT_EQ(mesh.triangles.size(), 3u);
  EXPECT_EQ(mesh.triangles[1], (VertexNumbers{0, 1, 1}));
  EXPECT_EQ(mesh.triangles[2], (VertexNumbers{3, 3, 3}));
}

TEST(BinaryStl, triangleWithoutArea_heldByEdgesOfOthers_isLeftOut) {
  const Eigen::Vector3f low(0, 0, 0);
  const Eigen::Vector3f middle(1, 0, 0);
  const Eigen::Vector3f high(2, 0, 0);
  const Eigen::Vector3f highest(3, 0, 0);
  const Eigen::Vector3f side(0, 1, 0);
  const std::vector<Corners> fan = {{low, middle, side}, {middle, high, side}};
  const auto countWith = [&](std::vector<Corners> flat) {
    flat.insert(flat.end(), fan.begin(), fan.end());
    return readBinaryStl(binaryStl(flat)).triangles.size();
  };
  EXPECT_EQ(countWith({{low, high, middle}}), 2u);
  EXPECT_EQ(countWith({{low, middle, middle}, {side, side, side}}), 2u);
  EXPECT_EQ(countWith({{high, low, low}}), 3u);  // its corners alone do not hold it
  EXPECT_EQ(countWith({{high, low, low}, {low, high, middle}}), 2u);
  EXPECT_EQ(countWith({{low, highest, middle}, {low, middle, highest}}), 3u);
}

TEST(BinaryStl, faultsAreTold) {
  const std::string good = binaryStl({kTheTriangle, kItsOtherSide});
  EXPECT_EQ(messageOf([&] { readBinaryStl(good.substr(0, good.size() - 1)); }),
            "the binary STL is cut short: it announces 2 triangles and holds 1");
  EXPECT_EQ(messageOf([&] { readBinaryStl(good.substr(0, 83)); }),
            "too short for an STL file: 83 bytes");
  Corners far = kTheTriangle;
  far[1].y() = std::numeric_limits<float>::infinity();
  EXPECT_EQ(messageOf([&] { readBinaryStl(binaryStl({far})); }),
            "vertex 1 of the mesh is not finite");
  EXPECT_EQ(messageOf([] { readMesh(binaryStl({}), "a.stl"); }), "a.stl: no triangles");
}

TEST(BinaryStl, isReadWithoutAProcessOfItsOwn) {
  MeshReading reading;
  reading.program = "/nowhere/read_meshes";
  const std::string bytes = binaryStl({kTheTriangle});
  expectTheTriangle(MeshProcess(reading).read(bytes, "a.STL"));
  EXPECT_TRUE(isReadWithoutAssimp(bytes, "a.stl"));
  EXPECT_FALSE(isReadWithoutAssimp(bytes, "a.ply"));
  EXPECT_FALSE(isReadWithoutAssimp("solid s\nendsolid s\n", "a.stl"));
}

}  // namespace
}  // namespace collision_monitor::test
