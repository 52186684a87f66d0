// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/mesh_loading/mesh_store.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "support/robots/urdf_text.h"

namespace collision_monitor {
namespace {

const char* const kObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

/// Counts what it is asked for.
struct CountingLoader {
  std::map<std::string, std::string> files;
  std::map<std::string, int> asked;

  ResourceLoader loader() {
    return [this](const std::string& uri) {
      ++asked[uri];
      return test::textLoader(files)(uri);
    };
  }
};

bool finds(CountingLoader& files, const std::string& name, const std::string& directory) {
  const ResourceLoader loader = files.loader();
  MeshStore store(loader);
  try {
    return store.find(name, directory).mesh.triangles.size() == 1;
  } catch (const std::runtime_error&) {
    return false;
  }
}

TEST(MeshStore, schemesAndAbsolutePaths_goToTheLoaderAsTheyAre) {
  CountingLoader files{{{"package://p/a.obj", kObj}, {"file:///x/a.obj", kObj}, {"/y/a.obj", kObj}},
                       {}};
  EXPECT_TRUE(finds(files, "package://p/a.obj", ""));
  EXPECT_TRUE(finds(files, "file:///x/a.obj", "/elsewhere"));
  EXPECT_TRUE(finds(files, "/y/a.obj", "/elsewhere"));
}

// RFC 8089 has file:/ for file:///, and the loader takes it. It was looked for beside the URDF.
TEST(MeshStore, schemeWithOneSlash_isNoRelativeName) {
  CountingLoader files{{{"file:/x/a.obj", kObj}}, {}};
  EXPECT_TRUE(finds(files, "file:/x/a.obj", "/elsewhere"));
  EXPECT_FALSE(finds(files, "package:/p/a.obj", "/elsewhere"));
  EXPECT_EQ(files.asked["package:/p/a.obj"], 1);
}

TEST(MeshStore, relativeName_isFoundBesideTheUrdf) {
  CountingLoader files{{{"/p/urdf/meshes/a.obj", kObj}}, {}};
  EXPECT_TRUE(finds(files, "meshes/a.obj", "/p/urdf"));
  EXPECT_TRUE(finds(files, "./meshes/a.obj", "/p/urdf/"));
  EXPECT_TRUE(finds(files, "../urdf/meshes/a.obj", "/p/urdf"));
}

TEST(MeshStore, relativeName_isFoundUpToThePackageRootAndNotAbove) {
  CountingLoader files{{{"/ws/p/package.xml", "<package/>"},
                        {"/ws/p/meshes/a.obj", kObj},
                        {"/ws/meshes/b.obj", kObj}},
                       {}};
  EXPECT_TRUE(finds(files, "meshes/a.obj", "/ws/p/robots/urdf"));
  EXPECT_FALSE(finds(files, "meshes/b.obj", "/ws/p/robots/urdf"));
}

TEST(MeshStore, descriptionFromAPackageUri_isSearchedTheSameWay) {
  CountingLoader files{{{"package://p/package.xml", "<package/>"},
                        {"package://p/meshes/a.obj", kObj},
                        {"package://p/urdf/b.obj", kObj},
                        {"file:///ws/urdf/c.obj", kObj}},
                       {}};
  EXPECT_TRUE(finds(files, "meshes/a.obj", "package://p/urdf"));
  EXPECT_TRUE(finds(files, "../meshes/a.obj", "package://p/urdf/"));
  EXPECT_TRUE(finds(files, "b.obj", "package://p/urdf"));
  EXPECT_TRUE(finds(files, "c.obj", "file:///ws/urdf"));
  EXPECT_FALSE(finds(files, "d.obj", "package://p/urdf"));
}

TEST(MeshStore, withoutPackage_foldersAboveAreNotSearched) {
  CountingLoader files{{{"/ws/meshes/a.obj", kObj}}, {}};
  EXPECT_FALSE(finds(files, "meshes/a.obj", "/ws/urdf"));
}

TEST(MeshStore, everyFile_isReadOnce) {
  CountingLoader files{{{"/a.obj", kObj}}, {}};
  const ResourceLoader loader = files.loader();
  MeshStore store(loader);
  for (int i = 0; i < 3; ++i) {
    store.find("/a.obj", "");
    EXPECT_THROW(store.find("/missing.obj", ""), std::runtime_error);
  }
  EXPECT_EQ(files.asked["/a.obj"], 1);
  EXPECT_EQ(files.asked["/missing.obj"], 1);
}

/// One triangle: (0, 0, 0), (1, 0, 0), (0, 1, 0).
std::string daeTriangle(const std::string& up_axis) {
  return "<COLLADA xmlns='http://www.collada.org/2005/11/COLLADASchema' version='1.4.1'><asset>"
         "<up_axis>" +
         up_axis +
         "</up_axis></asset><library_geometries><geometry id='g'><mesh><source id='p'>"
         "<float_array id='a' count='9'>0 0 0 1 0 0 0 1 0</float_array><technique_common><accessor "
         "source='#a' count='3' stride='3'><param name='X' type='float'/><param name='Y' "
         "type='float'/><param name='Z' type='float'/></accessor></technique_common></source>"
         "<vertices id='v'><input semantic='POSITION' source='#p'/></vertices><triangles count='1'>"
         "<input semantic='VERTEX' source='#v' offset='0'/><p>0 1 "
         "2</p></triangles></mesh></geometry>"
         "</library_geometries><library_visual_scenes><visual_scene "
         "id='s'><node><instance_geometry "
         "url='#g'/></node></visual_scene></library_visual_scenes><scene><instance_visual_scene "
         "url='#s'/></scene></COLLADA>";
}

TEST(MeshStore, meshThatDeclaresYUp_isAWarningOfTheRobot) {
  const test::ReadText read =
      test::readText(test::robotXml(test::linkXml("a", "<mesh filename='/a.dae'/>")),
                     {{"/a.dae", daeTriangle("Y_UP")}});
  EXPECT_EQ(read.errors(), std::vector<std::string>());
  EXPECT_EQ(read.warnings(),
            std::vector<std::string>{
                "test.urdf: meshes that declare another up axis than z: link 'a', collision 1; "
                "they are not turned, as in rviz and MoveIt; parameter obey_up_axis turns them"});
}

TEST(TurnedUp, theDeclaredUpAxisBecomesZAndTheRightAxisBecomesX) {
  const TriangleMesh mesh{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}, {{0, 1, 2}}};
  using Vertices = std::vector<Eigen::Vector3d>;
  // Y_UP: right x, up y, inward z. X_UP: right -y, up x, inward z. Z_UP: inward is -y.
  EXPECT_EQ(turnedUp(mesh, UpAxis::y).vertices, (Vertices{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}}));
  EXPECT_EQ(turnedUp(mesh, UpAxis::x).vertices, (Vertices{{0, 0, 1}, {-1, 0, 0}, {0, -1, 0}}));
  EXPECT_EQ(turnedUp(mesh, UpAxis::z).vertices, mesh.vertices);
}

TEST(TurnedUp, robotThatObeysTheUpAxis_hasItsMeshTurnedAndNoWarning) {
  const std::string file = daeTriangle("Y_UP");
  RobotDescription description;
  description.source = "test.urdf";
  description.urdf_xml = test::robotXml(test::linkXml("a", "<mesh filename='/a.dae'/>"));
  description.obeys_up_axis = true;
  SetupReport report;
  const RobotModel model = readRobots(
      {description}, [&](const std::string&) { return file; }, report);
  ASSERT_TRUE(report.errors.empty() && report.warnings.empty());
  const auto& mesh = std::get<TriangleMesh>(model.links[0].collisions[0].geometry);
  EXPECT_EQ(mesh.vertices[2], Eigen::Vector3d(0.0, 0.0, 1.0));
}

}  // namespace
}  // namespace collision_monitor
