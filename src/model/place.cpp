// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/place.h"

#include <utility>

#include "model/visible_text.h"

namespace collision_monitor {
namespace {

struct OddityText {
  const char* found;
  const char* advice;
};

OddityText textOf(Oddity oddity) {
  switch (oddity) {
    case Oddity::link_without_geometry:
      return {"links without collision geometry", "nothing is checked of them"};
    case Oddity::zero_size:
      return {"a size of 0", "they are taken as the points, lines or faces that they are"};
    case Oddity::mesh_without_area:
      return {"meshes without area", "they are taken as the lines and points that they are"};
    case Oddity::mimic_on_fixed_joint:
      return {"<mimic> on a fixed joint", "it is ignored"};
    case Oddity::mimic_of_immovable_joint:
      return {"<mimic> of a fixed joint", "they are taken to move by themselves"};
    case Oddity::mimic_of_unknown_joint:
      return {"<mimic> of a joint that the robot lacks", "they are taken to move by themselves"};
    case Oddity::no_limit:
      return {"joints without <limit>", "they are taken as unlimited"};
    case Oddity::limit_without_range:
      return {"<limit> without lower and upper",
              "both are 0 then, as the URDF format has it, and the joint is locked"};
    case Oddity::second_limit:
      return {"several <limit> of one joint", "the first counts"};
    case Oddity::limit_beyond_sense:
      return {"limits beyond 1e9", "they are taken as unlimited"};
    case Oddity::no_speed_limit:
      return {"velocity limits of 0 or less", "they are taken as unlimited"};
    case Oddity::other_up_axis:
      return {"meshes that declare another up axis than z",
              "they are not turned, as in rviz and MoveIt; parameter obey_up_axis turns them"};
  }
  return {"", ""};
}

std::string listOf(const std::vector<std::string>& elements) {
  constexpr std::size_t kShown = 12;
  std::string text;
  for (std::size_t i = 0; i < elements.size() && i < kShown; ++i) {
    text += (text.empty() ? "" : "; ") + elements[i];
  }
  return elements.size() <= kShown
             ? text
             : text + "; and " + std::to_string(elements.size() - kShown) + " more";
}

/// "cannot be read" of "'a.stl' cannot be read", "no triangles" of "a.stl: no triangles".
std::string withoutName(const std::string& reason, const std::string& name) {
  for (const std::string& start : {name + ": ", "'" + name + "' "}) {
    if (reason.rfind(start, 0) == 0) {
      return reason.substr(start.size());
    }
  }
  return reason;
}

/// @param meshes `found` is the quoted name of each
Problem unreadable(const std::string& source, const std::string& reason,
                   const std::vector<Problem>& meshes) {
  const std::string& accepted = meshes.front().accepted;
  if (meshes.size() == 1) {
    return {meshes.front().where, "mesh " + meshes.front().found + ": " + reason, accepted};
  }
  std::vector<std::string> names;
  for (const Problem& mesh : meshes) {
    const bool is_inside = mesh.where.rfind(source, 0) == 0;
    names.push_back(mesh.found + " in" +
                    (is_inside ? mesh.where.substr(source.size()) : " " + mesh.where));
  }
  return {source, std::to_string(meshes.size()) + " meshes: " + reason + ": " + listOf(names),
          accepted};
}

/// Whether `c` is a continuation byte of UTF-8. Messages must not be cut before one.
bool isInsideLetter(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

}  // namespace

void reportOddities(const std::string& source, const Oddities& oddities, SetupReport& report) {
  for (const auto& [oddity, elements] : oddities.noted) {
    const OddityText text = textOf(oddity);
    report.warnings.push_back({source, text.found + (": " + listOf(elements)), "", text.advice});
  }
  for (const auto& [reason, meshes] : oddities.unreadable) {
    report.errors.push_back(unreadable(source, reason, meshes));
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

void Place::addWarning(int line, const std::string& found, const std::string& advice) const {
  Problem problem = problemAt(line, found, "");
  problem.advice = advice;
  report_->warnings.push_back(std::move(problem));
}

void Place::note(Oddity oddity) const { oddities_->noted[oddity].push_back(element_); }

void Place::noteUnreadable(int line, const std::string& mesh, const std::string& reason,
                           const std::string& accepted) const {
  oddities_->unreadable[withoutName(reason, mesh)].push_back(
      problemAt(line, quoted(mesh), accepted));
}

Problem Place::problemAt(int line, const std::string& found, const std::string& accepted) const {
  std::string where = source_;
  if (line > 0) {
    where += " line " + std::to_string(line);
  }
  if (!element_.empty()) {
    where += ", " + element_;
  }
  return {where, found, accepted, ""};
}

std::string quoted(const std::string& text) { return "'" + legible(text) + "'"; }

std::string legible(const std::string& text) {
  // The end of a long file name matters most.
  constexpr std::size_t kLongest = 160;
  constexpr std::size_t kHead = 60;
  constexpr std::size_t kTail = 90;
  if (text.size() <= kLongest) {
    return visibleText(text);
  }
  std::size_t head = kHead;
  while (head > 0 && isInsideLetter(text[head])) {
    --head;
  }
  std::size_t tail = text.size() - kTail;
  while (tail < text.size() && isInsideLetter(text[tail])) {
    ++tail;
  }
  return visibleText(text.substr(0, head)) + "[... of " + std::to_string(text.size()) +
         " bytes ...]" + visibleText(text.substr(tail));
}

std::string counted(std::size_t count, const std::string& one) {
  return std::to_string(count) + " " + one + (count == 1 ? "" : "s");
}

std::string someOf(const std::vector<std::string>& items) {
  constexpr std::size_t kShown = 12;
  if (items.size() <= kShown) {
    return joined(items);
  }
  std::vector<std::string> shown(items.begin(), items.begin() + kShown);
  shown.push_back(std::to_string(items.size() - kShown) + " more");
  return joined(shown);
}

std::string joined(const std::vector<std::string>& items) {
  std::string text;
  for (std::size_t i = 0; i < items.size(); ++i) {
    text += (i == 0 ? "" : i + 1 < items.size() ? ", " : " and ") + items[i];
  }
  return text;
}

}  // namespace collision_monitor
