// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "collision_monitor/model/urdf_reader.h"

namespace collision_monitor::test {

/// The bytes of a file.
/// @throws std::runtime_error that names the file when it cannot be read.
std::string readFile(const std::filesystem::path& file);

/// Loads package://PACKAGE/FILE from root/PACKAGE/FILE, file:// and plain paths
/// from where they say; package://collision_monitor/ from this checkout. What a ROS
/// node does with rospack, without ROS.
ResourceLoader fileLoader(const std::filesystem::path& root);

/// Gives every mesh name one small triangle in the format of its extension, and
/// refuses all else: for tests of robots whose meshes do not matter or are missing.
ResourceLoader oneTriangleLoader();

/// The folder with robots that are not part of this package: the environment
/// variable COLLISION_MONITOR_SHARED_DATA, else ../shared/data beside the
/// checkout. Nothing if there is none; tests that need it are then skipped.
std::optional<std::filesystem::path> sharedDataDir();

/// The sentence for GTEST_SKIP where sharedDataDir() holds nothing.
extern const char* const kNoSharedData;

/// One URDF on disk.
struct RobotFile {
  std::string name;  ///< folder and file: "panda_moveit/panda.urdf"
  std::filesystem::path urdf;
  std::filesystem::path package_root;        ///< where package:// names are looked up
  std::vector<std::filesystem::path> srdfs;  ///< meant for this URDF
};

/// Every URDF below sharedDataDir()/robots, and every one of this package's urdf/
/// folder, in the order of their names.
std::vector<RobotFile> allRobotFiles();

/// The description as a node would get it; the first SRDF if there are any.
RobotDescription describe(const RobotFile& robot);

/// Visits each mesh of allRobotFiles() that has vertices, as the node reads it; with the names of
/// its robot and link.
void forAllMeshes(
    const std::function<void(const TriangleMesh& mesh, const std::string& name)>& visit);

}  // namespace collision_monitor::test
