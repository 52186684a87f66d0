// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/place.h"

#include <utility>

namespace collision_monitor {
namespace {

struct OddityText {
  const char* found;
  const char* accepted;
};

OddityText textOf(Oddity oddity) {
  switch (oddity) {
    case Oddity::link_without_geometry:
      return {"no collision geometry", "<collision> in every link that is to be checked"};
    case Oddity::zero_size:
      return {"a size of 0",
              "sizes greater than 0; these are taken as the points, lines or faces they are"};
    case Oddity::mesh_without_area:
      return {"meshes without area",
              "triangles with an area; of these meshes the corners count alone"};
    case Oddity::mimic_on_fixed_joint:
      return {"mimic on a fixed joint", "mimic on joints that move; these are ignored"};
    case Oddity::mimic_of_immovable_joint:
      return {"mimic of a fixed joint",
              "mimic of joints that move; these joints are taken to move by themselves"};
    case Oddity::mimic_of_unknown_joint:
      return {"mimic of an unknown joint",
              "mimic of a <joint> of this robot; these joints are taken to move by themselves"};
    case Oddity::no_limit:
      return {"no limits", "<limit lower upper>; these joints are taken as unlimited"};
    case Oddity::limit_without_range:
      return {"limit without lower and upper",
              "both; as URDF has it they are 0 and these joints are locked"};
    case Oddity::limit_beyond_sense:
      return {"limits beyond 1e9",
              "limits within 1e9 of 0, or type continuous; these are taken as none"};
    case Oddity::no_speed_limit:
      return {"velocity limit of 0 or less", "greater than 0; these are taken as unlimited"};
    case Oddity::other_up_axis:
      return {"meshes that declare another up axis than z",
              "axes as rviz and MoveIt show them; obey_up_axis turns them as declared"};
  }
  return {"", ""};
}

std::string listOf(const std::vector<std::string>& elements) {
  std::string text;
  for (const std::string& element : elements) {
    text += (text.empty() ? "" : "; ") + element;
  }
  return text;
}

}  // namespace

void reportOddities(const std::string& source, const Oddities& oddities, SetupReport& report) {
  for (const auto& [oddity, elements] : oddities) {
    const OddityText text = textOf(oddity);
    report.warnings.push_back({source, text.found + (": " + listOf(elements)), text.accepted});
  }
}

Place::Place(std::string source, SetupReport& report, Oddities& oddities)
    : source_(std::move(source)), report_(&report), oddities_(&oddities) {}

Place Place::within(const std::string& element) const {
  Place inner = *this;
  inner.element_ += (element_.empty() ? "" : ", ") + element;
  return inner;
}

void Place::addError(int line, const std::string& found, const std::string& accepted) const {
  report_->errors.push_back(problemAt(line, found, accepted));
}

void Place::addWarning(int line, const std::string& found, const std::string& accepted) const {
  report_->warnings.push_back(problemAt(line, found, accepted));
}

void Place::note(Oddity oddity) const { (*oddities_)[oddity].push_back(element_); }

Problem Place::problemAt(int line, const std::string& found, const std::string& accepted) const {
  std::string where = source_;
  if (line > 0) {
    where += " line " + std::to_string(line);
  }
  if (!element_.empty()) {
    where += ", " + element_;
  }
  return {where, found, accepted};
}

std::string quoted(const std::string& text) {
  constexpr std::size_t kLongest = 80;
  return text.size() <= kLongest ? "'" + text + "'" : "'" + text.substr(0, kLongest) + "...'";
}

std::string joined(const std::vector<std::string>& items) {
  std::string text;
  for (std::size_t i = 0; i < items.size(); ++i) {
    text += (i == 0 ? "" : i + 1 < items.size() ? ", " : " and ") + items[i];
  }
  return text;
}

}  // namespace collision_monitor
