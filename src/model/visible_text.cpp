// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/visible_text.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>

namespace collision_monitor {
namespace {

struct Letter {
  std::uint32_t code;  ///< Unicode code point; for a byte that is not UTF-8, its value
  std::size_t size;    ///< [bytes]
  bool is_utf8;
};

/// @pre place < text.size()
Letter letterAt(std::string_view text, std::size_t place) {
  const auto byteAt = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const std::uint32_t first = byteAt(place);
  const std::size_t size = first < 0x80   ? 1
                           : first < 0xC2 ? 0
                           : first < 0xE0 ? 2
                           : first < 0xF0 ? 3
                           : first < 0xF5 ? 4
                                          : 0;
  if (size == 0 || place + size > text.size()) {
    return {first, 1, false};
  }
  std::uint32_t code = size == 1 ? first : first & (0x7FU >> size);
  for (std::size_t i = place + 1; i < place + size; ++i) {
    if ((byteAt(i) & 0xC0U) != 0x80U) {
      return {first, 1, false};
    }
    code = (code << 6U) | (byteAt(i) & 0x3FU);
  }
  return {code, size, true};
}

bool isControl(std::uint32_t code) { return code < 0x20 || (code >= 0x7F && code < 0xA0); }

/// Unusual spaces, direction marks and characters of no width.
bool isInvisible(std::uint32_t code) {
  return code == 0xA0 || code == 0xAD || code == 0x1680 || (code >= 0x2000 && code <= 0x200F) ||
         (code >= 0x2028 && code <= 0x202F) || (code >= 0x205F && code <= 0x206F) ||
         code == 0x3000 || code == 0xFEFF;
}

std::string numbered(const char* format, std::uint32_t code) {
  char text[16];
  std::snprintf(text, sizeof(text), format, code);
  return text;
}

std::string shown(std::string_view text, bool is_ascii_only) {
  std::string safe;
  for (std::size_t i = 0; i < text.size();) {
    const Letter letter = letterAt(text, i);
    if (letter.is_utf8 ? isControl(letter.code) : is_ascii_only) {
      safe += numbered("\\x%02x", letter.code);
    } else if (letter.is_utf8 &&
               (isInvisible(letter.code) || (is_ascii_only && letter.code >= 0x80))) {
      safe += numbered("<U+%04X>", letter.code);
    } else {
      safe += text.substr(i, letter.size);
    }
    i += letter.size;
  }
  return safe;
}

}  // namespace

std::string visibleText(std::string_view text) { return shown(text, false); }

std::string asciiText(std::string_view text) { return shown(text, true); }

bool isAscii(std::string_view text) noexcept {
  return std::all_of(text.begin(), text.end(),
                     [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

std::size_t firstNoUtf8(std::string_view text) noexcept {
  std::size_t place = 0;
  while (place < text.size()) {
    const Letter letter = letterAt(text, place);
    if (!letter.is_utf8) {
      return place;
    }
    place += letter.size;
  }
  return place;
}

}  // namespace collision_monitor
