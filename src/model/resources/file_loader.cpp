// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/resources/file_loader.h"

#include <map>
#include <memory>
#include <optional>
#include <stdexcept>

#include "model/resources/resource_uri.h"

namespace collision_monitor {
namespace {

/// Loads files for one set-up.
class FileLoader {
 public:
  explicit FileLoader(const FileSources& sources) : sources_(sources) {}

  std::string load(const std::string& uri) {
    if (uri.rfind('/', 0) == 0) {
      return read(uri);
    }
    if (uri.find(':') == std::string::npos) {
      throw std::runtime_error("'" + uri + "' is no absolute path and no URI");
    }
    const std::string scheme = schemeOf(uri);
    if (scheme == "file") {
      return read(pathOfFileUri(uri.substr(scheme.size() + 1)));
    }
    if (scheme == "package") {
      return read(placeOf(splitPackageUri(uri)));
    }
    if (!sources_.load_other) {
      throw std::runtime_error("'" + uri + "' has the scheme '" + scheme +
                               "'; files are read by package:// and file:// alone");
    }
    return sources_.load_other(uri);
  }

 private:
  std::string read(const std::filesystem::path& path) const {
    return readRegularFile(path, sources_.max_size);
  }

  std::filesystem::path placeOf(const PackagePath& file) {
    if (const auto place = findInRoots(file.package, file.path, sources_.package_roots)) {
      return *place;
    }
    const auto [folder, is_new] = folders_.try_emplace(file.package);
    if (is_new) {
      folder->second = sources_.find_package(file.package);
    }
    if (folder->second.empty()) {
      throw std::runtime_error("package '" + file.package + "' is not found " +
                               sources_.package_places);
    }
    return folder->second + file.path;
  }

  FileSources sources_;
  std::map<std::string, std::string> folders_;  ///< package folders by name; "": not found
};

}  // namespace

ResourceLoader makeFileLoader(const FileSources& sources) {
  return [loader = std::make_shared<FileLoader>(sources)](const std::string& uri) {
    return loader->load(uri);
  };
}

}  // namespace collision_monitor
