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
/// @throws std::runtime_error that names the file if it cannot be read.
std::string readFile(const std::filesystem::path& file);

/// Loads package://PACKAGE/FILE from root/PACKAGE/FILE, package://collision_monitor/ from this
/// checkout, and file:// and plain paths directly. A ROS node uses rospack for this.
ResourceLoader fileLoader(const std::filesystem::path& root);

/// Gives every mesh name one small triangle in the format of its extension, and refuses all other
/// names. For tests of robots whose meshes do not matter or are missing.
ResourceLoader oneTriangleLoader();

/// The folder with robots that are not part of this package: the environment variable
/// COLLISION_MONITOR_SHARED_DATA, or else ../shared/data beside the checkout. None if neither
/// exists; tests that need it are then skipped.
std::optional<std::filesystem::path> sharedDataDir();

/// The sentence for GTEST_SKIP if sharedDataDir() is empty.
extern const char* const kNoSharedData;

/// One URDF on disk.
struct RobotFile {
  std::string name;  ///< folder and file: "panda_moveit/panda.urdf"
  std::filesystem::path urdf;
  std::filesystem::path package_root;        ///< where package:// names are looked up
  std::vector<std::filesystem::path> srdfs;  ///< meant for this URDF
};

/// Every URDF below sharedDataDir()/robots and in this package's urdf/ folder, sorted by name.
std::vector<RobotFile> allRobotFiles();

/// The description as a node gets it, with the first SRDF if there is one.
RobotDescription describe(const RobotFile& robot);

/// Visits each mesh of allRobotFiles() that has vertices, as the node reads it, with the names of
/// its robot and link.
void forAllMeshes(
    const std::function<void(const TriangleMesh& mesh, const std::string& name)>& visit);

}  // namespace collision_monitor::test
