// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/mesh_files/regular_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>

#include <cstring>
#include <fstream>
#include <functional>

#include "geometry/interruption.h"
#include "mesh_file.h"
#include "model/descriptor.h"
#include "support/scratch_folder.h"

namespace collision_monitor::test {
namespace {

std::string readFaultOf(const std::filesystem::path& path, std::uintmax_t most = kUsualFileSize) {
  return messageOf([&] { readRegularFile(path, most); });
}

TEST(RegularFile, bytesOfAnySize_areRead) {
  const ScratchFolder folder;
  const std::filesystem::path file = folder.path() / "a b.stl";
  for (const std::size_t size : {0u, 1u, (1u << 20) - 1, 1u << 20, (1u << 20) + 1, 3000000u}) {
    std::string bytes(size, '\0');
    for (std::size_t i = 0; i < size; ++i) {
      bytes[i] = static_cast<char>(i * 31 + i / 1000);
    }
    std::ofstream(file, std::ios::binary) << bytes;
    EXPECT_TRUE(readRegularFile(file) == bytes) << size;
    std::filesystem::remove(folder.path() / "link");
    std::filesystem::create_symlink(file, folder.path() / "link");
    EXPECT_TRUE(readRegularFile(folder.path() / "link") == bytes) << size;
  }
}

TEST(RegularFile, whatTheSystemMakesUp_isReadThoughItHasNoSize) {
  EXPECT_NE(readRegularFile("/proc/self/status").find("VmPeak"), std::string::npos);
}

TEST(RegularFile, pipeWithoutAWriter_isRefusedAtOnce) {
  const ScratchFolder folder;
  const std::filesystem::path pipe = folder.path() / "pipe.stl";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(readFaultOf(pipe), "'" + pipe.string() + "' is a pipe (FIFO), not a regular file");
}

TEST(RegularFile, foldersSocketsAndDevices_areRefused) {
  const ScratchFolder folder;
  const std::filesystem::path name = folder.path() / "socket";
  const Descriptor socket_end(socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::strncpy(address.sun_path, name.c_str(), sizeof address.sun_path - 1);
  ASSERT_EQ(bind(socket_end.get(), reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
  EXPECT_EQ(readFaultOf(name), "'" + name.string() + "' is a socket, not a regular file");
  EXPECT_EQ(readFaultOf(folder.path()),
            "'" + folder.path().string() + "' is a folder, not a regular file");
  EXPECT_EQ(readFaultOf("/dev/zero"), "'/dev/zero' is a device, not a regular file");
}

TEST(RegularFile, whatIsNotThere_isNamed) {
  EXPECT_EQ(readFaultOf("/no such folder/a.stl"),
            "'/no such folder/a.stl' cannot be read: No such file or directory");
}

TEST(RegularFile, moreThanTheLimit_isRefused) {
  const ScratchFolder folder;
  const std::filesystem::path file = folder.path() / "a";
  std::ofstream(file) << "12345";
  EXPECT_EQ(readRegularFile(file, 5), "12345");
  EXPECT_EQ(
      readFaultOf(file, 4),
      "'" + file.string() + "' is larger than the limit of 4 bytes (parameter files/max_size)");
  // Its size is said to be 0.
  EXPECT_EQ(readFaultOf("/proc/self/status", 10),
            "'/proc/self/status' is larger than the limit of 10 bytes (parameter files/max_size)");
}

TEST(RegularFile, isInterrupted) {
  const Interruptible interruptible([] { return false; });
  EXPECT_THROW(readRegularFile("/proc/self/status"), Interrupted);
}

}  // namespace
}  // namespace collision_monitor::test
