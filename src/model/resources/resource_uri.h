// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace collision_monitor {

/// What stands before the first colon, in lower case, because schemes ignore case.
std::string schemeOf(const std::string& uri);

/// Replaces the escapes %XX of a URI. Any other % is a plain character.
/// @throws std::runtime_error for %00
/// Source: RFC 3986, section 2.1.
std::string unescaped(const std::string& path);

/// The path of a file URI, given without "file:": "///path", "//localhost/path" or "/path".
/// @throws std::runtime_error if it names another computer, or for %00
std::string pathOfFileUri(const std::string& rest);

/// A package URI in two parts.
struct PackagePath {
  std::string package;
  std::string path;  ///< below the package's folder, without escapes: "/meshes/a.stl" or ""
};

/// @pre the scheme is "package"
/// @throws std::runtime_error if it has too few slashes, or one too many, or for %00
PackagePath splitPackageUri(const std::string& uri);

}  // namespace collision_monitor
