// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "output_files.h"

#include <gtest/gtest.h>

#include <fstream>

#include "support/robots/file_loader.h"
#include "support/scratch_folder.h"

namespace collision_monitor::fit_tool {
namespace {

namespace fs = std::filesystem;

std::size_t filesIn(const fs::path& folder) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

void write(const fs::path& file, const std::string& text) { std::ofstream(file) << text; }

TEST(OutputFiles, areWrittenWhole_andReplaceOldOnes) {
  const test::ScratchFolder scratch;
  write(scratch.path() / "a", "old and longer than the new one");
  writeFiles({{scratch.path() / "a", "new", true}, {scratch.path() / "b", ""}});
  EXPECT_EQ(test::readFile(scratch.path() / "a"), "new");
  EXPECT_EQ(test::readFile(scratch.path() / "b"), "");
  EXPECT_EQ(filesIn(scratch.path()), 2U);
}

TEST(OutputFiles, ifOneCannotBeWritten_noneIsChanged) {
  const test::ScratchFolder scratch;
  write(scratch.path() / "a", "old");
  const fs::path nowhere = scratch.path() / "missing" / "b";
  try {
    writeFiles({{scratch.path() / "a", "new", true}, {nowhere, "text"}});
    FAIL() << "a file in a folder that is not there was written";
  } catch (const std::runtime_error& fault) {
    EXPECT_NE(std::string(fault.what()).find(nowhere.string()), std::string::npos);
    EXPECT_NE(std::string(fault.what()).find("No such file"), std::string::npos) << fault.what();
  }
  EXPECT_EQ(test::readFile(scratch.path() / "a"), "old");
  EXPECT_EQ(filesIn(scratch.path()), 1U);
}

TEST(OutputFiles, whatIsThere_isReplacedOnlyIfItMayBe) {
  const test::ScratchFolder scratch;
  write(scratch.path() / "a", "old");
  SetupReport report;
  checkWritable("option --yaml", {scratch.path() / "a"}, report);
  ASSERT_EQ(report.errors.size(), 1U);
  EXPECT_NE(report.errors[0].found.find("it is there already"), std::string::npos);
  EXPECT_NE(report.errors[0].accepted.find("--force"), std::string::npos);
  EXPECT_THROW(writeFiles({{scratch.path() / "b", "new"}, {scratch.path() / "a", "new"}}),
               std::runtime_error);
  EXPECT_EQ(test::readFile(scratch.path() / "a"), "old");
  EXPECT_EQ(filesIn(scratch.path()), 1U);
  checkWritable("option --yaml", {scratch.path() / "a", "", true}, report);
  EXPECT_EQ(report.errors.size(), 1U);
}

TEST(OutputFiles, aLinkStaysALink_andLeadsToTheFile) {
  const test::ScratchFolder scratch;
  write(scratch.path() / "real", "old");
  fs::create_symlink("real", scratch.path() / "link");
  fs::create_symlink("new", scratch.path() / "link_to_nothing");
  writeFiles({{scratch.path() / "link", "new", true}, {scratch.path() / "link_to_nothing", "x"}});
  EXPECT_TRUE(fs::is_symlink(scratch.path() / "link"));
  EXPECT_EQ(test::readFile(scratch.path() / "real"), "new");
  EXPECT_TRUE(fs::is_symlink(scratch.path() / "link_to_nothing"));
  EXPECT_EQ(test::readFile(scratch.path() / "new"), "x");
}

TEST(OutputFiles, keepTheModeOfTheFileThatTheyReplace) {
  const test::ScratchFolder scratch;
  const fs::path file = scratch.path() / "a";
  write(file, "old");
  constexpr fs::perms kMode = fs::perms::owner_read | fs::perms::owner_write |
                              fs::perms::group_read | fs::perms::others_exec;
  fs::permissions(file, kMode);
  writeFiles({{file, "new", true}});
  EXPECT_EQ(test::readFile(file), "new");
  EXPECT_EQ(fs::status(file).permissions(), kMode);
}

TEST(CheckWritable, leavesNothing_andNamesTheFault) {
  const test::ScratchFolder scratch;
  SetupReport report;
  checkWritable("option --yaml", {scratch.path() / "a"}, report);
  EXPECT_TRUE(report.errors.empty());
  EXPECT_EQ(filesIn(scratch.path()), 0U);
  checkWritable("option --yaml", {scratch.path()}, report);
  checkWritable("option --html", {scratch.path() / "missing/a"}, report);
  checkWritable("option --urdf", {"/dev/null", "", true}, report);
  ASSERT_EQ(report.errors.size(), 3U);
  EXPECT_NE(report.errors[0].found.find("it is a folder"), std::string::npos);
  EXPECT_NE(report.errors[1].found.find("No such file"), std::string::npos);
  EXPECT_EQ(report.errors[1].where, "option --html");
  EXPECT_NE(report.errors[2].found.find("no plain file"), std::string::npos);
}

}  // namespace
}  // namespace collision_monitor::fit_tool
