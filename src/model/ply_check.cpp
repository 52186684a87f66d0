// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/ply_check.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace collision_monitor {
namespace {

/// What the header announces. Source: Turk, "The PLY Polygon File Format" (1994).
struct PlyHeader {
  bool is_ascii{false};
  std::size_t element_count{0};
  std::size_t size{0};  ///< bytes up to and with the end of its last line
};

PlyHeader readHeader(const std::string& bytes) {
  PlyHeader header;
  for (std::size_t begin = 0; begin < bytes.size();) {
    const std::size_t end = bytes.find('\n', begin);
    if (end == std::string::npos) {
      break;
    }
    std::istringstream line(bytes.substr(begin, end - begin));
    std::string key;
    std::string name;
    std::size_t count = 0;
    line >> key;
    if (key == "end_header") {
      header.size = end + 1;
      return header;
    }
    if (key == "format") {
      line >> name;
      header.is_ascii = name == "ascii";
    } else if (key == "element") {
      if (!(line >> name >> count) || count > bytes.size() - header.element_count) {
        throw std::runtime_error("the PLY header announces more elements than the file can hold");
      }
      header.element_count += count;
    }
    begin = end + 1;
  }
  throw std::runtime_error("the PLY header has no end_header line");
}

}  // namespace

void checkPlyIsComplete(const std::string& bytes) {
  const PlyHeader header = readHeader(bytes);
  if (!header.is_ascii) {
    return;
  }
  // One element a line; the last line may lack its end.
  const auto body = bytes.begin() + static_cast<std::ptrdiff_t>(header.size);
  const auto line_ends = static_cast<std::size_t>(std::count(body, bytes.end(), '\n'));
  const bool has_open_line = body != bytes.end() && bytes.back() != '\n';
  const std::size_t lines = line_ends + (has_open_line ? 1 : 0);
  if (lines < header.element_count) {
    throw std::runtime_error("the PLY file is cut short: it announces " +
                             std::to_string(header.element_count) + " elements and holds " +
                             std::to_string(lines) + " lines");
  }
}

}  // namespace collision_monitor
