// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <unordered_set>
#include <vector>

#include "collision_monitor/model/srdf_reader.h"
#include "model/name_index.h"
#include "model/xml_document.h"

namespace collision_monitor {

/// Names of an SRDF that lead nowhere, in the order of the file.
class UnknownNames {
 public:
  /// Each name is told once, with the line in which it stands first.
  void add(const std::string& name, int line) {
    if (is_told_.insert(name).second) {
      names_.push_back(name + " (line " + std::to_string(line) + ")");
    }
  }
  const std::vector<std::string>& all() const { return names_; }

 private:
  std::unordered_set<std::string> is_told_;
  std::vector<std::string> names_;
};

/// Names in groups, and in elements of which no pair depends: end effectors, virtual and passive
/// joints, group states and sphere approximations.
struct UnknownOfGroups {
  UnknownNames members;
  UnknownNames others;
};

/// The groups of an SRDF below `root`; readSrdf says what they hold.
std::vector<LinkGroup> readGroups(const tinyxml2::XMLElement& root, const RobotModel& model,
                                  const NameIndex& names, UnknownOfGroups& unknown);

}  // namespace collision_monitor
