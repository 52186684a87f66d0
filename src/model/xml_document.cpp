// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/xml_document.h"

#include <cmath>
#include <cstring>
#include <string_view>

#include "model/xml_declaration.h"

namespace collision_monitor {
namespace {

using tinyxml2::XMLAttribute;
using tinyxml2::XMLDocument;
using tinyxml2::XMLElement;

/// "junk at the end": the parser's message without position and internal names.
std::string reasonOf(const XMLDocument& document) {
  switch (document.ErrorID()) {
    case tinyxml2::XML_ERROR_MISMATCHED_ELEMENT:
      return "closing tag that does not match";
    case tinyxml2::XML_ERROR_EMPTY_DOCUMENT:
      return "no element at all";
    case tinyxml2::XML_ERROR_PARSING_ATTRIBUTE:
      return "malformed attribute";
    case tinyxml2::XML_ERROR_PARSING_ELEMENT:
      return "malformed element";
    case tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED:
      return "elements nested too deeply";
    case tinyxml2::XML_ERROR_PARSING_COMMENT:
      return "comment without end";
    default:
      return "malformed or unfinished XML";
  }
}

bool isXacro(const XMLElement& element) {
  if (std::strncmp(element.Name(), "xacro:", 6) == 0) {
    return true;
  }
  for (const XMLAttribute* a = element.FirstAttribute(); a != nullptr; a = a->Next()) {
    const std::string_view value = a->Value();
    if (value.find("${") != std::string_view::npos || value.find("$(") != std::string_view::npos) {
      return true;
    }
  }
  return false;
}

/// Whether this is an extension. Those for simulators and controllers have their own syntax.
bool isExtension(const XMLElement& element) {
  const std::string_view name = element.Name();
  return name == "gazebo" || name == "transmission" || name == "ros2_control";
}

/// The first element below `root` that xacro should have replaced. The parser limits the depth of
/// the document, and thus this recursion.
const XMLElement* findXacro(const XMLElement& root) {
  if (isXacro(root)) {
    return &root;
  }
  for (const XMLElement* e = root.FirstChildElement(); e != nullptr; e = e->NextSiblingElement()) {
    if (!isExtension(*e)) {
      if (const XMLElement* found = findXacro(*e)) {
        return found;
      }
    }
  }
  return nullptr;
}

/// Name of an encoding with more than one byte per unit, found by its byte order mark or by the
/// first characters of XML.
const char* wideEncodingOf(std::string_view text) {
  const auto begins = [&](std::string_view start) { return text.substr(0, start.size()) == start; };
  using namespace std::string_view_literals;
  if (begins("\xFF\xFE\0\0"sv) || begins("\0\0\xFE\xFF"sv) || begins("<\0\0\0"sv) ||
      begins("\0\0\0<"sv)) {
    return "UTF-32";
  }
  if (begins("\xFF\xFE"sv) || begins("\xFE\xFF"sv) || begins("<\0"sv) || begins("\0<"sv)) {
    return "UTF-16";
  }
  return nullptr;
}

}  // namespace

std::string attributeOf(const XMLElement& element, const char* attribute) {
  const char* text = element.Attribute(attribute);
  return text == nullptr ? "" : text;
}

const XMLElement* parseRobotXml(const std::string& text, const std::string& kind,
                                const Place& place, XMLDocument& document) {
  const std::string accepted = "the XML of one " + kind + " with the root element <robot>";
  if (text.find_first_not_of(" \t\r\n") == std::string::npos) {
    place.addError(0, "empty " + kind, accepted);
    return nullptr;
  }
  if (const char* const encoding = wideEncodingOf(text)) {
    place.addError(
        0, kind + " in " + encoding,
        std::string("UTF-8; 'iconv -f ") + encoding + " -t UTF-8 FILE' turns it into that");
    return nullptr;
  }
  if (text.find('\0') != std::string::npos) {
    place.addError(0, kind + " with a zero byte", accepted);
    return nullptr;
  }
  const std::string xml = withoutLateDeclaration(text);
  if (document.Parse(xml.data(), xml.size()) != tinyxml2::XML_SUCCESS) {
    place.addError(document.ErrorLineNum(), "XML that cannot be parsed: " + reasonOf(document),
                   accepted);
    return nullptr;
  }
  const XMLElement* root = document.RootElement();
  if (root == nullptr || std::strcmp(root->Name(), "robot") != 0) {
    place.addError(
        root == nullptr ? 0 : root->GetLineNum(),
        root == nullptr ? "no element at all" : "root element <" + std::string(root->Name()) + ">",
        accepted);
    return nullptr;
  }
  if (const XMLElement* second = root->NextSiblingElement()) {
    place.addError(second->GetLineNum(),
                   "a second root element <" + std::string(second->Name()) + ">", accepted);
    return nullptr;
  }
  if (const XMLElement* xacro = findXacro(*root)) {
    place.addError(
        xacro->GetLineNum(), "xacro that was not expanded, in <" + std::string(xacro->Name()) + ">",
        "plain " + kind + ": expand it first, for example with 'rosrun xacro xacro FILE'");
    return nullptr;
  }
  return root;
}

std::optional<std::string> readText(const XMLElement& element, const char* attribute,
                                    const Place& place) {
  constexpr std::string_view kSpace = " \t\r\n";
  const char* value = element.Attribute(attribute);
  const std::string_view text = value == nullptr ? "" : value;
  const std::size_t begin = text.find_first_not_of(kSpace);
  if (begin == std::string_view::npos) {
    place.addError(element.GetLineNum(),
                   "<" + std::string(element.Name()) + "> without " + attribute,
                   std::string(attribute) + "=\"...\" that is not blank");
    return std::nullopt;
  }
  return std::string(text.substr(begin, text.find_last_not_of(kSpace) + 1 - begin));
}

const XMLElement* onlyChild(const XMLElement& element, const char* name, const Place& place) {
  const XMLElement* first = element.FirstChildElement(name);
  const XMLElement* second = first == nullptr ? nullptr : first->NextSiblingElement(name);
  if (second != nullptr) {
    place.addError(second->GetLineNum(),
                   "<" + std::string(element.Name()) + "> with a second <" + name + ">",
                   "one <" + std::string(name) + ">");
  }
  return first;
}

std::optional<std::string> readName(const XMLElement& element, const char* attribute,
                                    const Place& place) {
  const std::optional<std::string> text = readText(element, attribute, place);
  if (!text) {
    return std::nullopt;
  }
  const std::size_t begin = text->find_first_not_of('/');
  if (begin == std::string::npos) {
    place.addError(element.GetLineNum(), std::string(attribute) + " " + quoted(*text),
                   "a name, not slashes alone");
    return std::nullopt;
  }
  return text->substr(begin);
}

bool isWithin(const std::string& text, const XMLElement& element, const NumberAttribute& attribute,
              const Eigen::VectorXd& numbers, const Place& place) {
  for (Eigen::Index i = 0; i < numbers.size(); ++i) {
    if (std::abs(numbers[i]) > attribute.farthest) {
      const std::string word(wordsOf(text)[static_cast<std::size_t>(i)].substr(0, 40));
      place.addError(element.GetLineNum(),
                     std::string(element.Name()) + " " + attribute.name + " " + quoted(text) +
                         ": " + quoted(word) + " is beyond 1e9",
                     std::string(attribute.accepted) + ", none beyond 1e9");
      return false;
    }
  }
  return true;
}

}  // namespace collision_monitor
