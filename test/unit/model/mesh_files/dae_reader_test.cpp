// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "mesh_file.h"

namespace collision_monitor::test {
namespace {

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

TEST(DaeReader, dae_appliesUnitAndLeavesUpAxisAlone) {
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

TEST(DaeReader, dae_placesNestedNodesAndEveryInstance) {
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

TEST(DaeReader, daeMirroredByANode_keepsItsOutside) {
  const TriangleMesh mesh =
      readMesh(dae("", "<node><scale>-1 1 1</scale>" + kInstance + "</node>"), "a.dae");
  ASSERT_EQ(mesh.triangles.size(), 1u);
  const auto& t = mesh.triangles[0];
  EXPECT_GT((mesh.vertices[t[1]] - mesh.vertices[t[0]])
                .cross(mesh.vertices[t[2]] - mesh.vertices[t[0]])
                .z(),
            0.0);
}

TEST(DaeReader, daeThatShowsNoMesh_isAnError) {
  // assimp would draw the node instead.
  const std::string nodes = "<node><translate>0 0 1</translate>";
  EXPECT_EQ(messageOf([&] {
              readMesh(dae("", nodes + "<instance_geometry url='#other'/></node>"), "a.dae");
            }),
            "a.dae: no triangles");
  EXPECT_EQ(messageOf([&] { readMesh(dae("", nodes + "</node>"), "a.dae"); }),
            "a.dae: no triangles");
}

TEST(DaeReader, daeInUnitsOfNothing_isAnError) {
  EXPECT_EQ(messageOf([] {
              readMesh(dae("<unit meter='0'/>", "<node>" + kInstance + "</node>"), "a.dae");
            }),
            "a.dae: its <unit> is 0 metres");
}

/// assimp would fill the memory.
TEST(DaeReader, daeIndexThatIsNone_isAnError) {
  for (const char* junk : {"0 1! 2", "0 1.0 2", "0 x 2"}) {
    std::string text = dae("", "<node id='n'>" + kInstance + "</node>");
    EXPECT_EQ(readMesh(text, "a.dae").triangles.size(), 1u);
    text.replace(text.find("0 1 2</p>"), 5, junk);
    EXPECT_EQ(messageOf([&] { readMesh(text, "a.dae"); }),
              "a.dae: line 1: <p> holds something that is no index");
  }
}

/// assimp would read beyond the array.
TEST(DaeReader, daeArrayThatIsTooShort_isAnError) {
  std::string text = dae("", "<node id='n'>" + kInstance + "</node>");
  text.replace(text.find("count='9'>0 0 0 1 0 0 0 2 0"), 27, "count='8'>0 0 0 1 0 0 0 2");
  EXPECT_EQ(
      messageOf([&] { readMesh(text, "a.dae"); }),
      "a.dae: line 1: <accessor> with count 3, stride 3 reads 9 numbers of the <float_array> 'pa', "
      "which holds only 8");
  text.replace(text.find("count='3' stride"), 9, "count='-3'");
  EXPECT_NE(
      messageOf([&] { readMesh(text, "a.dae"); }).find("<accessor> with count -3, stride 3 reads "),
      std::string::npos);
}

/// assimp would make room for that many.
TEST(DaeReader, daeCountThatIsNone_isAnError) {
  const std::string text = dae("", "<node id='n'>" + kInstance + "</node>");
  for (const char* count : {"-1", "4294967295", "99999999999999999999", "9.0", "9 9", "many"}) {
    std::string changed = text;
    changed.replace(changed.find("count='9'"), 9, "count='" + std::string(count) + "'");
    EXPECT_EQ(messageOf([&] { readMesh(changed, "a.dae"); }),
              "a.dae: line 1: <float_array> has the count '" + std::string(count) +
                  "', which is no number of values that the file can hold");
  }
  for (const char* count : {" 9 ", "+9"}) {
    std::string changed = text;
    changed.replace(changed.find("count='9'"), 9, "count='" + std::string(count) + "'");
    EXPECT_EQ(messageOf([&] { readMesh(changed, "a.dae"); }), "no exception") << count;
  }
}

/// assimp would follow them until its stack is full.
TEST(DaeReader, daeNodesWithoutEnd_areErrors) {
  const std::string other = "<node id='b'><instance_node url='#a'/></node>";
  for (const std::string& nodes :
       {std::string("<node id='a'><node><instance_node url='#a'/></node></node>"),
        "<node id='a'>" + kInstance + "<instance_node url='#a'/></node>",
        "<node sid='a'>" + kInstance + "<instance_node url='#a'/></node>",
        "<node id='a'><instance_node url='#b'/></node>" + other}) {
    EXPECT_EQ(messageOf([&] { readMesh(dae("", nodes), "a.dae"); }),
              "a.dae: line 1: <node> instances itself")
        << nodes;
  }
}

TEST(DaeReader, daeNodesThatNestTooDeeply_areErrors) {
  std::string open;
  std::string close;
  for (int i = 0; i < 10000; ++i) {
    open += "<node>";
    close += "</node>";
  }
  EXPECT_NE(messageOf([&] {
              readMesh(dae("", open + kInstance + close), "a.dae");
            }).find("a.dae: line 1: elements nest deeper than "),
            std::string::npos);
  std::string chain = "<node id='0'>" + kInstance + "</node>";
  for (int i = 1; i < 10000; ++i) {
    chain += "<node id='" + std::to_string(i) + "'><instance_node url='#" + std::to_string(i - 1) +
             "'/></node>";
  }
  EXPECT_EQ(messageOf([&] { readMesh(dae("", chain), "a.dae"); }),
            "a.dae: line 1: <node> nests deeper than 500 nodes");
}

TEST(DaeReader, daeNodeThatIsInstancedTwice_isReadTwice) {
  const std::string nodes =
      "<node id='a'>" + kInstance +
      "</node><node><translate>1 0 0</translate><instance_node url='#a'/></node>"
      "<node><translate>2 0 0</translate><instance_node url='#a'/></node>";
  EXPECT_EQ(readMesh(dae("", nodes), "a.dae").triangles.size(), 3u);
}

}  // namespace
}  // namespace collision_monitor::test
