// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
// Robots and meshes as people publish them. What is asserted must hold for any robot; the numbers
// of a few known ones show that nothing is lost on the way.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "collision_monitor/model/kinematics.h"
#include "collision_monitor/model/pair_rules.h"
#include "model/mesh_files/mesh_reader.h"
#include "support/robots/file_loader.h"

namespace collision_monitor {
namespace {

namespace fs = std::filesystem;

/// Links parent first, names unique, axes unit, shapes finite: what all who use a model rely on.
void expectSoundModel(const RobotModel& model) {
  std::set<std::string> names;
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    const Link& link = model.links[i];
    EXPECT_TRUE(names.insert(link.name).second) << link.name;
    if (link.parent_joint) {
      EXPECT_LT(index(model.joint(*link.parent_joint).parent), i);
      EXPECT_EQ(index(model.joint(*link.parent_joint).child), i);
    }
    for (const CollisionElement& collision : link.collisions) {
      EXPECT_TRUE(isRigid(collision.link_from_geometry)) << link.name;
      if (const auto* mesh = std::get_if<TriangleMesh>(&collision.geometry)) {
        EXPECT_FALSE(mesh->triangles.empty()) << link.name;
        for (const auto& triangle : mesh->triangles) {
          EXPECT_LT(*std::max_element(triangle.begin(), triangle.end()), mesh->vertices.size());
        }
      }
    }
  }
  for (const Joint& joint : model.joints) {
    EXPECT_NEAR(joint.axis.norm(), 1.0, 1e-15) << joint.name;
    EXPECT_LE(joint.lower, joint.upper) << joint.name;
    EXPECT_LE(joint.first_variable, model.variable_count) << joint.name;
  }
  std::vector<Pose> world_from_link;
  placeLinks(model, defaultPositions(model), {Pose{}}, world_from_link);
  for (const Pose& pose : world_from_link) {
    EXPECT_TRUE(isRigid(pose, 1e-12));
  }
}

TEST(SharedRobots, everyRobot_isReadOrItsMissingMeshesAreNamed) {
  if (!test::sharedDataDir()) {
    GTEST_SKIP() << test::kNoSharedData;
  }
  std::size_t read_count = 0;
  for (const test::RobotFile& file : test::allRobotFiles()) {
    SCOPED_TRACE(file.name);
    SetupReport report;
    const RobotDescription description = test::describe(file);
    const RobotModel model = readRobots({description}, test::fileLoader(file.package_root), report);
    for (const Problem& problem : report.errors) {
      // Some copies come without files that upstream keeps elsewhere; nothing else may fail.
      EXPECT_NE(problem.found.find("cannot read file"), std::string::npos) << toString(problem);
    }
    if (!report.errors.empty()) {
      EXPECT_TRUE(model.links.empty());
      continue;
    }
    ++read_count;
    expectSoundModel(model);
    if (!description.srdf_xml.empty()) {
      const SrdfPairs srdf = readSrdf(description, RobotId{0}, model, report);
      EXPECT_TRUE(report.errors.empty());
      decideLinkPairs(model, {srdf});
    }
  }
  EXPECT_GT(read_count, 0u);
}

std::optional<RobotModel> readShared(const std::string& name) {
  for (const test::RobotFile& file : test::allRobotFiles()) {
    if (file.name == name) {
      SetupReport report;
      return readRobots({test::describe(file)}, test::fileLoader(file.package_root), report);
    }
  }
  return std::nullopt;
}

TEST(SharedRobots, capsulesThatUrdfdomDrops_areThere) {
  const auto model = readShared("odd_capsule_humanoid/humanoid.urdf");
  if (!model) {
    GTEST_SKIP() << test::kNoSharedData;
  }
  int capsules = 0;
  for (const Link& link : model->links) {
    for (const CollisionElement& collision : link.collisions) {
      capsules += std::holds_alternative<Capsule>(collision.geometry) ? 1 : 0;
    }
  }
  EXPECT_EQ(capsules, 16);
}

TEST(SharedRobots, pandaFingers_mimicOneAnother) {
  const auto model = readShared("panda_moveit/panda.urdf");
  if (!model) {
    GTEST_SKIP() << test::kNoSharedData;
  }
  EXPECT_EQ(model->joints.size(), 11u);
  EXPECT_EQ(model->variable_count, 8u);
}

/// The box around a mesh of the shared folder.
Eigen::Vector3d sizeOf(const fs::path& file) {
  const TriangleMesh mesh = readMesh(test::readFile(file), file.string());
  Eigen::Vector3d low = mesh.vertices.front();
  Eigen::Vector3d high = low;
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    low = low.cwiseMin(vertex);
    high = high.cwiseMax(vertex);
  }
  return high - low;
}

TEST(SharedMeshes, daeUnits_giveSizesInMetres) {
  const auto shared = test::sharedDataDir();
  if (!shared || !fs::exists(*shared / "meshes_misc")) {
    GTEST_SKIP() << test::kNoSharedData;
  }
  const fs::path folder = *shared / "meshes_misc";
  // A traffic cone in inches and the neck of a humanoid in centimetres.
  EXPECT_NEAR(sizeOf(folder / "bullet3/cone.dae").z(), 0.17, 1e-6);
  EXPECT_NEAR(sizeOf(folder / "unitree_ros/head_pitch_link.dae").z(), 0.1685, 1e-6);
}

TEST(SharedMeshes, everyMesh_isReadOrRefusedWithItsName) {
  const auto shared = test::sharedDataDir();
  if (!shared || !fs::exists(*shared / "meshes_misc")) {
    GTEST_SKIP() << test::kNoSharedData;
  }
  const std::set<std::string> formats{".stl", ".dae", ".obj", ".ply"};
  std::size_t read_count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(*shared / "meshes_misc")) {
    if (formats.count(entry.path().extension().string()) == 0) {
      continue;
    }
    try {
      const TriangleMesh mesh = readMesh(test::readFile(entry.path()), entry.path().string());
      EXPECT_FALSE(mesh.triangles.empty()) << entry.path();
      ++read_count;
    } catch (const std::runtime_error& error) {
      EXPECT_EQ(std::string(error.what()).rfind(entry.path().string() + ": ", 0), 0u)
          << error.what();
    }
  }
  EXPECT_GT(read_count, 0u);
}

}  // namespace
}  // namespace collision_monitor
