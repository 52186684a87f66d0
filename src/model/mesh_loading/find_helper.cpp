// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <dlfcn.h>
#include <unistd.h>

#include <stdexcept>
#include <vector>

#include "model/mesh_loading/helper_process.h"

namespace collision_monitor {
namespace {

namespace fs = std::filesystem;

/// Folders of the shared library with this code, or of the executable if it is linked in.
std::vector<fs::path> foldersOfThisCode() {
  std::vector<fs::path> folders;
  static const char here = 0;
  Dl_info info{};
  if (dladdr(&here, &info) != 0 && info.dli_fname != nullptr) {
    folders.push_back(fs::absolute(info.dli_fname).parent_path());
  }
  std::error_code fault;
  const fs::path executable = fs::read_symlink("/proc/self/exe", fault);
  if (!fault) {
    folders.push_back(executable.parent_path());
  }
  return folders;
}

}  // namespace

fs::path findHelper(const std::string& name) {
  const fs::path package = "collision_monitor";
  std::string looked;
  std::error_code ignored;
  for (const fs::path& folder : foldersOfThisCode()) {
    // From lib/, from lib/ARCHITECTURE/, and for an executable from lib/collision_monitor/.
    for (const fs::path& place :
         {folder / package / name, folder.parent_path() / package / name, folder / name}) {
      if (fs::is_regular_file(place, ignored) && access(place.c_str(), X_OK) == 0) {
        return place;
      }
      looked += (looked.empty() ? "'" : ", '") + place.string() + "'";
    }
  }
  throw HelperFault("the program '" + name + "' of this package is not at " + looked);
}

}  // namespace collision_monitor
