// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/mesh_files/obj_text.h"

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "model/number_text.h"

namespace collision_monitor {
namespace {

constexpr std::string_view kBlanks = " \t\r\f\v";

/// Whether assimp sees a number here. It does not see one that begins with a point.
bool looksLikeNumber(std::string_view word) {
  return word.find_first_not_of("0123456789+-.,eEnaifNAIF") == std::string_view::npos;
}

/// Takes "v x y z" with an optional weight as a fourth number. More numbers are a color.
void appendVertex(const std::vector<std::string_view>& words, std::size_t line, std::string& text) {
  const std::size_t count = words.size() == 5 ? 4 : 3;
  const auto first = words.begin() + 1;
  const auto last = first + static_cast<std::ptrdiff_t>(std::min(count, words.size() - 1));
  if (words.size() < 4 || !std::all_of(first, last, looksLikeNumber)) {
    throw std::runtime_error("line " + std::to_string(line) +
                             ": a vertex needs three numbers, as 'v 0.1 0.2 0.3'");
  }
  text += 'v';
  for (auto word = first; word != last; ++word) {
    text += word->front() == '.' ? " 0" : " ";
    text += *word;
  }
}

/// Takes the next line without its end and comments, joined with those that a backslash continues.
std::string takeLine(std::string_view& rest, std::size_t& line) {
  std::string text;
  for (bool goes_on = true; goes_on && !rest.empty();) {
    const std::size_t end = std::min(rest.find_first_of("\r\n"), rest.size());
    std::string_view part = rest.substr(0, end);
    const std::size_t width = rest.substr(end, 2) == "\r\n" ? 2 : 1;
    rest.remove_prefix(std::min(end + width, rest.size()));
    ++line;
    goes_on = !part.empty() && part.back() == '\\';
    part.remove_suffix(goes_on ? 1 : 0);
    text += part;
    text += goes_on ? " " : "";
  }
  text.resize(std::min(text.find('#'), text.size()));
  return text;
}

}  // namespace

std::string plainObj(const std::string& bytes) {
  std::string text;
  text.reserve(bytes.size());
  std::string_view rest = bytes;
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (rest.substr(0, kByteOrderMark.size()) == kByteOrderMark) {
    rest.remove_prefix(kByteOrderMark.size());
  }
  for (std::size_t line = 0; !rest.empty();) {
    const std::size_t first_line = line + 1;
    const std::string one = takeLine(rest, line);
    const std::vector<std::string_view> words = wordsOf(one);
    if (!words.empty() && words.front() == "v") {
      appendVertex(words, first_line, text);
    } else if (!words.empty()) {
      text.append(one, one.find_first_not_of(kBlanks));
    }
    text += '\n';
  }
  return text;
}

}  // namespace collision_monitor
