// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/ros_edge/resource_loader.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <string>

#include "support/scratch_folder.h"

namespace collision_monitor {
namespace {

void write(const std::filesystem::path& file, const std::string& text) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file) << text;
}

/// \u00fc in UTF-8, as a part may be called in German.
const std::string kOddName = "my part \xC3\xBC #1.stl";

TEST(ResourceLoader, paths_mayHoldBlanksAndAnyLetter) {
  const test::ScratchFolder folder;
  for (const std::string& name :
       {std::string("plain.stl"), kOddName, std::string("50% a%20b.stl")}) {
    const std::string path = (folder.path() / "odd folder" / name).string();
    write(path, name);
    EXPECT_EQ(makeResourceLoader()(path), name);
  }
}

TEST(ResourceLoader, fileUris_mayHoldEscapesOrTheLettersThemselves) {
  const test::ScratchFolder folder;
  write(folder.path() / kOddName, "here");
  const std::string start = "file://" + folder.path().string() + "/";
  EXPECT_EQ(makeResourceLoader()(start + kOddName), "here");
  EXPECT_EQ(makeResourceLoader()(start + "my%20part%20%C3%BC%20%231.stl"), "here");
}

TEST(ResourceLoader, packages_mayHoldThemToo) {
  const test::ScratchFolder folder;
  const std::filesystem::path package = folder.path() / "my workspace" / "odd_package";
  write(package / "package.xml", "<package><name>odd_package</name></package>");
  write(package / "meshes" / kOddName, "here");
  setenv("ROS_PACKAGE_PATH", package.parent_path().c_str(), 1);
  EXPECT_EQ(makeResourceLoader()("package://odd_package/meshes/" + kOddName), "here");
  EXPECT_EQ(makeResourceLoader()("package://odd_package/meshes/my%20part%20%C3%BC%20%231.stl"),
            "here");
}

TEST(ResourceLoader, whatIsNotThere_isNamed) {
  for (const auto& [uri, part] : {std::pair("package://no_such_package/a.stl", "'no_such_package'"),
                                  std::pair("package:///a.stl", "package ''"),
                                  std::pair("urdf/arm.urdf", "'urdf/arm.urdf' is no absolute path"),
                                  std::pair("/no such folder/a.stl", "no%20such%20folder")}) {
    try {
      makeResourceLoader()(uri);
      ADD_FAILURE() << uri;
    } catch (const std::exception& error) {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace collision_monitor
