// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tinyxml2.h>

#include <string>
#include <string_view>

/// Helpers shared by the checks of DAE files.
namespace collision_monitor {

/// @throws std::runtime_error that names the element
[[noreturn]] void refuseElement(const tinyxml2::XMLElement& element, const std::string& fault);

/// Calls `look` for each element with a given name.
template <class Look>
class ElementVisitor : public tinyxml2::XMLVisitor {
 public:
  ElementVisitor(const char* name, const Look& look) : name_(name), look_(look) {}
  bool VisitEnter(const tinyxml2::XMLElement& element,
                  const tinyxml2::XMLAttribute* /*first*/) override {
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

/// Refuses nodes that instance themselves, directly or through others. Refuses nodes that, with
/// those that they instance, nest too deeply.
void checkDaeNodes(const tinyxml2::XMLDocument& document);

}  // namespace collision_monitor
