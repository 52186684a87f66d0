// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "edit_srdf.h"

#include <tinyxml2.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <stdexcept>

#include "model/xml_declaration.h"

namespace collision_monitor::pairs_tool {
namespace {

const char* const kLineEnd = "\r\n";
const char* const kBlank = " \t";

/// Replaces a span, which may be empty.
struct Edit {
  Span span;
  std::string text;
};

std::size_t lineStart(const std::string& text, std::size_t place) {
  const std::size_t end = place == 0 ? std::string::npos : text.find_last_of(kLineEnd, place - 1);
  return end == std::string::npos ? 0 : end + 1;
}

std::size_t lineEnd(const std::string& text, std::size_t place) {
  return std::min(text.find_first_of(kLineEnd, place), text.size());
}

bool isBlank(const std::string& text, std::size_t begin, std::size_t end) {
  return std::min(text.find_first_not_of(kBlank, begin), end) == end;
}

std::string indentAt(const std::string& text, std::size_t place) {
  const std::size_t begin = lineStart(text, place);
  return text.substr(begin, std::min(text.find_first_not_of(kBlank, begin), place) - begin);
}

/// The line ending of the text's first line.
std::string lineEndOf(const std::string& text) {
  const std::size_t end = lineEnd(text, 0);
  return end == text.size()                  ? "\n"
         : text.compare(end, 2, "\r\n") == 0 ? "\r\n"
                                             : text.substr(end, 1);
}

Edit removalOf(const std::string& text, const Span& span) {
  const std::size_t begin = lineStart(text, span.begin);
  const std::size_t end = lineEnd(text, span.end);
  if (end == text.size() || !isBlank(text, begin, span.begin) || !isBlank(text, span.end, end)) {
    return {span, ""};
  }
  return {{begin, end + (text.compare(end, 2, "\r\n") == 0 ? 2 : 1)}, ""};
}

bool isOut(const SrdfLine& line, const std::vector<SrdfLine>& out) {
  return std::any_of(out.begin(), out.end(),
                     [&](const SrdfLine& one) { return one.span.begin == line.span.begin; });
}

/// Inserts after the last remaining line: at the end of its text line, which may have a comment,
/// unless another element follows there.
Edit insertionBehind(const std::string& text, const SrdfPlaces& places, const Span& last,
                     const std::vector<std::string>& elements) {
  std::size_t place = lineEnd(text, last.end);
  const bool is_within =
      std::any_of(places.parts.begin(), places.parts.end(),
                  [&](const Span& part) { return part.begin < place && place < part.end; });
  if (is_within || place > places.root_end) {
    place = last.end;
  }
  Edit edit{{place, place}, ""};
  for (const std::string& element : elements) {
    edit.text += lineEndOf(text) + indentAt(text, last.begin) + element;
  }
  return edit;
}

/// Inserts before the end of the root. Opens an empty root for that.
Edit insertionAtEnd(const std::string& text, const SrdfPlaces& places,
                    const std::vector<std::string>& elements) {
  const std::string root_indent = indentAt(text, places.root_end);
  std::string indent = root_indent + "  ";
  for (const Span& part : places.parts) {
    if (isBlank(text, lineStart(text, part.begin), part.begin)) {
      indent = indentAt(text, part.begin);
      break;
    }
  }
  std::string lines;
  for (const std::string& element : elements) {
    lines.append(lineEndOf(text)).append(indent).append(element);
  }
  if (places.is_root_empty) {
    return {{places.root_end, places.root_end + 2},
            ">" + lines + lineEndOf(text) + root_indent + "</robot>"};
  }
  const std::size_t begin = lineStart(text, places.root_end);
  if (begin == 0 || !isBlank(text, begin, places.root_end)) {
    return {{places.root_end, places.root_end}, lines + lineEndOf(text)};
  }
  return {{begin, begin}, lines.substr(lineEndOf(text).size()) + lineEndOf(text)};
}

std::string elementOf(const PairLine& line) {
  tinyxml2::XMLPrinter printer;
  printer.OpenElement("disable_collisions", true);
  printer.PushAttribute("link1", line.link1.c_str());
  printer.PushAttribute("link2", line.link2.c_str());
  printer.PushAttribute("reason", line.reason);
  printer.CloseElement(true);
  return printer.CStr();
}

std::string applied(std::string text, std::vector<Edit> edits) {
  std::stable_sort(edits.begin(), edits.end(), [](const Edit& one, const Edit& other) {
    return one.span.begin > other.span.begin;
  });
  for (const Edit& edit : edits) {
    text.replace(edit.span.begin, edit.span.end - edit.span.begin, edit.text);
  }
  return text;
}

/// The file's contents other than disabled pairs; nothing if it cannot be read.
std::optional<std::string> restOf(const std::string& srdf_xml) {
  tinyxml2::XMLDocument document;
  const std::string xml = withoutLateDeclaration(srdf_xml);
  if (document.Parse(xml.data(), xml.size()) != tinyxml2::XML_SUCCESS ||
      document.RootElement() == nullptr) {
    return std::nullopt;
  }
  tinyxml2::XMLElement& root = *document.RootElement();
  while (tinyxml2::XMLElement* line = root.FirstChildElement("disable_collisions")) {
    root.DeleteChild(line);
  }
  tinyxml2::XMLPrinter printer(nullptr, true);
  document.Print(&printer);
  return printer.CStr();
}

/// Checks by two parsers that the new text differs from the former only in the lines.
void checkEdited(const std::string& former, const std::string& text, std::size_t lines) {
  const std::optional<std::string> rest = restOf(text);
  if (!rest || rest != restOf(former) || findPlaces(text).disabled.size() != lines) {
    throw std::logic_error("the SRDF would have changed in more than its pairs; it is as it was");
  }
}

}  // namespace

std::string editSrdf(const std::string& srdf_xml, const SrdfPlaces& places,
                     const std::vector<SrdfLine>& out, const std::vector<PairLine>& in) {
  std::vector<Edit> edits;
  std::optional<Span> last;
  for (const SrdfLine& line : places.disabled) {
    if (isOut(line, out)) {
      edits.push_back(removalOf(srdf_xml, line.span));
    } else {
      last = line.span;
    }
  }
  std::vector<std::string> elements;
  std::transform(in.begin(), in.end(), std::back_inserter(elements), elementOf);
  if (!elements.empty()) {
    edits.push_back(last ? insertionBehind(srdf_xml, places, *last, elements)
                         : insertionAtEnd(srdf_xml, places, elements));
  }
  std::string text = applied(srdf_xml, std::move(edits));
  checkEdited(srdf_xml, text, places.disabled.size() - out.size() + in.size());
  return text;
}

}  // namespace collision_monitor::pairs_tool
