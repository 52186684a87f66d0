// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace collision_monitor {

/// Whether `folder` has a package.xml with this name: a checkout may have any folder name.
bool isPackage(const std::filesystem::path& folder, const std::string& name);

/// The folder of a package, or "" if there is none. Looks at and below the folders of
/// ROS_PACKAGE_PATH in order, then at PREFIX/share/NAME for each prefix of AMENT_PREFIX_PATH. Needs
/// no ROS.
///
/// Limits: as rospack, looks neither below a package, nor where CATKIN_IGNORE, AMENT_IGNORE or
/// COLCON_IGNORE is, nor below rospack_nosubdirs, nor in hidden folders. Of several packages in one
/// folder of the path, the first by the order of names is taken.
std::string findPackage(const std::string& name);

/// The path of a file of `package` in the given folders, each a package or a folder of packages. A
/// folder where the file exists goes before one where it does not.
/// @param path "/meshes/a.stl"
/// @return nothing if no folder has the package
std::optional<std::filesystem::path> findInRoots(
    const std::string& package, const std::string& path,
    const std::vector<std::filesystem::path>& package_roots);

}  // namespace collision_monitor
