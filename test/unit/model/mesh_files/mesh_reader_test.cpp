// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/mesh_files/mesh_reader.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cctype>
#include <cstring>

#include "mesh_file.h"
#include "support/scratch_folder.h"

namespace collision_monitor::test {
namespace {

std::string bytesOf(float number) {
  std::string bytes(4, '\0');
  std::memcpy(bytes.data(), &number, 4);
  return bytes;
}

/// Binary STL of one triangle (0,0,0) (1,0,0) (0,2,0) behind the given header.
std::string binaryStl(const std::string& header, char count = 1) {
  std::string bytes = header;
  bytes.resize(80, ' ');
  bytes += std::string{count, 0, 0, 0};
  for (const float number : {0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 2.f, 0.f}) {
    bytes += bytesOf(number);
  }
  return bytes + std::string(2, '\0');
}

const std::string kAsciiStl =
    "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 2 0\n"
    "endloop\nendfacet\nendsolid s\n";

TEST(MeshReader, stl_isReadInAllItsGuises) {
  expectTheTriangle(readMesh(kAsciiStl, "a.stl"));
  std::string capitals = kAsciiStl;
  std::transform(capitals.begin(), capitals.end(), capitals.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  expectTheTriangle(readMesh(capitals, "a.stl"));
  expectTheTriangle(readMesh(binaryStl("made by hand"), "package://p/a.STL"));
  expectTheTriangle(readMesh(binaryStl("solid made by hand"), "a.Stl"));
  expectTheTriangle(readMesh(binaryStl("solid, with bytes to spare") + "junk", "a.stl"));
}

TEST(MeshReader, asciiStl_mayHaveAnyNameAndBlanksBeforeIt) {
  for (const char* name : {"", "vertex", "endfacet of my_vertex", "endsolid", "\xC3\xBC"}) {
    std::string text = kAsciiStl;
    text.replace(text.find(" s\nfacet"), 2, " " + std::string(name));
    text.replace(text.rfind(" s\n"), 2, " " + std::string(name));
    expectTheTriangle(readMesh(text, "a.stl"));
  }
  expectTheTriangle(readMesh(" \r\n\t" + kAsciiStl, "a.stl"));
  expectTheTriangle(readMesh("\xEF\xBB\xBF" + kAsciiStl, "a.stl"));
}

TEST(MeshReader, stlCutShort_isAnError) {
  EXPECT_EQ(messageOf([] { readMesh(binaryStl("x", 3), "a.stl"); }),
            "a.stl: the binary STL is cut short: it announces 3 triangles and holds 1");
  EXPECT_EQ(messageOf([] { readMesh(binaryStl("x").substr(0, 83), "a.stl"); }),
            "a.stl: too short for an STL file: 83 bytes");
  for (const std::size_t size : {kAsciiStl.size() - 12, kAsciiStl.size() - 40}) {
    EXPECT_NE(messageOf([&] {
                readMesh(kAsciiStl.substr(0, size), "a.stl");
              }).find("cut short or malformed"),
              std::string::npos);
  }
}

TEST(MeshReader, obj_hasEveryVertexHoweverItIsWritten) {
  // A vertex that is passed over makes all that follow others than the faces mean, and
  // there are enough of them for the faces to name.
  const std::string spare = "v 5 5 5\nv 6 7 8\nv 8 7 6\n";
  for (const char* vertices :
       {"v .0 0 0\nv 1 .0 .0\nv 0 2. .0\n", "  v 0 0 0\n\tv 1 0 0\n v 0 2 0\n",
        "v 0 0 0 .1 .2 .3 1\nv 1 0 0 0 0 0 1\nv 0 2 0 0 0 0 1\n",
        "v 0 0 0 1 1\nv 1 0 0 1 1\nv 0 2 0 1 1\n", "v 0 \\\n 0 0\nv 1 0 \\\r\n0\nv 0 2 0\n",
        "\xEF\xBB\xBFv 0 0 0\nv 1 0 0 # here\r\nv 0 +2e0 -.0\n"}) {
    expectTheTriangle(readMesh(vertices + spare + "  f 1 2 3 # these\n", "a.obj"));
  }
}

TEST(MeshReader, objVertexWithoutThreeNumbers_isAnErrorThatNamesTheLine) {
  for (const char* vertex : {"v 1 2", "v", "v 1 2 x", "v 1 2 # 3"}) {
    EXPECT_EQ(messageOf([&] {
                readMesh("v 0 0 0\nv 1 0 0\n" + std::string(vertex) + "\nv 0 2 0\nf 1 2 4\n",
                         "a.obj");
              }),
              "a.obj: line 3: a vertex needs three numbers, as 'v 0.1 0.2 0.3'");
  }
}

TEST(MeshReader, obj_readsObjectsQuadsAndNegativeIndices) {
  const TriangleMesh mesh = readMesh(
      "mtllib none.mtl\no one\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n"
      "o two\nv 0 0 5\nv 1 0 5\nv 0 1 5\nf -3 -2 -1\n",
      "a.obj");
  EXPECT_EQ(mesh.vertices.size(), 7u);
  EXPECT_EQ(mesh.triangles.size(), 3u);
}

/// assimp would open it, and wait for ever.
TEST(MeshReader, objWhoseMaterialsAreInAPipe_isReadWithoutThem) {
  const ScratchFolder folder;
  const std::filesystem::path pipe = folder.path() / "pipe.mtl";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  expectTheTriangle(readMesh(
      "mtllib " + pipe.string() + "\nv 0 0 0\nv 1 0 0\nv 0 2 0\nusemtl steel\nf 1 2 3\n", "a.obj"));
}

TEST(MeshReader, ply_isRead) {
  expectTheTriangle(
      readMesh("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
               "property float y\nproperty float z\nelement face 1\n"
               "property list uchar int vertex_indices\nend_header\n"
               "0 0 0\n1 0 0\n0 2 0\n3 0 1 2\n",
               "a.ply"));
}

TEST(MeshReader, plyCutShort_isAnError) {
  const std::string header = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n";
  EXPECT_EQ(messageOf([&] { readMesh(header, "a.ply"); }),
            "a.ply: the PLY header has no end_header line");
  EXPECT_EQ(messageOf([&] { readMesh(header + "end_header\n0\n1\n", "a.ply"); }),
            "a.ply: the PLY file is cut short: it announces 3 elements and holds 2 lines");
  EXPECT_EQ(messageOf([] { readMesh("ply\nelement vertex 99999\nend_header\n", "a.ply"); }),
            "a.ply: the PLY header announces more elements than the file can hold");
}

TEST(MeshReader, degenerateTriangles_areSegmentsAndPoints) {
  // A triangle, one whose corners lie on a line far out, and one with equal corners.
  const TriangleMesh mesh = readMesh(
      "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 5 5 5\nv 6 6 6\nv 7 7 7\nv 9 9 9\n"
      "f 1 2 3\nf 4 5 6\nf 7 7 7\n",
      "a.obj");
  EXPECT_EQ(mesh.vertices.size(), 7u);
  using Numbers = std::array<std::uint32_t, 3>;
  EXPECT_EQ(mesh.triangles, (std::vector<Numbers>{{0, 1, 2}, {3, 5, 5}, {6, 6, 6}}));
}

TEST(MeshReader, verticesOfNoFaceAndLines_areLeftOut) {
  const TriangleMesh mesh =
      readMesh("v 0 0 0\nv 1 0 0\nv 0 2 0\nv 5 5 5\nv 6 6 6\nf 1 2 3\nl 4 5\n", "a.obj");
  EXPECT_EQ(mesh.vertices.size(), 3u);
}

TEST(MeshReader, polygonThatCrossesItself_isCovered) {
  // A bow tie: whatever triangulation makes of it, no corner is lost.
  const TriangleMesh bow = readMesh("v 0 0 0\nv 1 1 0\nv 1 0 0\nv 0 1 0\nf 1 2 3 4\n", "a.obj");
  EXPECT_EQ(bow.vertices.size(), 4u);
  EXPECT_EQ(bow.triangles.size(), 2u);
}

TEST(MeshReader, notchedPolygon_staysNotched) {
  // An L of area 3 in a square of area 4.
  const TriangleMesh mesh =
      readMesh("v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nf 1 2 3 4 5 6\n", "a.obj");
  double area = 0.0;
  for (const auto& t : mesh.triangles) {
    area += 0.5 * (mesh.vertices[t[1]] - mesh.vertices[t[0]])
                      .cross(mesh.vertices[t[2]] - mesh.vertices[t[0]])
                      .norm();
  }
  EXPECT_NEAR(area, 3.0, 1e-12);
}

TEST(MeshReader, badFiles_areErrorsThatNameTheFile) {
  EXPECT_EQ(messageOf([] { readMesh("", "a.stl"); }), "a.stl: the file is empty");
  EXPECT_EQ(messageOf([] { readMesh("x", "a.step"); }),
            "a.step: 'step' is not a mesh format that is read (stl, dae, obj, ply)");
  EXPECT_EQ(messageOf([] { readMesh("x", "folder.stl/a"); }),
            "folder.stl/a: '' is not a mesh format that is read (stl, dae, obj, ply)");
  EXPECT_EQ(messageOf([] { readMesh("v 0 0 0\nv 1 0 0\nl 1 2\n", "a.obj"); }),
            "a.obj: no triangles");
  EXPECT_EQ(messageOf([] { readMesh("v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n", "a.obj"); }),
            "a.obj: vertex 1 of the mesh is not finite");
  const std::string of_junk = messageOf([] {
    std::string text = kAsciiStl + kAsciiStl;
    text.replace(text.find("vertex 1"), 8, "vertex x");
    readMesh(text, "a.stl");
  });
  EXPECT_LT(of_junk.size(), 140u) << "not all of the file: " << of_junk;
  for (const char* name : {"a.dae", "a.obj", "a.ply", "a.stl"}) {
    const std::string message = messageOf([&] { readMesh("this is no mesh at all", name); });
    EXPECT_EQ(message.substr(0, 7), std::string(name) + ": ");
  }
}

}  // namespace
}  // namespace collision_monitor::test
