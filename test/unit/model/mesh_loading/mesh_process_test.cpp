// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/mesh_loading/mesh_process.h"

#include <gtest/gtest.h>

#include <cstring>
#include <map>

#include "collision_monitor/model/urdf_reader.h"
#include "model/mesh_files/mesh_bytes.h"
#include "model/mesh_files/mesh_reader.h"
#include "support/robots/file_loader.h"
#include "unit/model/mesh_files/mesh_file.h"

namespace collision_monitor::test {
namespace {

const std::string kTriangleObj = "v 0 0 0\nv 1 0 0\nv 0 2 0\nf 1 2 3\n";

bool areSameBytes(const TriangleMesh& a, const TriangleMesh& b) { return toBytes(a) == toBytes(b); }

TEST(MeshProcess, everyMeshOfEveryRobot_isReadToTheLastBit) {
  MeshProcess process({});
  std::map<std::string, bool> seen;
  for (const RobotFile& robot : allRobotFiles()) {
    const ResourceLoader files = fileLoader(robot.package_root);
    const ResourceLoader look = [&](const std::string& uri) {
      const std::string bytes = files(uri);
      if (uri.find("package.xml") == std::string::npos && seen.emplace(uri, true).second) {
        EXPECT_TRUE(areSameBytes(process.read(bytes, uri), readMesh(bytes, uri))) << uri;
      }
      return bytes;
    };
    SetupReport report;
    MeshReading reading;
    reading.is_in_process = true;
    readRobots({describe(robot)}, look, report, reading);
  }
  if (seen.empty()) {
    GTEST_SKIP() << kNoSharedData;
  }
}

TEST(MeshProcess, faultsAreThoseOfTheReader) {
  MeshProcess process({});
  for (const auto& file : {std::pair(std::string(), "a.stl"), std::pair(kTriangleObj, "a.txt"),
                           std::pair(std::string("v 0 0\n"), "a.obj")}) {
    const std::string fault = messageOf([&] { readMesh(file.first, file.second); });
    EXPECT_NE(fault, "no exception");
    EXPECT_EQ(messageOf([&] { process.read(file.first, file.second); }), fault);
  }
}

TEST(MeshProcess, faultThatKillsIt_namesTheFile_othersAreReadAllTheSame) {
  MeshReading reading;
  reading.program = UNRULY_HELPER;
  MeshProcess process(reading);
  EXPECT_EQ(messageOf([&] { process.read("", "crash"); }),
            "crash: the process that reads it crashed (Segmentation fault, signal 11)");
  const TriangleMesh mesh = readMesh(kTriangleObj, "a.obj");
  EXPECT_TRUE(areSameBytes(process.read(toBytes(mesh), "echo"), mesh));
}

/// Of a helper that went wrong, indices might lead anywhere.
TEST(MeshProcess, answerThatIsNoMesh_isRefused) {
  const std::string good = toBytes(readMesh(kTriangleObj, "a.obj"));
  std::string wild = good;
  wild[wild.size() - 1] = 1;
  std::string many = good;
  std::memset(many.data(), 0xff, 8);
  for (const std::string& bytes : {std::string(), good.substr(1), good.substr(0, good.size() - 1),
                                   wild, many, std::string(8, '\0')}) {
    EXPECT_EQ(messageOf([&] { meshFromBytes(bytes); }),
              "the process that reads it answers what is no mesh");
  }
}

TEST(MeshProcess, polygonThatTakesForEver_meetsTheLimitOfTime) {
  std::string text;
  std::string face = "f";
  for (int i = 0; i < 60000; ++i) {
    text += "v " + std::to_string(i) + " " + std::to_string(i * 7919 % 1000) + " 0\n";
    face += " " + std::to_string(i + 1);
  }
  MeshReading reading;
  reading.seconds = 2.0;
  MeshProcess process(reading);
  EXPECT_EQ(messageOf([&] { process.read(text + face + "\n", "many.obj"); }),
            "many.obj: not read within the limit of 2 s (parameter files/mesh_time)");
  expectTheTriangle(process.read(kTriangleObj, "a.obj"));
}

TEST(MeshProcess, programThatIsNotThere_isTold_unlessMeshesAreReadInProcess) {
  MeshReading reading;
  reading.program = "/nowhere/read_meshes";
  EXPECT_NE(messageOf([&] {
              MeshProcess(reading).read(kTriangleObj, "a.obj");
            }).find("'/nowhere/read_meshes' cannot be started"),
            std::string::npos);
  reading.is_in_process = true;
  expectTheTriangle(MeshProcess(reading).read(kTriangleObj, "a.obj"));
}

}  // namespace
}  // namespace collision_monitor::test
