// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/mesh_files/ply_check.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "model/number_text.h"

namespace collision_monitor {
namespace {

/// A property of each element of a kind: one number, or a list of numbers preceded by its length.
struct PlyProperty {
  std::size_t length_size{0};  ///< [bytes] 0: no list
  std::size_t number_size{0};  ///< [bytes]
};

/// Elements of one kind.
struct PlyElements {
  std::size_t count{0};
  std::vector<PlyProperty> properties;
};

/// What the header announces. Source: Turk, "The PLY Polygon File Format" (1994).
struct PlyHeader {
  std::string format;
  std::vector<PlyElements> elements;
  std::size_t element_count{0};
  std::size_t size{0};  ///< [bytes] including the end of its last line
};

std::size_t sizeOfType(const std::string& type) {
  static const std::map<std::string, std::size_t> kSizes{
      {"char", 1},  {"uchar", 1},   {"int8", 1},   {"uint8", 1},   {"short", 2},   {"ushort", 2},
      {"int16", 2}, {"uint16", 2},  {"int", 4},    {"uint", 4},    {"int32", 4},   {"uint32", 4},
      {"float", 4}, {"float32", 4}, {"double", 8}, {"float64", 8}, {"double64", 8}};
  const auto found = kSizes.find(type);
  if (found == kSizes.end()) {
    throw std::runtime_error("the PLY header has a property of unknown type '" + type + "'");
  }
  return found->second;
}

/// "element vertex 8", without its first word.
void readElement(std::istringstream& line, std::size_t file_size, PlyHeader& header) {
  std::string name;
  PlyElements elements;
  if (!(line >> name >> elements.count) || elements.count > file_size - header.element_count) {
    throw std::runtime_error("the PLY header announces more elements than the file can hold");
  }
  header.element_count += elements.count;
  header.elements.push_back(elements);
}

/// "property float x" or "property list uchar int vertex_indices", without its first word.
void readProperty(std::istringstream& line, PlyHeader& header) {
  if (header.elements.empty()) {
    throw std::runtime_error("the PLY header has a property before its first element");
  }
  PlyProperty property;
  std::string type;
  line >> type;
  if (type == "list") {
    line >> type;
    property.length_size = sizeOfType(type);
    type.clear();
    line >> type;
  }
  property.number_size = sizeOfType(type);
  header.elements.back().properties.push_back(property);
}

PlyHeader readHeader(const std::string& bytes) {
  PlyHeader header;
  for (std::size_t begin = 0; begin < bytes.size();) {
    const std::size_t end = bytes.find('\n', begin);
    if (end == std::string::npos) {
      break;
    }
    std::istringstream line(bytes.substr(begin, end - begin));
    std::string key;
    line >> key;
    if (key == "end_header") {
      header.size = end + 1;
      return header;
    }
    if (key == "format") {
      line >> header.format;
    } else if (key == "element") {
      readElement(line, bytes.size(), header);
    } else if (key == "property") {
      readProperty(line, header);
    }
    begin = end + 1;
  }
  throw std::runtime_error("the PLY header has no end_header line");
}

/// Whether a line has all the numbers of an element.
bool isWhole(const std::vector<std::string_view>& words,
             const std::vector<PlyProperty>& properties) {
  std::size_t needed = 0;
  for (const PlyProperty& property : properties) {
    if (needed >= words.size()) {
      return false;
    }
    std::size_t length = 0;
    const std::string_view word = words[needed++];
    if (property.length_size > 0 &&
        (std::from_chars(word.data(), word.data() + word.size(), length).ec != std::errc() ||
         length > words.size() - needed)) {
      return false;
    }
    needed += length;
  }
  return true;
}

/// Checks one element per line; skips blank lines.
void checkText(const std::string& bytes, const PlyHeader& header) {
  const auto number_of_line = [&](std::size_t place) {
    return 1 + std::count(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(place), '\n');
  };
  std::size_t lines = 0;
  std::size_t begin = header.size;
  for (const PlyElements& elements : header.elements) {
    for (std::size_t i = 0; i < elements.count; ++i, ++lines) {
      begin = bytes.find_first_not_of(" \t\r\n", begin);
      if (begin == std::string::npos) {
        throw std::runtime_error("the PLY file is cut short: it announces " +
                                 std::to_string(header.element_count) + " elements and holds " +
                                 std::to_string(lines) + " lines");
      }
      const std::size_t end = std::min(bytes.find('\n', begin), bytes.size());
      const std::string_view line = std::string_view(bytes).substr(begin, end - begin);
      if (!isWhole(wordsOf(line), elements.properties)) {
        throw std::runtime_error("line " + std::to_string(number_of_line(begin)) +
                                 " has fewer numbers than the PLY header announces");
      }
      begin = end;
    }
  }
}

/// @pre the bytes exist
std::size_t lengthAt(const std::string& bytes, std::size_t place, std::size_t size,
                     bool is_big_endian) {
  std::size_t length = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t byte = place + (is_big_endian ? i : size - 1 - i);
    length = length << 8U | static_cast<unsigned char>(bytes[byte]);
  }
  return length;
}

/// End of the element that begins at `place`; nothing if the bytes end before it does.
std::optional<std::size_t> endOfElement(const std::string& bytes, std::size_t place,
                                        const std::vector<PlyProperty>& properties,
                                        bool is_big_endian) {
  for (const PlyProperty& property : properties) {
    if (property.length_size > bytes.size() - place) {
      return std::nullopt;
    }
    const bool is_list = property.length_size > 0;
    const std::size_t length =
        is_list ? lengthAt(bytes, place, property.length_size, is_big_endian) : 1;
    place += property.length_size;
    if (length > (bytes.size() - place) / property.number_size) {
      return std::nullopt;
    }
    place += length * property.number_size;
  }
  return place;
}

void checkBinary(const std::string& bytes, const PlyHeader& header) {
  const bool is_big_endian = header.format == "binary_big_endian";
  std::size_t place = header.size;
  for (const PlyElements& elements : header.elements) {
    for (std::size_t i = 0; i < elements.count; ++i) {
      const auto end = endOfElement(bytes, place, elements.properties, is_big_endian);
      if (!end) {
        throw std::runtime_error("the binary PLY is cut short: it announces " +
                                 std::to_string(header.element_count) + " elements, more than " +
                                 std::to_string(bytes.size() - header.size) + " bytes hold");
      }
      place = *end;
    }
  }
}

}  // namespace

void checkPlyIsComplete(const std::string& bytes) {
  const PlyHeader header = readHeader(bytes);
  if (header.format == "ascii") {
    checkText(bytes, header);
  } else {
    checkBinary(bytes, header);
  }
}

}  // namespace collision_monitor
