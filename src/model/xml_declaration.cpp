// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/xml_declaration.h"

#include <algorithm>
#include <string_view>

namespace collision_monitor {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

bool startsAt(const std::string& text, std::size_t begin, std::string_view start) {
  return text.compare(begin, start.size(), start) == 0;
}

/// Position after white space and comments; the end of the text if a comment does not end.
std::size_t firstMarkup(const std::string& xml) {
  std::size_t begin = startsAt(xml, 0, kByteOrderMark) ? kByteOrderMark.size() : 0;
  for (;;) {
    begin = std::min(xml.find_first_not_of(" \t\r\n", begin), xml.size());
    if (!startsAt(xml, begin, "<!--")) {
      return begin;
    }
    const std::size_t end = xml.find("-->", begin + 4);
    if (end == std::string::npos) {
      return xml.size();
    }
    begin = end + 3;
  }
}

}  // namespace

std::string withoutLateDeclaration(std::string xml) {
  const std::size_t begin = firstMarkup(xml);
  const std::size_t end = startsAt(xml, begin, "<?xml ") ? xml.find("?>", begin) : begin;
  // A declaration with nothing before it is valid and gives the encoding.
  if (xml.find("<!--") < begin && end != std::string::npos && end > begin) {
    std::replace_if(
        xml.begin() + static_cast<std::ptrdiff_t>(begin),
        xml.begin() + static_cast<std::ptrdiff_t>(end + 2), [](char c) { return c != '\n'; }, ' ');
  }
  return xml;
}

}  // namespace collision_monitor
