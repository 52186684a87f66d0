// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/model/shape_rules.h"
#include "model/rules/given_shape.h"

namespace collision_monitor {
namespace {

/// In double quotes, so that YAML does not take a name for a number, a pattern or a comment.
std::string inQuotes(const std::string& text) {
  std::string quoted_text = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      quoted_text += '\\';
    }
    quoted_text += c;
  }
  return quoted_text + "\"";
}

}  // namespace

std::string writeShapeRules(const std::vector<NamedShapes>& links) {
  std::string text = "shapes:\n";
  for (const NamedShapes& named : links) {
    if (!named.comment.empty()) {
      text += "  # " + named.comment + "\n";
    }
    text += "  - link: " + inQuotes(named.link) + "\n    shapes:\n";
    for (const PosedShape& shape : named.shapes) {
      text += "      - " + toYaml(shape) + "\n";
    }
  }
  return text;
}

}  // namespace collision_monitor
