// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/mesh_files/dae_check.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string_view>

#include "model/mesh_files/dae_elements.h"
#include "model/number_text.h"
#include "model/visible_text.h"
#include "model/xml_document.h"

namespace collision_monitor {
namespace {

using tinyxml2::XMLElement;

using ArraySizes = std::map<std::string, std::uint64_t>;  ///< by id

/// "with count 3, stride 3", as written in the file.
std::string accessText(const XMLElement& accessor) {
  std::string text = "with count " + visibleText(attributeOf(accessor, "count"));
  for (const char* attribute : {"stride", "offset"}) {
    const std::string value = attributeOf(accessor, attribute);
    text += value.empty() ? "" : std::string(", ") + attribute + " " + visibleText(value);
  }
  return text;
}

/// Source: COLLADA 1.4.1, chapter 5: values begin at `offset` and are `stride` apart; each has one
/// number per parameter.
void checkAccessor(const XMLElement& accessor, const ArraySizes& size_of) {
  const std::string source = attributeOf(accessor, "source");
  const auto array = size_of.find(source.substr(std::min<std::size_t>(1, source.size())));
  const std::uint64_t count = accessor.UnsignedAttribute("count");
  if (array == size_of.end() || count == 0) {
    return;
  }
  const std::uint64_t stride = accessor.UnsignedAttribute("stride", 1);
  std::uint64_t parameters = 0;
  for (const XMLElement* e = accessor.FirstChildElement("param"); e != nullptr;
       e = e->NextSiblingElement("param")) {
    ++parameters;
  }
  const std::uint64_t needed =
      accessor.UnsignedAttribute("offset") + (count - 1) * stride + std::max(stride, parameters);
  if (needed > array->second) {
    refuseElement(accessor, accessText(accessor) + " reads " + std::to_string(needed) +
                                " numbers of the <float_array> '" + visibleText(array->first) +
                                "', which holds only " + std::to_string(array->second));
  }
}

/// assimp allocates this many numbers.
void checkCount(const XMLElement& array, std::size_t file_size) {
  const std::string text = attributeOf(array, "count");
  const std::vector<std::string_view> words = wordsOf(text);
  if (words.empty()) {
    return;  // assimp reads an empty array then
  }
  const std::string_view digits = words[0].substr(words[0].front() == '+' ? 1 : 0);
  std::uint64_t count = 0;
  const auto [end, fault] = std::from_chars(digits.data(), digits.data() + digits.size(), count);
  if (words.size() != 1 || fault != std::errc() || end != digits.data() + digits.size() ||
      count > file_size) {
    refuseElement(
        array, "has the count '" + text + "', which is no number of values that the file can hold");
  }
}

void checkIndices(const XMLElement& primitives) {
  const char* text = primitives.GetText();
  if (text != nullptr &&
      std::string_view(text).find_first_not_of("0123456789+- \t\r\n") != std::string_view::npos) {
    refuseElement(primitives, "holds something that is no index");
  }
}

}  // namespace

void checkDae(const std::string& bytes) {
  tinyxml2::XMLDocument document;
  const tinyxml2::XMLError fault = document.Parse(bytes.data(), bytes.size());
  if (fault == tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED) {
    throw std::runtime_error("line " + std::to_string(document.ErrorLineNum()) +
                             ": elements nest deeper than " +
                             std::to_string(TINYXML2_MAX_ELEMENT_DEPTH) + " levels");
  }
  if (fault != tinyxml2::XML_SUCCESS) {
    return;
  }
  for (const char* name : {"float_array", "int_array", "bool_array", "Name_array", "IDREF_array"}) {
    forElements(name, document, [&](const XMLElement& array) { checkCount(array, bytes.size()); });
  }
  ArraySizes size_of;
  forElements("float_array", document, [&](const XMLElement& array) {
    size_of[attributeOf(array, "id")] = array.UnsignedAttribute("count");
  });
  forElements("accessor", document,
              [&](const XMLElement& accessor) { checkAccessor(accessor, size_of); });
  forElements("p", document, checkIndices);
  checkDaeNodes(document);
}

}  // namespace collision_monitor
