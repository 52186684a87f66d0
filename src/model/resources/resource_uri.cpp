// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/resources/resource_uri.h"

#include <algorithm>
#include <optional>
#include <stdexcept>

namespace collision_monitor {
namespace {

std::optional<unsigned> hexDigit(char c) {
  const std::string digits = "0123456789abcdef0123456789ABCDEF";
  const std::size_t place = digits.find(c);
  return place == std::string::npos ? std::nullopt
                                    : std::optional<unsigned>(static_cast<unsigned>(place % 16));
}

}  // namespace

std::string schemeOf(const std::string& uri) {
  std::string scheme = uri.substr(0, uri.find(':'));
  std::transform(scheme.begin(), scheme.end(), scheme.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return scheme;
}

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

PackagePath splitPackageUri(const std::string& uri) {
  const std::string rest = uri.substr(std::min(uri.find(':') + 1, uri.size()));
  if (rest.rfind("//", 0) != 0) {
    throw std::runtime_error("'" + uri + "' has fewer slashes than package://PACKAGE/PATH");
  }
  const std::size_t slash = std::min(rest.find('/', 2), rest.size());
  if (slash == 2) {
    throw std::runtime_error("'" + uri + "' has a slash too many before the package");
  }
  return {rest.substr(2, slash - 2), unescaped(rest.substr(slash))};
}

}  // namespace collision_monitor
