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

constexpr std::string_view kWhitespace = " \t\r\n";

/// Of ASCII letters alone. Some exporters write all words in capitals.
std::string inSmallLetters(std::string_view text) {
  std::string small(text);
  std::transform(small.begin(), small.end(), small.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return small;
}

/// A header that says "solid" proves nothing: exporters write it into binary files
/// too. Text has no control bytes, and 512 bytes of triangles always do.
bool isText(std::string_view bytes) {
  const std::string_view start = bytes.substr(0, 512);
  return inSmallLetters(start.substr(0, 5)) == "solid" &&
         std::none_of(start.begin(), start.end(), [](char c) { return c >= 0 && c < '\t'; });
}

/// Without what editors put before the first word: blanks and a byte order mark.
std::string_view trimmed(std::string_view bytes) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (bytes.substr(0, kByteOrderMark.size()) == kByteOrderMark) {
    bytes.remove_prefix(kByteOrderMark.size());
  }
  bytes.remove_prefix(std::min(bytes.find_first_not_of(kWhitespace), bytes.size()));
  return bytes;
}

struct WordCounts {
  std::size_t vertices{0};
  std::size_t facets{0};
  std::size_t solids{0};
};

/// Names stand behind "solid" and "endsolid" up to the end of the line, and may be any words.
WordCounts countWords(std::string_view text) {
  WordCounts counts;
  for (std::size_t begin = 0; (begin = text.find_first_not_of(kWhitespace, begin)) != text.npos;) {
    std::size_t end = std::min(text.find_first_of(kWhitespace, begin), text.size());
    const std::string_view word = text.substr(begin, end - begin);
    counts.vertices += word == "vertex" ? 1 : 0;
    counts.facets += word == "endfacet" ? 1 : 0;
    counts.solids += word == "endsolid" ? 1 : 0;
    if (word == "solid" || word == "endsolid") {
      end = std::min(text.find_first_of("\r\n", end), text.size());
    }
    begin = end;
  }
  return counts;
}

/// Nothing but the words counts: numbers are the same in small letters, and names are not kept.
std::string completeText(std::string text) {
  const WordCounts counts = countWords(text);
  if (counts.vertices != 3 * counts.facets || counts.solids == 0) {
    throw std::runtime_error(
        "the ASCII STL is cut short or malformed: it needs three vertices "
        "for every endfacet, and endsolid at its end");
  }
  return text;
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
  if (isText(trimmed(bytes))) {
    return completeText(inSmallLetters(trimmed(bytes)));
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
