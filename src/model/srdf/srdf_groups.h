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

/// Unknown names of an SRDF, in the order of the file.
class UnknownNames {
 public:
  /// Keeps each name once, with the line where it first appears.
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

/// Unknown names in groups, and in elements that do not affect pairs: end effectors, virtual and
/// passive joints, group states and sphere approximations.
struct UnknownOfGroups {
  UnknownNames members;
  UnknownNames others;
};

/// The groups of an SRDF below `root`; readSrdf documents their contents.
std::vector<LinkGroup> readGroups(const tinyxml2::XMLElement& root, const RobotModel& model,
                                  const NameIndex& names, UnknownOfGroups& unknown);

}  // namespace collision_monitor
