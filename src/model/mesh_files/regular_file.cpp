// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/mesh_files/regular_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <stdexcept>
#include <system_error>

#include "geometry/interruption.h"
#include "model/descriptor.h"
#include "model/place.h"

namespace collision_monitor {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& path, const std::string& fault) {
  throw std::runtime_error(quoted(path.string()) + " " + fault);
}

[[noreturn]] void refuseFor(const fs::path& path, int error) {
  refuse(path, "cannot be read: " + std::error_code(error, std::generic_category()).message());
}

const char* kindOf(mode_t mode) {
  switch (mode & S_IFMT) {
    case S_IFDIR:
      return "a folder";
    case S_IFIFO:
      return "a pipe (FIFO)";
    case S_IFSOCK:
      return "a socket";
    default:
      return "a device";
  }
}

void checkIsRegular(const fs::path& path, const struct stat& status) {
  if (!S_ISREG(status.st_mode)) {
    refuse(path, std::string("is ") + kindOf(status.st_mode) + ", not a regular file");
  }
}

[[noreturn]] void refuseSize(const fs::path& path, std::uintmax_t most) {
  refuse(path, "is larger than the limit of " + std::to_string(most) +
                   " bytes (parameter files/max_size)");
}

/// Opens the file. Refuses any other file that replaces it in the meantime.
Descriptor openRegular(const fs::path& path, struct stat& status) {
  // Checked before opening too: just opening some devices has effects.
  if (stat(path.c_str(), &status) != 0) {
    refuseFor(path, errno);
  }
  checkIsRegular(path, status);
  Descriptor file(open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY));
  if (file.get() < 0 || fstat(file.get(), &status) != 0) {
    refuseFor(path, errno);
  }
  checkIsRegular(path, status);
  return file;
}

}  // namespace

std::string readRegularFile(const fs::path& path, std::uintmax_t most) {
  struct stat status {};
  const Descriptor file = openRegular(path, status);
  if (static_cast<std::uintmax_t>(status.st_size) > most) {
    refuseSize(path, most);
  }
  constexpr std::size_t kPart = 1 << 20;
  std::string bytes;
  // Virtual files, such as those in /proc, report size 0. One extra byte detects the end without
  // another read.
  bytes.resize(static_cast<std::size_t>(status.st_size) + 1);
  for (std::size_t size = 0;;) {
    throwIfInterrupted();
    const std::size_t part = std::min(kPart, bytes.size() - size);
    const ssize_t count = read(file.get(), bytes.data() + size, part);
    if (count < 0 && errno != EINTR) {
      refuseFor(path, errno);
    }
    if (count == 0) {
      bytes.resize(size);
      return bytes;
    }
    size += static_cast<std::size_t>(std::max<ssize_t>(count, 0));
    if (size > most) {
      refuseSize(path, most);
    }
    if (size == bytes.size()) {
      bytes.resize(size + kPart);
    }
  }
}

}  // namespace collision_monitor
