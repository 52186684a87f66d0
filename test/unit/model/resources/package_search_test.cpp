// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/resources/package_search.h"

#include <gtest/gtest.h>

#include <fstream>

#include "support/environment.h"
#include "support/scratch_folder.h"

namespace collision_monitor::test {
namespace {

namespace fs = std::filesystem;

void makePackage(const fs::path& folder, const std::string& name) {
  fs::create_directories(folder / "meshes");
  std::ofstream(folder / "package.xml") << "<package><name>" << name << "</name></package>";
  std::ofstream(folder / "meshes" / "a.stl") << "here";
}

void mark(const fs::path& folder, const char* marker) { std::ofstream(folder / marker) << ""; }

std::string findWith(const std::string& ros_path, const std::string& ament_path,
                     const std::string& name) {
  const EnvironmentVariable ros("ROS_PACKAGE_PATH", ros_path.c_str());
  const EnvironmentVariable ament("AMENT_PREFIX_PATH", ament_path.c_str());
  return findPackage(name);
}

TEST(FindPackage, rosPackagePath_isSearchedBelowItsFolders_inOrder) {
  const ScratchFolder folder;
  const fs::path first = folder.path() / "first";
  const fs::path second = folder.path() / "second";
  makePackage(first / "stack" / "checkout", "arm");
  makePackage(second / "arm", "arm");
  makePackage(second / "hand", "hand");
  const std::string both = first.string() + "::" + second.string();
  EXPECT_EQ(findWith(both, "", "arm"), first / "stack" / "checkout");
  EXPECT_EQ(findWith(both, "", "hand"), second / "hand");
  EXPECT_EQ(findWith((second / "hand").string(), "", "hand"), second / "hand");
  EXPECT_EQ(findWith(both, "", "checkout"), "");
  EXPECT_EQ(findWith("", "", "arm"), "");
  EXPECT_EQ(findWith("/nowhere", "/nowhere", "arm"), "");
}

TEST(FindPackage, markersAndPackages_endTheSearch) {
  const ScratchFolder folder;
  for (const char* marker : {"CATKIN_IGNORE", "AMENT_IGNORE", "COLCON_IGNORE"}) {
    const fs::path marked = folder.path() / (std::string("with_") + marker);
    makePackage(marked / "below" / "arm", "arm");
    mark(marked, marker);
  }
  makePackage(folder.path() / "hand", "hand");
  makePackage(folder.path() / "hand" / "arm", "arm");
  makePackage(folder.path() / ".hidden" / "arm", "arm");
  EXPECT_EQ(findWith(folder.path().string(), "", "arm"), "");
  EXPECT_EQ(findWith(folder.path().string(), "", "hand"), folder.path() / "hand");
}

TEST(FindPackage, foldersInACircle_areLookedAtOnce) {
  const ScratchFolder folder;
  makePackage(folder.path() / "z" / "arm", "arm");
  fs::create_directory_symlink(folder.path(), folder.path() / "a_circle");
  EXPECT_EQ(fs::canonical(findWith(folder.path().string(), "", "arm")),
            fs::canonical(folder.path() / "z" / "arm"));
}

TEST(FindPackage, amentPrefixPath_isLookedAtAfterIt) {
  const ScratchFolder folder;
  const fs::path prefix = folder.path() / "install";
  makePackage(prefix / "share" / "arm", "arm");
  makePackage(folder.path() / "source" / "arm", "arm");
  EXPECT_EQ(findWith("", prefix.string(), "arm"), prefix / "share" / "arm");
  EXPECT_EQ(findWith((folder.path() / "source").string(), prefix.string(), "arm"),
            folder.path() / "source" / "arm");
}

TEST(FindInRoots, aRoot_isAPackageOrHoldsSome_andTheFileThatExistsWins) {
  const ScratchFolder folder;
  makePackage(folder.path() / "checkout", "arm");
  makePackage(folder.path() / "packages" / "arm", "arm");
  std::ofstream(folder.path() / "packages" / "arm" / "b.stl") << "here";
  const std::vector<fs::path> roots{folder.path() / "checkout", folder.path() / "packages"};
  EXPECT_EQ(findInRoots("arm", "/meshes/a.stl", roots), roots[0] / "meshes/a.stl");
  EXPECT_EQ(findInRoots("arm", "/b.stl", roots), roots[1] / "arm" / "b.stl");
  EXPECT_EQ(findInRoots("arm", "/c.stl", roots), roots[0] / "c.stl") << "where it is missing";
  EXPECT_EQ(findInRoots("hand", "/meshes/a.stl", roots), std::nullopt);
}

}  // namespace
}  // namespace collision_monitor::test
