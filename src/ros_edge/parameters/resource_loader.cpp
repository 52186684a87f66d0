// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/parameters/resource_loader.h"

#include <rospack/rospack.h>

#include <algorithm>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "ros_edge/parameters/downloads.h"

namespace collision_monitor {
namespace {

std::optional<unsigned> hexDigit(char c) {
  const std::string digits = "0123456789abcdef0123456789ABCDEF";
  const std::size_t place = digits.find(c);
  return place == std::string::npos ? std::nullopt
                                    : std::optional<unsigned>(static_cast<unsigned>(place % 16));
}

/// Replaces the escapes %XX of a URI (RFC 3986, 2.1). Any other % is a plain character.
std::string unescaped(const std::string& path) {
  std::string text;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (path[i] == '%' && i + 2 < path.size()) {
      const std::optional<unsigned> high = hexDigit(path[i + 1]);
      const std::optional<unsigned> low = hexDigit(path[i + 2]);
      if (high && low) {
        text += static_cast<char>(16 * *high + *low);
        i += 2;
        continue;
      }
    }
    text += path[i];
  }
  if (text.find('\0') != std::string::npos) {
    throw std::runtime_error("'" + path + "' holds %00, which no path does");
  }
  return text;
}

/// The path of a file URI, given without "file:": "///path", "//localhost/path" or "/path".
std::string pathOfFileUri(const std::string& rest) {
  if (rest.rfind("//", 0) != 0) {
    return unescaped(rest);
  }
  const std::size_t slash = std::min(rest.find('/', 2), rest.size());
  const std::string computer = rest.substr(2, slash - 2);
  if (!computer.empty() && computer != "localhost" && computer != "127.0.0.1") {
    throw std::runtime_error("'file:" + rest + "' names the computer '" + computer +
                             "'; a file of this one is file:///PATH");
  }
  return unescaped(rest.substr(slash));
}

using Folders = std::map<std::string, std::string>;  ///< package folders by name; "": not found

/// "" if there is none. As ros::package::getPath, but without its lines on stderr.
std::string findPackage(const std::string& name) {
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

/// Looks each package up once.
std::string packageFolder(const std::string& name, Folders& folders) {
  const auto [place, is_new] = folders.try_emplace(name);
  if (is_new && !name.empty()) {
    place->second = findPackage(name);
  }
  if (place->second.empty()) {
    throw std::runtime_error("package '" + name + "' is not found where ROS_PACKAGE_PATH leads to");
  }
  return place->second;
}

/// The path of a package URI, given without "package://".
std::string pathInPackage(const std::string& rest, Folders& folders) {
  const std::size_t slash = std::min(rest.find('/'), rest.size());
  if (slash == 0) {
    throw std::runtime_error("'package://" + rest + "' has a slash too many before the package");
  }
  return packageFolder(rest.substr(0, slash), folders) + unescaped(rest.substr(slash));
}

/// In lower case, because schemes ignore case.
std::string schemeOf(const std::string& uri) {
  std::string scheme = uri.substr(0, uri.find(':'));
  std::transform(scheme.begin(), scheme.end(), scheme.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return scheme;
}

/// Loads files for one set-up.
class Loader {
 public:
  explicit Loader(const LoadRules& rules) : rules_(rules), downloads_(rules) {}

  std::string load(const std::string& uri) {
    if (uri.rfind('/', 0) == 0) {
      return readRegularFile(uri, rules_.max_size);
    }
    if (uri.find(':') == std::string::npos) {
      throw std::runtime_error("'" + uri + "' is no absolute path and no URI");
    }
    const std::string scheme = schemeOf(uri);
    const std::string rest = uri.substr(scheme.size() + 1);
    if (scheme == "file") {
      return readRegularFile(pathOfFileUri(rest), rules_.max_size);
    }
    if (scheme == "package" && rest.rfind("//", 0) != 0) {
      throw std::runtime_error("'" + uri + "' has fewer slashes than package://PACKAGE/PATH");
    }
    if (scheme == "package") {
      return readRegularFile(pathInPackage(rest.substr(2), folders_), rules_.max_size);
    }
    if (std::find(rules_.schemes.begin(), rules_.schemes.end(), scheme) == rules_.schemes.end()) {
      throw std::runtime_error(
          "'" + uri + "' has the scheme '" + scheme +
          "', which only the parameter files/schemes, or --scheme of a program, can allow");
    }
    return downloads_.load(uri);
  }

 private:
  LoadRules rules_;
  Folders folders_;
  Downloads downloads_;
};

}  // namespace

ResourceLoader makeResourceLoader(const LoadRules& rules) {
  return [loader = std::make_shared<Loader>(rules)](const std::string& uri) {
    return loader->load(uri);
  };
}

}  // namespace collision_monitor
