// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/dae_check.h"

#include <tinyxml2.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string_view>

#include "model/xml_document.h"

namespace collision_monitor {
namespace {

using tinyxml2::XMLElement;

[[noreturn]] void refuse(const XMLElement& element, const std::string& fault) {
  throw std::runtime_error("line " + std::to_string(element.GetLineNum()) + ": <" + element.Name() +
                           "> " + fault);
}

/// Calls `look` with each element of a name.
template <class Look>
class ElementVisitor : public tinyxml2::XMLVisitor {
 public:
  ElementVisitor(const char* name, const Look& look) : name_(name), look_(look) {}
  bool VisitEnter(const XMLElement& element, const tinyxml2::XMLAttribute* /*first*/) override {
    if (name_ == element.Name()) {
      look_(element);
    }
    return true;
  }

 private:
  std::string_view name_;
  const Look& look_;
};

template <class Look>
void forElements(const char* name, const tinyxml2::XMLDocument& document, const Look& look) {
  ElementVisitor<Look> visitor(name, look);
  document.Accept(&visitor);
}

using ArraySizes = std::map<std::string, std::uint64_t>;  ///< by id

/// Source: COLLADA 1.4.1, chapter 5: values from `offset` on, `stride` from one to the next, of
/// each as many as there are parameters.
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
    refuse(accessor, "needs " + std::to_string(needed) + " numbers of an array of " +
                         std::to_string(array->second));
  }
}

void checkIndices(const XMLElement& primitives) {
  const char* text = primitives.GetText();
  if (text != nullptr &&
      std::string_view(text).find_first_not_of("0123456789+- \t\r\n") != std::string_view::npos) {
    refuse(primitives, "holds something that is no index");
  }
}

}  // namespace

void checkDaeArrays(const std::string& bytes) {
  tinyxml2::XMLDocument document;
  if (document.Parse(bytes.data(), bytes.size()) != tinyxml2::XML_SUCCESS) {
    return;
  }
  ArraySizes size_of;
  forElements("float_array", document, [&](const XMLElement& array) {
    size_of[attributeOf(array, "id")] = array.UnsignedAttribute("count");
  });
  forElements("accessor", document,
              [&](const XMLElement& accessor) { checkAccessor(accessor, size_of); });
  forElements("p", document, checkIndices);
}

}  // namespace collision_monitor
