// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "collision_monitor/model/problems.h"

namespace collision_monitor {

/// Harmless oddities of a description. Each kind becomes one warning per robot, however many
/// elements have it.
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

/// What is reported once for all elements of a description.
struct Oddities {
  std::map<Oddity, std::vector<std::string>> noted;
  /// Meshes that cannot be read, with their places, by reason. One missing package may cause
  /// dozens.
  std::map<std::string, std::vector<Problem>> unreadable;
};

/// Adds one warning for each kind of oddity, naming all elements that have it, and one error for
/// each reason why meshes cannot be read.
void reportOddities(const std::string& source, const Oddities& oddities, SetupReport& report);

/// A reader's position in a document, as messages say it:
/// "robot.urdf line 42, link 'arm', collision 2".
class Place {
 public:
  Place(std::string source, SetupReport& report, Oddities& oddities);

  /// The place of an element inside this one.
  Place within(const std::string& element) const;

  /// @param line of the document; 0: unknown
  void addError(int line, const std::string& found, const std::string& accepted) const;
  /// @param advice as in Problem
  void addWarning(int line, const std::string& found, const std::string& advice) const;
  /// Something could not be read that may have names.
  void awaitNames() const noexcept { report_->awaits_names = true; }
  bool awaitsNames() const noexcept { return report_->awaits_names; }
  /// Notes that this element has the oddity.
  void note(Oddity oddity) const;
  /// Notes that this element names a mesh that cannot be read.
  /// @param reason may begin with the name, which the message has only once
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

/// Foreign text, safe for messages and terminals: control characters become "\x1b" and the like.
/// Text that is too long is cut in the middle and its length added.
std::string legible(const std::string& text);

/// The same, in single quotes.
std::string quoted(const std::string& text);

/// "a, b and c"
std::string joined(const std::vector<std::string>& items);

/// "1 pair", "2 pairs". @param one what is counted, as one of it
std::string counted(std::size_t count, const std::string& one);

/// "a, b, c and 17 more": the first items of a list that may have a million.
std::string someOf(const std::vector<std::string>& items);

}  // namespace collision_monitor
