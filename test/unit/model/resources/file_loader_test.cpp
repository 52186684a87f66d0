// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/resources/file_loader.h"

#include <gtest/gtest.h>

#include <fstream>

#include "support/environment.h"
#include "support/scratch_folder.h"

namespace collision_monitor::test {
namespace {

namespace fs = std::filesystem;

void write(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file) << text;
}

std::string faultOfLoading(const std::string& uri, const FileSources& sources = {}) {
  try {
    makeFileLoader(sources)(uri);
  } catch (const std::exception& fault) {
    return fault.what();
  }
  return "no fault";
}

TEST(FileLoader, packages_areFoundByTheEnvironmentAndByRoots) {
  const ScratchFolder folder;
  const fs::path package = folder.path() / "share" / "my_arm";
  write(package / "package.xml", "<package><name>my_arm</name></package>");
  write(package / "my part.stl", "here");
  const EnvironmentVariable ament("AMENT_PREFIX_PATH", folder.path().c_str());
  EXPECT_EQ(makeFileLoader()("package://my_arm/my%20part.stl"), "here");
  EXPECT_EQ(makeFileLoader()("Package://my_arm/my part.stl"), "here");
  write(folder.path() / "mine" / "my_arm" / "my part.stl", "mine");
  FileSources sources;
  sources.package_roots = {folder.path() / "mine"};
  EXPECT_EQ(makeFileLoader(sources)("package://my_arm/my part.stl"), "mine");
}

TEST(FileLoader, packageThatIsNotThere_isLookedUpOnce_andTheErrorNamesThePlaces) {
  int searches = 0;
  FileSources sources;
  sources.find_package = [&](const std::string&) {
    ++searches;
    return "";
  };
  const ResourceLoader load = makeFileLoader(sources);
  EXPECT_THROW(load("package://my_arm/a.stl"), std::runtime_error);
  EXPECT_THROW(load("package://my_arm/b.stl"), std::runtime_error);
  EXPECT_EQ(searches, 1);
  EXPECT_EQ(faultOfLoading("package://my_arm/a.stl", sources),
            "package 'my_arm' is not found in the package roots, or where ROS_PACKAGE_PATH and "
            "AMENT_PREFIX_PATH lead to");
  sources.package_places = "below --package-root";
  EXPECT_EQ(faultOfLoading("package://my_arm/a.stl", sources),
            "package 'my_arm' is not found below --package-root");
}

TEST(FileLoader, fileThatIsMissingInARoot_isNamed) {
  const ScratchFolder folder;
  fs::create_directory(folder.path() / "my_arm");
  FileSources sources;
  sources.package_roots = {folder.path()};
  EXPECT_NE(faultOfLoading("package://my_arm/a.stl", sources)
                .find("'" + (folder.path() / "my_arm/a.stl").string() + "' cannot be read"),
            std::string::npos);
}

TEST(FileLoader, otherSchemes_areRefused_orLeftToOthers) {
  EXPECT_EQ(faultOfLoading("HTTP://localhost/a.stl"),
            "'HTTP://localhost/a.stl' has the scheme 'http'; files are read by package:// and "
            "file:// alone");
  FileSources sources;
  sources.load_other = [](const std::string& uri) { return "fetched " + uri; };
  EXPECT_EQ(makeFileLoader(sources)("http://localhost/a.stl"), "fetched http://localhost/a.stl");
  EXPECT_EQ(faultOfLoading("a.stl", sources), "'a.stl' is no absolute path and no URI");
}

TEST(FileLoader, filesLargerThanTheLimit_areRefused) {
  const ScratchFolder folder;
  write(folder.path() / "a.stl", "12345");
  FileSources sources;
  sources.max_size = 4;
  EXPECT_NE(faultOfLoading("file://" + (folder.path() / "a.stl").string(), sources)
                .find("larger than the limit of 4 bytes"),
            std::string::npos);
}

}  // namespace
}  // namespace collision_monitor::test
