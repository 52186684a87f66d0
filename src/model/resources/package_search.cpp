// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/resources/package_search.h"

#include <tinyxml2.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <sstream>
#include <stdexcept>

#include "model/mesh_files/regular_file.h"

namespace collision_monitor {
namespace {

namespace fs = std::filesystem;

/// No faults: what cannot be read is not there.
bool isThere(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

/// The parts of a variable like PATH; none if it is not set.
std::vector<fs::path> foldersIn(const char* variable) {
  std::vector<fs::path> folders;
  const char* value = std::getenv(variable);
  std::istringstream text(value == nullptr ? "" : value);
  for (std::string folder; std::getline(text, folder, ':');) {
    if (!folder.empty()) {
      folders.emplace_back(folder);
    }
  }
  return folders;
}

bool isHidden(const fs::path& folder) { return folder.filename().string().rfind('.', 0) == 0; }

/// Folders in a folder whose packages are looked for, the last name first.
std::vector<fs::path> foldersToSearch(const fs::path& folder) {
  std::vector<fs::path> found;
  for (const char* marker :
       {"CATKIN_IGNORE", "AMENT_IGNORE", "COLCON_IGNORE", "rospack_nosubdirs"}) {
    if (isThere(folder / marker)) {
      return found;
    }
  }
  std::error_code fault;
  fs::directory_iterator entry(folder, fs::directory_options::skip_permission_denied, fault);
  for (; !fault && entry != fs::directory_iterator(); entry.increment(fault)) {
    std::error_code ignored;
    if (entry->is_directory(ignored) && !isHidden(entry->path())) {
      found.push_back(entry->path());
    }
  }
  std::sort(found.rbegin(), found.rend());
  return found;
}

/// @return "" if there is none
std::string findBelow(const fs::path& start, const std::string& name) {
  std::set<fs::path> seen;  // links may lead in circles
  std::vector<fs::path> waiting{start};
  while (!waiting.empty()) {
    const fs::path folder = waiting.back();
    waiting.pop_back();
    std::error_code fault;
    const fs::path real = fs::canonical(folder, fault);
    if (fault || !seen.insert(real).second) {
      continue;
    }
    if (!isThere(folder / "package.xml")) {
      const std::vector<fs::path> below = foldersToSearch(folder);
      waiting.insert(waiting.end(), below.begin(), below.end());
    } else if (!isThere(folder / "CATKIN_IGNORE") && isPackage(folder, name)) {
      return folder.string();
    }
  }
  return "";
}

}  // namespace

bool isPackage(const fs::path& folder, const std::string& name) try {
  tinyxml2::XMLDocument document;
  if (document.Parse(readRegularFile(folder / "package.xml").c_str()) != tinyxml2::XML_SUCCESS ||
      document.RootElement() == nullptr) {
    return false;
  }
  const tinyxml2::XMLElement* element = document.RootElement()->FirstChildElement("name");
  return element != nullptr && element->GetText() != nullptr && element->GetText() == name;
} catch (const std::runtime_error&) {
  return false;  // no such file
}

std::string findPackage(const std::string& name) {
  for (const fs::path& folder : foldersIn("ROS_PACKAGE_PATH")) {
    std::string found = findBelow(folder, name);
    if (!found.empty()) {
      return found;
    }
  }
  for (const fs::path& prefix : foldersIn("AMENT_PREFIX_PATH")) {
    if (isThere(prefix / "share" / name / "package.xml")) {
      return (prefix / "share" / name).string();
    }
  }
  return "";
}

std::optional<fs::path> findInRoots(const std::string& package, const std::string& path,
                                    const std::vector<fs::path>& package_roots) {
  std::optional<fs::path> missing;
  for (const fs::path& root : package_roots) {
    const bool is_it = isPackage(root, package);
    const fs::path file = (is_it ? root : root / package).string() + path;
    if (isThere(file)) {
      return file;
    }
    if (!missing && (is_it || isThere(root / package))) {
      missing = file;
    }
  }
  return missing;
}

}  // namespace collision_monitor
