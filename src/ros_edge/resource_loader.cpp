// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/ros_edge/resource_loader.h"

#include <resource_retriever/retriever.h>
#include <ros/package.h>

#include <algorithm>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>

namespace collision_monitor {
namespace {

enum class Percent { is_a_letter, begins_an_escape };

/// A path as a URL may hold it (RFC 3986, 2.1 and 2.3). curl refuses blanks and all that is not
/// ASCII.
std::string escaped(const std::string& path, Percent percent) {
  constexpr const char* kDigits = "0123456789ABCDEF";
  const std::string kept = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._~/";
  std::string text;
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    if (kept.find(c) != std::string::npos || (c == '%' && percent == Percent::begins_an_escape)) {
      text += c;
    } else {
      text += {'%', kDigits[byte / 16], kDigits[byte % 16]};
    }
  }
  return text;
}

using Folders = std::map<std::string, std::string>;  ///< of packages, by name; "": not found

/// Each package is looked for once: rospack writes lines of its own for one that it does not find.
std::string packageFolder(const std::string& name, Folders& folders) {
  const auto [place, is_new] = folders.try_emplace(name);
  if (is_new && !name.empty()) {
    place->second = ros::package::getPath(name);
  }
  if (place->second.empty()) {
    throw std::runtime_error("package '" + name + "' is not found where ROS_PACKAGE_PATH leads to");
  }
  return place->second;
}

/// curl knows neither plain paths nor packages.
std::string urlOf(const std::string& uri, Folders& folders) {
  const std::string file = "file://";
  const std::string package = "package://";
  if (uri.rfind('/', 0) == 0) {
    return file + escaped(uri, Percent::is_a_letter);
  }
  if (uri.rfind(file, 0) == 0) {
    return file + escaped(uri.substr(file.size()), Percent::begins_an_escape);
  }
  if (uri.rfind(package, 0) == 0) {
    const std::string path = uri.substr(package.size());
    const std::size_t slash = std::min(path.find('/'), path.size());
    return file + escaped(packageFolder(path.substr(0, slash), folders), Percent::is_a_letter) +
           escaped(path.substr(slash), Percent::begins_an_escape);
  }
  if (uri.find(':') == std::string::npos) {
    // curl would take its first folder for a computer and ask the network for it.
    throw std::runtime_error("'" + uri + "' is no absolute path and no URI");
  }
  return uri;
}

}  // namespace

ResourceLoader makeResourceLoader() {
  auto retriever = std::make_shared<resource_retriever::Retriever>();
  return [retriever, folders = Folders()](const std::string& uri) mutable {
    const resource_retriever::MemoryResource resource = retriever->get(urlOf(uri, folders));
    return std::string(resource.data.get(), resource.data.get() + resource.size);
  };
}

}  // namespace collision_monitor
