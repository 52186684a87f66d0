// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/stl_check.h"

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string_view>

namespace collision_monitor {
namespace {

// Source: the STL formats as 3D Systems published them (StereoLithography Interface
// Specification, 1989): 80 bytes of header, a little-endian count, 50 bytes a triangle.
constexpr std::size_t kHeaderSize = 84;
constexpr std::size_t kTriangleSize = 50;

/// A header that says "solid" proves nothing: exporters write it into binary files
/// too. Text has no control bytes, and 512 bytes of triangles always do.
bool isText(const std::string& bytes) {
  const std::size_t begin = bytes.find_first_not_of(" \t\r\n");
  if (begin == std::string::npos || bytes.compare(begin, 5, "solid") != 0) {
    return false;
  }
  const auto end =
      bytes.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(512, bytes.size()));
  return std::none_of(bytes.begin(), end, [](char c) { return c >= 0 && c < '\t'; });
}

std::size_t countWord(std::string_view text, std::string_view word) {
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != std::string_view::npos;
       at = text.find(word, at + word.size())) {
    ++count;
  }
  return count;
}

std::size_t countOf(const std::string& bytes) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    count |= static_cast<std::size_t>(static_cast<unsigned char>(bytes[80 + i])) << (8 * i);
  }
  return count;
}

}  // namespace

std::string completeStl(const std::string& bytes) {
  if (isText(bytes)) {
    const std::size_t facets = countWord(bytes, "endfacet");
    if (countWord(bytes, "vertex") != 3 * facets || countWord(bytes, "endsolid") == 0) {
      throw std::runtime_error(
          "the ASCII STL is cut short or malformed: it needs three vertices "
          "for every endfacet, and endsolid at its end");
    }
    return bytes;
  }
  if (bytes.size() < kHeaderSize) {
    throw std::runtime_error("too short for an STL file: " + std::to_string(bytes.size()) +
                             " bytes");
  }
  const std::size_t count = countOf(bytes);
  const std::size_t present = (bytes.size() - kHeaderSize) / kTriangleSize;
  if (count > present) {
    throw std::runtime_error("the binary STL is cut short: it announces " + std::to_string(count) +
                             " triangles and holds " + std::to_string(present));
  }
  return bytes.substr(0, kHeaderSize + count * kTriangleSize);
}

}  // namespace collision_monitor
