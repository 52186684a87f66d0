// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/model/mesh_reader.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cctype>
#include <cstring>
#include <functional>
#include <stdexcept>

#include "support/assimp_leaks.h"

namespace collision_monitor {
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

/// A DAE with one triangle (0,0,0) (1,0,0) (0,2,0) in the given nodes.
std::string dae(const std::string& asset, const std::string& nodes) {
  return "<?xml version='1.0'?><COLLADA xmlns='http://www.collada.org/2005/11/COLLADASchema' "
         "version='1.4.1'><asset>" +
         asset +
         "</asset><library_geometries><geometry id='g'><mesh><source id='p'>"
         "<float_array id='pa' count='9'>0 0 0 1 0 0 0 2 0</float_array><technique_common>"
         "<accessor source='#pa' count='3' stride='3'><param name='X' type='float'/>"
         "<param name='Y' type='float'/><param name='Z' type='float'/></accessor>"
         "</technique_common></source><vertices id='v'><input semantic='POSITION' source='#p'/>"
         "</vertices><triangles count='1'><input semantic='VERTEX' source='#v' offset='0'/>"
         "<p>0 1 2</p></triangles></mesh></geometry></library_geometries><library_visual_scenes>"
         "<visual_scene id='s'>" +
         nodes +
         "</visual_scene></library_visual_scenes><scene><instance_visual_scene url='#s'/></scene>"
         "</COLLADA>";
}

const std::string kInstance = "<instance_geometry url='#g'/>";

std::string messageOf(const std::function<void()>& read) {
  try {
    read();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "no exception";
}

void expectTheTriangle(const TriangleMesh& mesh) {
  ASSERT_EQ(mesh.vertices.size(), 3u);
  EXPECT_EQ(mesh.vertices[0], Eigen::Vector3d(0.0, 0.0, 0.0));
  EXPECT_EQ(mesh.vertices[1], Eigen::Vector3d(1.0, 0.0, 0.0));
  EXPECT_EQ(mesh.vertices[2], Eigen::Vector3d(0.0, 2.0, 0.0));
  ASSERT_EQ(mesh.triangles.size(), 1u);
  EXPECT_EQ(mesh.triangles[0], (std::array<std::uint32_t, 3>{0, 1, 2}));
}

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

TEST(MeshReader, dae_appliesUnitAndLeavesUpAxisAlone) {
  const TriangleMesh plain = readMesh(dae("", "<node>" + kInstance + "</node>"), "a.dae");
  expectTheTriangle(plain);
  for (const char* axis : {"X_UP", "Y_UP", "Z_UP"}) {
    const TriangleMesh mesh =
        readMesh(dae("<unit meter='0.01'/><up_axis>" + std::string(axis) + "</up_axis>",
                     "<node>" + kInstance + "</node>"),
                 "a.dae");
    ASSERT_EQ(mesh.vertices.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_LT((mesh.vertices[i] - 0.01 * plain.vertices[i]).norm(), 1e-9) << axis;
    }
  }
}

TEST(MeshReader, dae_placesNestedNodesAndEveryInstance) {
  // z by 1, then turned by 90 deg about z: (1,0,0) goes to (0,1,1), (0,2,0) to (-2,0,1).
  const TriangleMesh mesh =
      readMesh(dae("", "<node><translate>0 0 1</translate><node><rotate>0 0 1 90</rotate>" +
                           kInstance + "</node></node><node>" + kInstance + "</node>"),
               "a.dae");
  ASSERT_EQ(mesh.triangles.size(), 2u);
  const auto corner = [&](std::size_t triangle, std::size_t i) {
    return mesh.vertices[mesh.triangles[triangle][i]];
  };
  EXPECT_LT((corner(0, 1) - Eigen::Vector3d(0.0, 1.0, 1.0)).norm(), 1e-6);
  EXPECT_LT((corner(0, 2) - Eigen::Vector3d(-2.0, 0.0, 1.0)).norm(), 1e-6);
  EXPECT_LT((corner(1, 1) - Eigen::Vector3d(1.0, 0.0, 0.0)).norm(), 1e-6);
}

TEST(MeshReader, daeMirroredByANode_keepsItsOutside) {
  const TriangleMesh mesh =
      readMesh(dae("", "<node><scale>-1 1 1</scale>" + kInstance + "</node>"), "a.dae");
  ASSERT_EQ(mesh.triangles.size(), 1u);
  const auto& t = mesh.triangles[0];
  EXPECT_GT((mesh.vertices[t[1]] - mesh.vertices[t[0]])
                .cross(mesh.vertices[t[2]] - mesh.vertices[t[0]])
                .z(),
            0.0);
}

TEST(MeshReader, daeThatShowsNoMesh_isAnError) {
  // assimp would draw the node instead.
  const std::string nodes = "<node><translate>0 0 1</translate>";
  EXPECT_EQ(messageOf([&] {
              readMesh(dae("", nodes + "<instance_geometry url='#other'/></node>"), "a.dae");
            }),
            "a.dae: no triangles");
  EXPECT_EQ(messageOf([&] { readMesh(dae("", nodes + "</node>"), "a.dae"); }),
            "a.dae: no triangles");
}

TEST(MeshReader, daeInUnitsOfNothing_isAnError) {
  EXPECT_EQ(messageOf([] {
              readMesh(dae("<unit meter='0'/>", "<node>" + kInstance + "</node>"), "a.dae");
            }),
            "a.dae: its <unit> is 0 metres");
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

/// assimp would fill the memory.
TEST(MeshReader, daeIndexThatIsNone_isAnError) {
  for (const char* junk : {"0 1! 2", "0 1.0 2", "0 x 2"}) {
    std::string text = dae("", "<node id='n'>" + kInstance + "</node>");
    EXPECT_EQ(readMesh(text, "a.dae").triangles.size(), 1u);
    text.replace(text.find("0 1 2</p>"), 5, junk);
    EXPECT_EQ(messageOf([&] { readMesh(text, "a.dae"); }),
              "a.dae: line 1: <p> holds something that is no index");
  }
}

/// assimp would read beyond the array.
TEST(MeshReader, daeArrayThatIsTooShort_isAnError) {
  std::string text = dae("", "<node id='n'>" + kInstance + "</node>");
  text.replace(text.find("count='9'>0 0 0 1 0 0 0 2 0"), 27, "count='8'>0 0 0 1 0 0 0 2");
  EXPECT_EQ(messageOf([&] { readMesh(text, "a.dae"); }),
            "a.dae: line 1: <accessor> needs 9 numbers of an array of 8");
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

TEST(MeshReader, degenerateTriangles_keepTheirVerticesOnly) {
  // A triangle, one whose corners lie on a line far out, and one with equal corners.
  const TriangleMesh mesh = readMesh(
      "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 5 5 5\nv 6 6 6\nv 7 7 7\nv 9 9 9\n"
      "f 1 2 3\nf 4 5 6\nf 7 7 7\n",
      "a.obj");
  EXPECT_EQ(mesh.triangles.size(), 1u);
  EXPECT_EQ(mesh.vertices.size(), 7u);
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
}  // namespace collision_monitor
