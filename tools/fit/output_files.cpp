// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "output_files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>
#include <system_error>

namespace collision_monitor::fit_tool {
namespace {

namespace fs = std::filesystem;

const char* const kIsThere = "it is there already";

/// In the file's folder, because only there renaming is atomic. The name is unique to this process.
fs::path partOf(const fs::path& target) {
  return target.parent_path() /
         ("." + target.filename().string() + "." + std::to_string(getpid()) + ".part");
}

std::string reasonOf(int error) {
  return std::error_code(error, std::generic_category()).message();
}

[[noreturn]] void throwReason(int error) { throw std::runtime_error(reasonOf(error)); }

/// Closes the file that it opened.
class NewFile {
 public:
  explicit NewFile(const fs::path& path)
      : file_(open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666)) {
    if (file_ < 0) {
      throwReason(errno);
    }
  }
  ~NewFile() { close(file_); }
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;

  void write(const std::string& text) const {
    for (std::size_t done = 0; done < text.size();) {
      const ssize_t count = ::write(file_, text.data() + done, text.size() - done);
      if (count < 0 && errno != EINTR) {
        throwReason(errno);
      }
      done += count < 0 ? 0 : static_cast<std::size_t>(count);
    }
  }
  /// If the owner must not be changed, the file belongs to the writer; this is no fault.
  void resemble(const struct stat& former) const {
    if (fchown(file_, former.st_uid, former.st_gid) != 0 && errno != EPERM) {
      throwReason(errno);
    }
    if (fchmod(file_, former.st_mode & ALLPERMS) != 0) {
      throwReason(errno);
    }
  }
  /// Flushes before renaming: after a power failure, the name must not refer to an empty file.
  void keep() const {
    if (fsync(file_) != 0) {
      throwReason(errno);
    }
  }

 private:
  int file_;
};

/// Removes files that were not renamed.
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
    const NewFile part(partOf(target));
    parts_.push_back(partOf(target));
    struct stat former {};
    if (stat(target.c_str(), &former) == 0) {
      part.resemble(former);  // before the text is written, which may be private
    }
    part.write(text);
    part.keep();
  }

 private:
  std::vector<fs::path> parts_;
};

}  // namespace

fs::path targetOf(const fs::path& path) {
  constexpr int kMostLinks = 40;  // Linux's limit
  fs::path target = fs::absolute(path);
  for (int i = 0; i < kMostLinks && fs::is_symlink(fs::symlink_status(target)); ++i) {
    target = target.parent_path() / fs::read_symlink(target);
  }
  return fs::weakly_canonical(target);
}

void checkWritable(const std::string& option, const OutputFile& file, SetupReport& report) {
  const auto refuse = [&](const std::string& reason) {
    report.errors.push_back({option, "'" + file.path.string() + "' cannot be written: " + reason,
                             reason == kIsThere
                                 ? "the name of a new file, or --force to replace it"
                                 : "a file in a folder that exists and can be written"});
  };
  try {
    const fs::path target = targetOf(file.path);
    if (fs::is_directory(target)) {
      refuse("it is a folder");
    } else if (fs::exists(target) && !fs::is_regular_file(target)) {
      refuse("it is no plain file");
    } else if (fs::exists(target) && !file.may_replace) {
      refuse(kIsThere);
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
      const fs::path target = targetOf(file.path);
      // The file may have appeared while the text was made.
      if (fs::exists(target) && !file.may_replace) {
        throw std::runtime_error(kIsThere);
      }
      parts.write(target, file.text);
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
