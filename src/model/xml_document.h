// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tinyxml2.h>

#include <optional>
#include <string>

#include "collision_monitor/geometry/pose.h"
#include "model/number_text.h"
#include "model/place.h"

namespace collision_monitor {

/// Parses a description and finds its `<robot>`. Adds an error and returns null if the text is
/// empty, is no XML, has another root element, or contains xacro that was not expanded.
/// @param kind "URDF" or "SRDF", for messages
const tinyxml2::XMLElement* parseRobotXml(const std::string& text, const std::string& kind,
                                          const Place& place, tinyxml2::XMLDocument& document);

/// The attribute as written; empty if there is none.
std::string attributeOf(const tinyxml2::XMLElement& element, const char* attribute);

/// The attribute without surrounding white space. Adds an error and returns nothing if it is
/// missing or blank.
std::optional<std::string> readText(const tinyxml2::XMLElement& element, const char* attribute,
                                    const Place& place);

/// The only child of that name; null if there is none. Adds an error if there is a second one, even
/// an identical one: the author's intention is unclear.
const tinyxml2::XMLElement* onlyChild(const tinyxml2::XMLElement& element, const char* name,
                                      const Place& place);

/// The name of a link or joint, without the leading slash of old tf frames.
std::optional<std::string> readName(const tinyxml2::XMLElement& element, const char* attribute,
                                    const Place& place);

struct NumberAttribute {
  const char* name;
  const char* accepted;        ///< "three finite numbers, in metres"
  double farthest{kFarthest};  ///< numbers farther from 0 are refused
};

template <int kSize>
using Numbers = Eigen::Matrix<double, kSize, 1>;

/// Adds an error for the first number in `text` that is farther from 0 than the attribute allows.
bool isWithin(const std::string& text, const tinyxml2::XMLElement& element,
              const NumberAttribute& attribute, const Eigen::VectorXd& numbers, const Place& place);

/// Adds an error and returns nothing if the attribute is missing, malformed or too far from 0.
template <int kSize>
std::optional<Numbers<kSize>> readNumbers(const tinyxml2::XMLElement& element,
                                          const NumberAttribute& attribute, const Place& place) {
  const char* text = element.Attribute(attribute.name);
  if (text == nullptr) {
    place.addError(element.GetLineNum(),
                   std::string("<") + element.Name() + "> without " + attribute.name,
                   attribute.accepted);
    return std::nullopt;
  }
  Eigen::VectorXd numbers(kSize);
  if (const auto fault = parseNumbers(text, numbers)) {
    place.addError(
        element.GetLineNum(),
        std::string(element.Name()) + " " + attribute.name + " " + quoted(text) + ": " + *fault,
        attribute.accepted);
    return std::nullopt;
  }
  if (!isWithin(text, element, attribute, numbers, place)) {
    return std::nullopt;
  }
  return Numbers<kSize>(numbers);
}

/// As readNumbers, but a missing attribute means `fallback`. So does a malformed one, after an
/// error.
template <int kSize>
Numbers<kSize> readNumbersOr(const Numbers<kSize>& fallback, const tinyxml2::XMLElement& element,
                             const NumberAttribute& attribute, const Place& place) {
  if (element.Attribute(attribute.name) == nullptr) {
    return fallback;
  }
  return readNumbers<kSize>(element, attribute, place).value_or(fallback);
}

}  // namespace collision_monitor
