// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/parameters/resource_loader.h"

#include <rospack/rospack.h>

#include <algorithm>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <vector>

#include "model/resources/file_loader.h"
#include "model/resources/resource_uri.h"
#include "ros_edge/parameters/downloads.h"

namespace collision_monitor {
namespace {

/// "" if there is none. As ros::package::getPath, but without its lines on stderr.
std::string askRospack(const std::string& name) {
  static std::mutex mutex;  // rospack is not safe for several threads
  const std::lock_guard<std::mutex> lock(mutex);
  rospack::Rospack packages;
  packages.setQuiet(true);
  std::vector<std::string> search_path;
  std::string path;
  if (packages.getSearchPathFromEnv(search_path)) {
    packages.crawl(search_path, false);
    packages.find(name, path);
  }
  return path;
}

/// Fetches what the rules allow.
ResourceLoader makeDownloader(const LoadRules& rules) {
  return [rules, downloads = std::make_shared<Downloads>(rules)](const std::string& uri) {
    const std::string scheme = schemeOf(uri);
    if (std::find(rules.schemes.begin(), rules.schemes.end(), scheme) == rules.schemes.end()) {
      throw std::runtime_error(
          "'" + uri + "' has the scheme '" + scheme +
          "', which only the parameter files/schemes, or --scheme of a program, can allow");
    }
    return downloads->load(uri);
  };
}

}  // namespace

ResourceLoader makeResourceLoader(const LoadRules& rules) {
  FileSources sources;
  sources.package_roots = rules.package_roots;
  sources.find_package = askRospack;
  sources.package_places = rules.package_places;
  sources.load_other = makeDownloader(rules);
  sources.max_size = rules.max_size;
  return makeFileLoader(sources);
}

}  // namespace collision_monitor
