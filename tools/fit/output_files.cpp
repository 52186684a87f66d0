// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "output_files.h"

#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <stdexcept>
#include <system_error>

namespace collision_monitor::fit_tool {
namespace {

namespace fs = std::filesystem;

/// Where the file really is, so that renaming does not replace a link to it.
fs::path targetOf(const fs::path& path) { return fs::weakly_canonical(fs::absolute(path)); }

/// Beside the file, for only there renaming is one step; of this process alone.
fs::path partOf(const fs::path& target) {
  return target.parent_path() /
         ("." + target.filename().string() + "." + std::to_string(getpid()) + ".part");
}

std::string reasonOf(int error) {
  return std::error_code(error, std::generic_category()).message();
}

void writePart(const fs::path& part, const std::string& text) {
  errno = 0;
  std::ofstream stream(part, std::ios::binary | std::ios::trunc);
  stream.write(text.data(), static_cast<std::streamsize>(text.size()));
  stream.close();
  if (!stream) {
    throw std::runtime_error(reasonOf(errno == 0 ? EIO : errno));
  }
}

/// Removes what was not renamed.
class PartFiles {
 public:
  PartFiles() = default;
  ~PartFiles() {
    for (const fs::path& part : parts_) {
      std::error_code ignored;
      fs::remove(part, ignored);
    }
  }
  PartFiles(const PartFiles&) = delete;
  PartFiles& operator=(const PartFiles&) = delete;

  void write(const fs::path& target, const std::string& text) {
    parts_.push_back(partOf(target));
    writePart(parts_.back(), text);
  }

 private:
  std::vector<fs::path> parts_;
};

}  // namespace

void checkWritable(const std::string& option, const fs::path& path, SetupReport& report) {
  const auto refuse = [&](const std::string& reason) {
    report.errors.push_back({option, "'" + path.string() + "' cannot be written: " + reason,
                             "a file in a folder that exists and can be written"});
  };
  try {
    const fs::path target = targetOf(path);
    if (fs::is_directory(target)) {
      refuse("it is a folder");
    } else if (fs::exists(target) && !fs::is_regular_file(target)) {
      refuse("it is no plain file");
    } else if (fs::exists(target) && access(target.c_str(), W_OK) != 0) {
      refuse(reasonOf(errno));
    } else {
      PartFiles().write(target, "");
    }
  } catch (const std::exception& fault) {
    refuse(fault.what());
  }
}

void writeFiles(const std::vector<OutputFile>& files) {
  PartFiles parts;
  for (const OutputFile& file : files) {
    try {
      parts.write(targetOf(file.path), file.text);
    } catch (const std::exception& fault) {
      throw std::runtime_error("'" + file.path.string() + "' cannot be written: " + fault.what());
    }
  }
  for (const OutputFile& file : files) {
    const fs::path target = targetOf(file.path);
    fs::rename(partOf(target), target);
  }
}

}  // namespace collision_monitor::fit_tool
