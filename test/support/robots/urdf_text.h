// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "collision_monitor/model/urdf_reader.h"

namespace collision_monitor::test {

/// A URDF read from text, with all messages. The text of a test starts in line 1 with <robot
/// name="r">; its parts follow in the next lines.
struct ReadText {
  RobotModel model;
  SetupReport report;

  std::vector<std::string> errors() const;
  std::vector<std::string> warnings() const;
};

/// Wraps the elements into "<robot name='r'>\n...\n</robot>".
std::string robotXml(const std::string& elements);

/// "<link name='a'><collision>...", on one line.
std::string linkXml(const std::string& name, const std::string& geometry,
                    const std::string& origin = "");

/// "<joint name='j' type='...'>...", on one line.
std::string jointXml(const std::string& name, const std::string& type, const std::string& parent,
                     const std::string& child, const std::string& rest = "");

/// A description called "test.urdf".
RobotDescription describeText(const std::string& xml);

/// Loads the content of `files` by exact name and nothing else.
ResourceLoader textLoader(const std::map<std::string, std::string>& files);

ReadText readText(const std::string& xml, const std::map<std::string, std::string>& files = {});

}  // namespace collision_monitor::test
