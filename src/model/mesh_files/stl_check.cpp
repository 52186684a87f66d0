// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/mesh_files/stl_check.h"

#include <algorithm>
#include <stdexcept>
#include <string_view>

namespace collision_monitor {
namespace {

constexpr std::string_view kWhitespace = " \t\r\n";

/// Lowers ASCII letters only. Some exporters write all words in capitals.
std::string inSmallLetters(std::string_view text) {
  std::string small(text);
  std::transform(small.begin(), small.end(), small.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return small;
}

/// Without blanks and a byte order mark, which editors put before the first word.
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

/// A name follows "solid" and "endsolid" up to the end of the line. It may be any words.
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

}  // namespace

bool isTextStl(const std::string& bytes) {
  const std::string_view start = trimmed(bytes).substr(0, 512);
  return inSmallLetters(start.substr(0, 5)) == "solid" &&
         std::none_of(start.begin(), start.end(), [](char c) { return c >= 0 && c < '\t'; });
}

std::string completeTextStl(const std::string& bytes) {
  // Only the words matter: numbers do not change in lower case, and names are not kept.
  std::string text = inSmallLetters(trimmed(bytes));
  const WordCounts counts = countWords(text);
  if (counts.vertices != 3 * counts.facets || counts.solids == 0) {
    throw std::runtime_error(
        "the ASCII STL is cut short or malformed: it needs three vertices "
        "for every endfacet, and endsolid at its end");
  }
  return text;
}

}  // namespace collision_monitor
