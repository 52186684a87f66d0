// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report.h"

#include <tinyxml2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "table.h"

namespace collision_monitor::pairs_tool {
namespace {

using Row = std::array<std::string, 4>;

const char* wordOf(PairFinding finding) noexcept {
  switch (finding) {
    case PairFinding::adjacent:
      return "adjacent";
    case PairFinding::always:
      return "always";
    case PairFinding::sometimes:
      return "sometimes";
    case PairFinding::unclear:
      return "perhaps";
    case PairFinding::never:
      return "never";
  }
  return "";
}

/// How near the enclosing shapes came. They overlap before the enclosed geometries do.
std::string nearestText(const PairFound& pair) {
  const std::string amount = fit_tool::fixed(1e3 * std::abs(pair.nearest), 1) + " mm";
  return pair.nearest < 0.0 ? "though shapes overlapped by " + amount : "shapes by " + amount;
}

std::string reasonOf(const RobotModel& model, const PairFound& pair, std::size_t states) {
  const std::string seen = " in all " + std::to_string(states) + " states";
  switch (pair.finding) {
    case PairFinding::adjacent:
      return "the links meet at a joint";
    case PairFinding::always:
      return pair.is_proven
                 ? "proven" + std::string(pair.joints.empty() ? ": fixed to each other" : "")
                 : "touch" + seen;
    case PairFinding::sometimes:
    case PairFinding::unclear:
      return stateText(model, pair);
    case PairFinding::never:
      return pair.is_proven ? "proven" + std::string(pair.joints.empty() ? ": fixed apart" : "")
                            : "apart" + seen + ", " + nearestText(pair);
  }
  return "";
}

std::string textOf(const std::vector<Row>& rows) {
  std::array<std::size_t, 4> widths{};
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      widths[i] = std::max(widths[i], row[i].size());
    }
  }
  std::string text;
  for (const Row& row : rows) {
    for (std::size_t i = 0; i + 1 < row.size(); ++i) {
      text += row[i] + std::string(widths[i] - row[i].size() + 2, ' ');
    }
    text += row.back() + "\n";
  }
  return text;
}

/// The reason for an SRDF; null for a pair that must be checked.
const char* srdfReasonOf(PairFinding finding) noexcept {
  switch (finding) {
    case PairFinding::adjacent:
      return "Adjacent";
    case PairFinding::always:
      return "Always";
    case PairFinding::never:
      return "Never";
    case PairFinding::sometimes:
    case PairFinding::unclear:
      return nullptr;
  }
  return nullptr;
}

std::string totalsOf(const std::vector<PairFound>& pairs) {
  std::string text = std::to_string(pairs.size()) + " pairs";
  for (const PairFinding finding :
       {PairFinding::adjacent, PairFinding::always, PairFinding::sometimes, PairFinding::unclear,
        PairFinding::never}) {
    const auto count = [&](bool only_proven) {
      return std::to_string(std::count_if(pairs.begin(), pairs.end(), [&](const PairFound& pair) {
        return pair.finding == finding && (!only_proven || pair.is_proven);
      }));
    };
    text += ", " + count(false) + " " + wordOf(finding);
    if (finding == PairFinding::never || finding == PairFinding::always) {
      text += " (" + count(true) + " proven)";
    }
  }
  return text + "\n";
}

/// A double-quoted scalar of YAML.
std::string quoted(const std::string& name) {
  std::string text = "\"";
  for (const char c : name) {
    if (c == '"' || c == '\\') {
      text += '\\';
    }
    text += c;
  }
  return text + "\"";
}

}  // namespace

std::string stateText(const RobotModel& model, const PairFound& pair) {
  constexpr int kCutoff = 32;
  std::string text = "at";
  for (const JointId id : pair.joints) {
    const Joint& joint = model.joint(id);
    std::array<char, kCutoff> number{};
    std::snprintf(number.data(), number.size(), "%.9g", pair.touching[joint.first_variable]);
    text += " " + joint.name + "=" + number.data();
  }
  return text;
}

std::string tableOf(const RobotModel& model, const std::vector<PairFound>& pairs,
                    std::size_t states) {
  std::vector<Row> rows{{"link", "link", "touch", "because"}};
  for (const PairFound& pair : pairs) {
    rows.push_back({model.link(pair.a).name, model.link(pair.b).name, wordOf(pair.finding),
                    reasonOf(model, pair, states)});
  }
  return textOf(rows) + totalsOf(pairs);
}

PairLines linesOf(const RobotModel& model, const std::vector<PairFound>& pairs,
                  bool trusts_samples) {
  PairLines found;
  for (const PairFound& pair : pairs) {
    const char* reason = srdfReasonOf(pair.finding);
    if (reason == nullptr) {
      continue;
    }
    const bool is_known = pair.finding == PairFinding::adjacent || pair.is_proven || trusts_samples;
    (is_known ? found.lines : found.left_out)
        .push_back({model.link(pair.a).name, model.link(pair.b).name, reason});
  }
  return found;
}

std::string newSrdf(const std::string& robot_name, const std::vector<PairLine>& lines) {
  tinyxml2::XMLPrinter printer;
  printer.PushHeader(false, true);
  printer.OpenElement("robot");
  printer.PushAttribute("name", robot_name.c_str());
  for (const PairLine& line : lines) {
    printer.OpenElement("disable_collisions");
    printer.PushAttribute("link1", line.link1.c_str());
    printer.PushAttribute("link2", line.link2.c_str());
    printer.PushAttribute("reason", line.reason);
    printer.CloseElement();
  }
  printer.CloseElement();
  return printer.CStr();
}

std::string ignoredPairsYaml(const std::vector<PairLine>& lines) {
  std::string text =
      "# Pairs that need no checking, found by the program pairs, for the monitor's parameters.\n";
  text += lines.empty() ? "ignore_pairs: []\n" : "ignore_pairs:\n";
  for (const PairLine& line : lines) {
    text += "  - [" + quoted(line.link1) + ", " + quoted(line.link2) + "]  # " + line.reason + "\n";
  }
  return text;
}

}  // namespace collision_monitor::pairs_tool
