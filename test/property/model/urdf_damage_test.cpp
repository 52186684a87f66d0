// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
// Whatever is done to the bytes of a URDF, SRDF or mesh, the answer is a model or a problem,
// never a crash and never neither.
#include <gtest/gtest.h>

#include <random>

#include "collision_monitor/model/kinematics.h"
#include "collision_monitor/model/pair_rules.h"
#include "model/mesh_files/mesh_reader.h"
#include "support/robots/urdf_text.h"

namespace collision_monitor {
namespace {

constexpr unsigned kSeed = 20240718;

/// A robot that has something of everything.
std::string everything() {
  using test::jointXml;
  using test::linkXml;
  return test::robotXml(
      "<!-- a comment --><material name='m'><color rgba='1 0 0 1'/></material>\n" +
      linkXml("base", "<box size='0.1 0.2 0.3'/>", "<origin xyz='1 2 3' rpy='0.1 0.2 0.3'/>") +
      "\n" + linkXml("arm", "<cylinder radius='0.1' length='0.5'/>") + "\n" +
      linkXml("hand", "<capsule radius='0.05' length='0.2'/>") + "\n" +
      linkXml("tip", "<sphere radius='0.01'/>") + "\n" +
      linkXml("tool", "<mesh filename='/t.obj' scale='1 -1 0.5'/>") + "\n" +
      "<link name='empty'/>\n" +
      jointXml("j1", "revolute", "base", "arm",
               "<axis xyz='0 0 1'/><limit lower='-1' upper='1' velocity='2' effort='3'/>") +
      "\n" + jointXml("j2", "prismatic", "arm", "hand", "<limit lower='0' upper='0.1'/>") + "\n" +
      jointXml("j3", "prismatic", "hand", "tip",
               "<mimic joint='j2' multiplier='-1' offset='0.01'/>") +
      "\n" + jointXml("j4", "floating", "tip", "tool") + "\n" +
      jointXml("j5", "planar", "tool", "empty", "<axis xyz='0 1 0'/>") + "\n");
}

const std::map<std::string, std::string> kFiles{{"/t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"}};

std::string damaged(const std::string& text, std::mt19937& random) {
  std::string bytes = text;
  const auto somewhere = [&] { return random() % bytes.size(); };
  switch (random() % 4) {
    case 0:
      bytes.resize(somewhere());
      break;
    case 1:
      for (unsigned i = 0, count = 1 + random() % 8; i < count; ++i) {
        bytes[somewhere()] = static_cast<char>(random() % 256);
      }
      break;
    case 2: {
      const std::size_t at = somewhere();
      bytes.erase(at, 1 + random() % 20);
      break;
    }
    default: {
      const std::size_t from = somewhere();
      bytes.insert(somewhere(), bytes.substr(from, 1 + random() % 60));
    }
  }
  return bytes;
}

TEST(UrdfDamage, undamaged_isReadWithoutErrors) {
  EXPECT_EQ(test::readText(everything(), kFiles).errors(), std::vector<std::string>());
}

TEST(UrdfDamage, anyDamage_givesAModelOrProblems) {
  std::mt19937 random(kSeed);
  int accepted = 0;
  for (int round = 0; round < 4000; ++round) {
    const std::string xml = damaged(everything(), random);
    const test::ReadText read = test::readText(xml, kFiles);
    ASSERT_NE(read.report.errors.empty(), read.model.links.empty())
        << "seed " << kSeed << ", round " << round << ":\n"
        << xml;
    for (const Problem& problem : read.report.errors) {
      ASSERT_FALSE(problem.where.empty() || problem.found.empty() || problem.accepted.empty())
          << toString(problem);
    }
    if (!read.model.links.empty()) {
      ++accepted;
      std::vector<Pose> world_from_link;
      placeLinks(read.model, defaultPositions(read.model), {Pose{}}, world_from_link);
      for (const Pose& pose : world_from_link) {
        ASSERT_TRUE(isRigid(pose)) << "round " << round << ":\n" << xml;
      }
    }
  }
  // Both ways out were taken, so the test saw what it is about.
  EXPECT_GT(accepted, 40);
  EXPECT_LT(accepted, 3960);
}

TEST(UrdfDamage, damagedSrdf_givesPairsOrProblems) {
  std::mt19937 random(kSeed);
  RobotDescription description = test::describeText(everything());
  SetupReport urdf_report;
  const RobotModel model = readRobots({description}, test::textLoader(kFiles), urdf_report);
  const std::string srdf_xml = test::robotXml(
      "<disable_collisions link1='base' link2='tip' reason='Never'/>\n"
      "<enable_collisions link1='base' link2='arm'/>\n<disable_default_collisions link='hand'/>");
  for (int round = 0; round < 2000; ++round) {
    description.srdf_xml = damaged(srdf_xml, random);
    SetupReport report;
    const SrdfPairs srdf = readSrdf(description, RobotId{0}, model, report);
    // 5 links have geometry, so there are 10 pairs whatever the SRDF says.
    ASSERT_EQ(decideLinkPairs(model, {srdf}).size(), 10u) << description.srdf_xml;
  }
}

TEST(MeshDamage, damagedMeshes_areReadSoundOrRefused) {
  std::mt19937 random(kSeed);
  const std::pair<std::string, std::string> files[] = {
      {"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 1\nf 1 2 3\nf 1 2 4 3\n"},
      {"a.ply",
       "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
       "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
       "0 0 0\n1 0 0\n0 2 0\n3 0 1 2\n"},
      {"a.stl",
       "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 2 0\n"
       "endloop\nendfacet\nendsolid s\n"}};
  for (const auto& [name, bytes] : files) {
    for (int round = 0; round < 500; ++round) {
      const std::string content = damaged(bytes, random);
      try {
        const TriangleMesh mesh = readMesh(content, name);
        for (const Eigen::Vector3d& vertex : mesh.vertices) {
          ASSERT_TRUE(vertex.allFinite()) << content;
        }
        for (const auto& triangle : mesh.triangles) {
          for (const std::uint32_t corner : triangle) {
            ASSERT_LT(corner, mesh.vertices.size()) << content;
          }
        }
      } catch (const std::runtime_error& error) {
        ASSERT_EQ(std::string(error.what()).rfind(name + ": ", 0), 0u) << error.what();
      }
    }
  }
}

}  // namespace
}  // namespace collision_monitor
