// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "collision_monitor/model/problems.h"

namespace collision_monitor {

/// Harmless oddities of a description. Each kind becomes one warning a robot,
/// however many elements show it.
enum class Oddity : unsigned char {
  link_without_geometry,
  zero_size,
  mesh_without_area,
  mimic_on_fixed_joint,
  mimic_of_immovable_joint,
  mimic_of_unknown_joint,
  no_limit,
  limit_without_range,
  second_limit,
  limit_beyond_sense,
  no_speed_limit,
  other_up_axis,
};

/// What is told once for all elements of a description.
struct Oddities {
  std::map<Oddity, std::vector<std::string>> noted;
  /// By reason: meshes that cannot be read, with their places. A package that is not found has
  /// dozens.
  std::map<std::string, std::vector<Problem>> unreadable;
};

/// One warning for each kind noted, naming all elements that show it, and one error for each reason
/// why meshes cannot be read.
void reportOddities(const std::string& source, const Oddities& oddities, SetupReport& report);

/// Where a reader is in a document, in the words of messages:
/// "robot.urdf line 42, link 'arm', collision 2".
class Place {
 public:
  Place(std::string source, SetupReport& report, Oddities& oddities);

  /// The place of a part of this element.
  Place within(const std::string& element) const;

  /// @param line of the document, 0 if there is none to name
  void addError(int line, const std::string& found, const std::string& accepted) const;
  /// @param advice as in Problem
  void addWarning(int line, const std::string& found, const std::string& advice) const;
  /// This element shows the oddity.
  void note(Oddity oddity) const;
  /// This element names a mesh that cannot be read.
  /// @param reason may begin with the name, which is told once
  /// @param accepted as in Problem
  void noteUnreadable(int line, const std::string& mesh, const std::string& reason,
                      const std::string& accepted) const;

 private:
  Problem problemAt(int line, const std::string& found, const std::string& accepted) const;

  std::string source_;
  std::string element_;
  SetupReport* report_;
  Oddities* oddities_;
};

/// Text of others as messages and terminals take it: control characters as "\x1b", and cut in its
/// middle, with its length, when it is too long.
std::string legible(const std::string& text);

/// The same between single quotes.
std::string quoted(const std::string& text);

/// "a, b and c"
std::string joined(const std::vector<std::string>& items);

/// "a, b, c and 17 more": the first of the items, of which there may be a million.
std::string someOf(const std::vector<std::string>& items);

}  // namespace collision_monitor
