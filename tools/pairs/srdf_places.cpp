// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "srdf_places.h"

#include <expat.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string_view>
#include <type_traits>

#include "model/xml_declaration.h"

namespace collision_monitor::pairs_tool {
namespace {

using Parser = std::unique_ptr<std::remove_pointer_t<XML_Parser>, decltype(&XML_ParserFree)>;

/// Data shared by the handlers during parsing.
struct Reading {
  XML_Parser parser;
  std::string_view text;  ///< as passed to the parser
  std::size_t depth{0};
  bool declares_entities{false};
  SrdfPlaces places;
};

Reading& of(void* data) { return *static_cast<Reading*>(data); }

/// The span of the current markup; empty at the end of an empty element.
Span spanNow(const Reading& reading) {
  const auto begin = static_cast<std::size_t>(XML_GetCurrentByteIndex(reading.parser));
  return {begin, begin + static_cast<std::size_t>(XML_GetCurrentByteCount(reading.parser))};
}

std::string attributeOf(const XML_Char** attributes, std::string_view name) {
  for (; *attributes != nullptr; attributes += 2) {
    if (*attributes == name) {
      return attributes[1];
    }
  }
  return "";
}

std::string plainName(const std::string& text) {
  constexpr std::string_view kSpace = " \t\r\n";
  const std::size_t end = text.find_last_not_of(kSpace) + 1;
  std::size_t begin = std::min(text.find_first_not_of(kSpace), end);
  while (begin < end && text[begin] == '/') {
    ++begin;
  }
  return text.substr(begin, end - begin);
}

void startRoot(Reading& reading, const XML_Char* name, const XML_Char** attributes) {
  if (std::string_view(name) == "robot") {
    reading.places.robot = attributeOf(attributes, "name");
  }
  const Span tag = spanNow(reading);
  reading.places.is_root_empty = reading.text[tag.end - 2] == '/';
  reading.places.root_end = tag.end - 2;
}

void startElement(void* data, const XML_Char* name, const XML_Char** attributes) {
  Reading& reading = of(data);
  SrdfPlaces& places = reading.places;
  ++reading.depth;
  if (reading.depth == 1) {
    startRoot(reading, name, attributes);
    return;
  }
  if (reading.depth != 2) {
    return;
  }
  const Span tag = spanNow(reading);
  places.parts.push_back(tag);
  const std::string_view kind = name;
  places.has_urdf_parts = places.has_urdf_parts || kind == "link" || kind == "joint";
  if (kind == "disable_collisions" || kind == "enable_collisions") {
    (kind == "disable_collisions" ? places.disabled : places.enabled)
        .push_back({plainName(attributeOf(attributes, "link1")),
                    plainName(attributeOf(attributes, "link2")), attributeOf(attributes, "reason"),
                    XML_GetCurrentLineNumber(reading.parser), tag});
  }
}

void endElement(void* data, const XML_Char* /*name*/) {
  Reading& reading = of(data);
  SrdfPlaces& places = reading.places;
  const Span tag = spanNow(reading);
  if (reading.depth == 1 && !places.is_root_empty) {
    places.root_end = tag.begin;
  }
  if (reading.depth == 2) {
    Span& part = places.parts.back();
    part.end = tag.end;
    for (std::vector<SrdfLine>* lines : {&places.disabled, &places.enabled}) {
      if (!lines->empty() && lines->back().span.begin == part.begin) {
        lines->back().span.end = tag.end;
      }
    }
  }
  --reading.depth;
}

void addPart(Reading& reading) {
  if (reading.depth == 1) {
    reading.places.parts.push_back(spanNow(reading));
  }
}

void endCdata(void* data) {
  Reading& reading = of(data);
  if (reading.depth == 1) {
    reading.places.parts.back().end = spanNow(reading).end;
  }
}

void declareEntity(void* data, const XML_Char* /*name*/, int /*is_parameter*/,
                   const XML_Char* /*value*/, int /*size*/, const XML_Char* /*base*/,
                   const XML_Char* /*system*/, const XML_Char* /*public*/,
                   const XML_Char* /*notation*/) {
  of(data).declares_entities = true;
  XML_StopParser(of(data).parser, XML_FALSE);
}

void setHandlers(Reading& reading) {
  XML_SetUserData(reading.parser, &reading);
  XML_SetElementHandler(reading.parser, startElement, endElement);
  XML_SetCommentHandler(reading.parser, [](void* data, const XML_Char*) { addPart(of(data)); });
  XML_SetCdataSectionHandler(
      reading.parser, [](void* data) { addPart(of(data)); }, endCdata);
  XML_SetEntityDeclHandler(reading.parser, declareEntity);
  XML_SetXmlDeclHandler(reading.parser,
                        [](void* data, const XML_Char*, const XML_Char* encoding, int) {
                          of(data).places.encoding = encoding == nullptr ? "" : encoding;
                        });
}

/// The text with blanks in place of a declaration that is not at its start. The monitor reads such
/// files too.
std::string withoutStrayDeclaration(const std::string& srdf_xml) {
  std::string text = withoutLateDeclaration(srdf_xml);
  const std::size_t begin = std::min(text.find_first_not_of(" \t\r\n"), text.size());
  const std::size_t end = text.find("?>", begin);
  if (begin > 0 && text.compare(begin, 6, "<?xml ") == 0 && end != std::string::npos) {
    text.replace(begin, end + 2 - begin, end + 2 - begin, ' ');
  }
  return text;
}

}  // namespace

SrdfPlaces findPlaces(const std::string& srdf_xml) {
  const std::string text = withoutStrayDeclaration(srdf_xml);  // same length, same places
  if (text.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
    throw std::runtime_error("it is larger than 2 GB");
  }
  const Parser parser(XML_ParserCreate(nullptr), &XML_ParserFree);
  Reading reading{parser.get(), text, 0, false, {}};
  setHandlers(reading);
  if (XML_Parse(parser.get(), text.data(), static_cast<int>(text.size()), XML_TRUE) !=
      XML_STATUS_OK) {
    throw std::runtime_error(
        "line " + std::to_string(XML_GetCurrentLineNumber(parser.get())) + ": " +
        (reading.declares_entities ? "entities are declared"
                                   : XML_ErrorString(XML_GetErrorCode(parser.get()))));
  }
  return reading.places;
}

}  // namespace collision_monitor::pairs_tool
